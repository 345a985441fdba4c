// SPDX-License-Identifier: BSD-3-Clause
#include "app/options.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/io/formats/lines.h"

namespace relievo {
namespace {

constexpr double kLargestNumber = 1e9;  // mm; farther than any scan.
constexpr int kMostDetails = 64;

[[noreturn]] void refuse(const std::string& what) {
  throw ArgumentError(what + " See relievo --help.");
}

double number(const std::string& option, std::string_view text) {
  const auto value = parseNumber(text);
  if (value && std::abs(*value) <= kLargestNumber) return *value;  // Not a number fails as well.
  refuse(option + " needs a number from -1e9 to 1e9, not '" + std::string(text) + "'.");
}

RectMm rectangle(const std::string& option, std::string_view text) {
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == values.size())) {
      refuse(option + " needs four numbers: X,Y,W,H in millimetres.");
    }
    values[i] = number(option, text.substr(0, comma));
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

void refuseWhatDoesNotGoTogether(const WindowOptions& options) {
  if (!options.exhibit.empty() && (!options.files.empty() || options.saysHow() ||
                                   !options.language.empty() || options.safe_mode)) {
    refuse("--exhibit says itself what is shown and how; give no other file or option with it.");
  }
  if (options.files.size() > 1 && options.saysHow()) {
    refuse("--unit, --view, --detail and --region belong to one file; several are joined first.");
  }
}

}  // namespace

WindowOptions parseWindowOptions(const std::vector<std::string>& arguments) {
  WindowOptions options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    std::string option = arguments[i];
    if (option == "--") {  // From here on all are files, whatever they begin with.
      options.only_files = true;
      options.files.insert(options.files.end(),
                           arguments.begin() + static_cast<std::ptrdiff_t>(i) + 1, arguments.end());
      break;
    }
    if (option.empty() || option.front() != '-') {
      options.files.push_back(option);
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
    } else if (option == "--libraries") {
      options.libraries = true;
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
    } else if (option == "--exhibit") {
      options.exhibit = value();
      if (options.exhibit.empty()) refuse("--exhibit needs the file of an exhibit.");
    } else if (option == "--detail") {
      const double detail = number(option, value());
      if (detail < 1 || detail > kMostDetails || detail != std::floor(detail)) {
        refuse("--detail counts from 1, the whole object, to 64.");
      }
      options.detail = static_cast<int>(detail);
    } else if (option == "--region") {
      options.region = rectangle(option, value());
    } else {
      refuse("There is no option '" + option + "'.");
    }
  }
  refuseWhatDoesNotGoTogether(options);
  return options;
}

const std::vector<WindowOptionRow>& windowOptionRows() {
  static const std::vector<WindowOptionRow> kRows{
      {{"--unit"}, "mm|cm|m|in|ft|us-ft", "length unit of the file's coordinates"},
      {{"--view"}, "front|back|left|right|top|bottom|auto", "direction of the view"},
      {{"--detail"}, "N", "first resolution; 1 is the whole object"},
      {{"--region"}, "X,Y,W,H", "first window, millimetres from the lower left corner"},
      {{"--lang"}, "en|de|hi", "language of the window"},
      {{"--exhibit"}, "FILE", "for visitors: full screen and locked, as the file says"},
      {{"--safe-mode"}, "", "ignore and keep no settings"},
      {{"--version"}, "", "print the version and the commit it was built from"},
      {{"--libraries"}, "", "print the same with the libraries it runs with"},
      {{"-h", "--help"}, "", "print this help"},
      {{"--"}, "", "what follows are files, whatever they begin with"}};
  return kRows;
}

std::string windowHelp() {
  std::string text =
      "relievo [FILE]   opens the window; VERB ... works without one (relievo VERB --help)\n"
      "relievo FILE...  several scans of one object, or a folder of them: to be joined\n"
      "relievo ADDRESS  a map that was published on the web\n"
      "\n";
  constexpr std::size_t kColumn = 48;
  for (const WindowOptionRow& row : windowOptionRows()) {
    std::string line = "  ";
    for (const std::string& name : row.names) line += (line.size() > 2 ? ", " : "") + name;
    if (!row.value.empty()) line += " " + row.value;
    line.resize(std::max(line.size() + 1, kColumn), ' ');
    text += line + row.help + "\n";
  }
  return text;
}

}  // namespace relievo
