// SPDX-License-Identifier: BSD-3-Clause
#include "app/options.h"

#include <array>
#include <charconv>

#include "core/base/error.h"

namespace relievo {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw ArgumentError(what + " See relievo --help.");
}

template <class Number>
Number number(const std::string& option, std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    refuse(option + " needs a number, not '" + std::string(text) + "'.");
  }
  return value;
}

RectMm rectangle(const std::string& option, std::string_view text) {
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == values.size())) {
      refuse(option + " needs four numbers: X,Y,W,H in millimetres.");
    }
    values[i] = number<double>(option, text.substr(0, comma));
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  return {values[0], values[1], values[2], values[3]};
}

ViewChoice view(const std::string& name) {
  if (name != "auto" && !standardRotation(name)) {
    refuse("There is no view '" + name +
           "'; known are front, back, left, right, top, bottom, auto.");
  }
  return {name, {}};
}

}  // namespace

WindowOptions parseWindowOptions(const std::vector<std::string>& arguments) {
  WindowOptions options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    std::string option = arguments[i];
    if (option.empty() || option.front() != '-') {
      if (!options.file.empty()) refuse("Only one file can be open; '" + option + "' is a second.");
      options.file = option;
      continue;
    }
    std::optional<std::string> attached;
    if (const std::size_t equals = option.find('='); equals != std::string::npos) {
      attached = option.substr(equals + 1);
      option.resize(equals);
    }
    const auto value = [&]() -> std::string {
      if (attached) return *attached;
      if (i + 1 >= arguments.size()) refuse(option + " needs a value.");
      return arguments[++i];
    };
    if (option == "--help" || option == "-h") {
      options.help = true;
    } else if (option == "--version") {
      options.version = true;
    } else if (option == "--safe-mode") {
      options.safe_mode = true;
    } else if (option == "--unit") {
      const std::string name = value();
      options.unit = lengthUnit(name);
      if (!options.unit)
        refuse("There is no unit '" + name + "'; known are mm, cm, m, in, ft, us-ft.");
    } else if (option == "--view") {
      options.view = view(value());
    } else if (option == "--lang") {
      options.language = value();
    } else if (option == "--detail") {
      options.detail = number<int>(option, value());
      if (*options.detail < 1) refuse("--detail counts from 1, the whole object.");
    } else if (option == "--region") {
      options.region = rectangle(option, value());
    } else {
      refuse("There is no option '" + option + "'.");
    }
  }
  return options;
}

std::string windowHelp() {
  return "relievo [FILE]   opens the window; VERB ... works without one (relievo VERB --help)\n"
         "\n"
         "  --unit mm|cm|m|in|ft|us-ft   length unit of the file's coordinates\n"
         "  --view NAME                  front, back, left, right, top, bottom or auto\n"
         "  --detail N                   first detail; 1 is the whole object\n"
         "  --region X,Y,W,H             first window, millimetres from the lower left corner\n"
         "  --lang xx                    language of the window: en, de, hi\n"
         "  --safe-mode                  ignore and keep no settings\n"
         "  --version, --help\n";
}

}  // namespace relievo
