// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/host_answers.h"

#include <algorithm>
#include <charconv>

#include "core/base/failure.h"
#include "haptics/device/foreign/relievo_device.h"

namespace relievo::foreign {

namespace {
std::vector<std::string> parts(std::string_view text, char separator) {
  std::vector<std::string> all;
  while (true) {
    const std::size_t end = text.find(separator);
    all.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return all;
    text.remove_prefix(end + 1);
  }
}

int numberOf(const std::string& text) {
  int value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Without what a terminal would take for a command.
std::string shown(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }, ' ');
  return text;
}

/// Of one that did not begin.
Message whyNotBegun(int number, const std::string& text) {
  constexpr std::string_view kBetween = ": ";
  const std::size_t end = text.find(kBetween);
  if (number == RELIEVO_NO_LIBRARY && end != std::string::npos) {
    return said<MessageId::device_library_missing>(text.substr(0, end),
                                                   text.substr(end + kBetween.size()));
  }
  return text.empty() ? said<MessageId::device_plugin_not_begun>(number)
                      : said<MessageId::device_plugin_refuses>(text);
}

bool isId(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
  });
}
}  // namespace

Message messageOf(HostTrouble trouble, int number, const std::string& text) {
  switch (trouble) {
    case HostTrouble::not_loaded:
      return said<MessageId::device_plugin_not_loaded>(text);
    case HostTrouble::no_entry:
      return said<MessageId::device_plugin_no_entry>();
    case HostTrouble::version:
      return said<MessageId::device_plugin_version>(number, RELIEVO_DEVICE_ABI_MAJOR);
    case HostTrouble::incomplete:
      return said<MessageId::device_plugin_incomplete>();
    case HostTrouble::no_device:
      return said<MessageId::device_plugin_no_device>();
    case HostTrouble::refuses:
      return said<MessageId::device_plugin_refuses>(text.empty() ? std::to_string(number) : text);
    case HostTrouble::limits:
      return said<MessageId::device_plugin_limits>();
    default:
      break;
  }
  return whyNotBegun(number, text);
}

ScannedPlugin pluginOf(std::string_view answer) {
  ScannedPlugin plugin;
  bool told = false;
  for (const std::string& line : parts(answer, '\n')) {
    const std::vector<std::string> words = parts(line, '\t');
    if (words[0] == "trouble" && words.size() == 4) {
      const int trouble = numberOf(words[1]);
      const bool known = trouble > 0 && trouble < static_cast<int>(HostTrouble::count);
      plugin.trouble = messageOf(known ? static_cast<HostTrouble>(trouble) : HostTrouble::not_begun,
                                 numberOf(words[2]), shown(words[3]));
    } else if (words[0] == "plugin" && words.size() == 5) {
      told = true;
      plugin.name = shown(words[1]);
      plugin.version = shown(words[2]);
      plugin.maker = shown(words[3]);
      plugin.licence = shown(words[4]);
    } else if (words[0] == "device" && words.size() == 3 && isId(words[1])) {
      plugin.devices.push_back({words[1], shown(words[2])});
    }
  }
  if (!told && !plugin.trouble) plugin.trouble = said<MessageId::device_host_ended>();
  return plugin;
}

CheckResult resultOf(const Check& check, std::string_view answer) {
  const std::vector<std::string> words = parts(parts(answer, '\n').front(), '\t');
  if (words.size() != 2) return {check, Verdict::failed, "its process ended"};
  if (words[0] == "passed") return {check, Verdict::passed, {}};
  return {check, words[0] == "skipped" ? Verdict::skipped : Verdict::failed, shown(words[1])};
}

}  // namespace relievo::foreign
