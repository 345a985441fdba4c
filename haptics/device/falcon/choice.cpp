// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/choice.h"

#include <algorithm>
#include <vector>

namespace relievo::falcon {

namespace {
constexpr std::string_view kKind = "falcon";
constexpr std::string_view kFirst = "0";  // As settings of earlier versions name the only one.

bool isMeant(const FalconChoice& choice, const SeenFalcon& falcon) {
  return (choice.serial.empty() || choice.serial == falcon.serial) &&
         (choice.port.empty() || choice.port == falcon.port);
}

/// "A1 (USB 1-2)".
std::string words(const FalconChoice& choice) {
  if (choice.port.empty()) return choice.serial;
  return choice.serial + (choice.serial.empty() ? "" : " ") + "(USB " + choice.port + ")";
}
}  // namespace

std::optional<FalconChoice> falconChoice(std::string_view id) {
  if (id == kKind) return FalconChoice{};
  if (!id.starts_with(kKind) || id.size() < kKind.size() + 2 || id[kKind.size()] != ':') {
    return std::nullopt;
  }
  id.remove_prefix(kKind.size() + 1);
  if (id == kFirst) return FalconChoice{};
  const std::size_t at = id.rfind('@');  // A port has none.
  if (at == std::string_view::npos) return FalconChoice{std::string(id), {}};
  if (at + 1 == id.size()) return std::nullopt;
  return FalconChoice{std::string(id.substr(0, at)), std::string(id.substr(at + 1))};
}

std::string idOf(const FalconChoice& choice) {
  std::string id(kKind);
  if (choice.any()) return id;
  id += ":" + choice.serial;
  return choice.port.empty() ? id : id + "@" + choice.port;
}

std::string nameOf(const FalconChoice& choice) {
  return choice.any() ? "Falcon" : "Falcon " + words(choice);
}

FalconChoice shortestChoice(const SeenFalcon& falcon, std::span<const SeenFalcon> seen) {
  const auto same = std::count_if(seen.begin(), seen.end(), [&](const SeenFalcon& other) {
    return other.serial == falcon.serial;
  });
  // Also where the serial number alone would be read as something else.
  const bool clear = same <= 1 && !falcon.serial.empty() && falcon.serial != kFirst &&
                     falcon.serial.find('@') == std::string::npos;
  return {falcon.serial, clear ? std::string() : falcon.port};
}

FalconSearch::Found FalconSearch::among(std::span<const SeenFalcon> seen) const {
  Found found;
  std::vector<const SeenFalcon*> meant;
  std::vector<std::string> names;  // In their own order: the bus lists them as it likes.
  for (const SeenFalcon& falcon : seen) {
    if (isMeant(choice_, falcon)) meant.push_back(&falcon);
    names.push_back(words({falcon.serial, falcon.port}));
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) found.others += (found.others.empty() ? "" : ", ") + name;
  found.several = meant.size() > 1;
  if (meant.size() != 1) return found;
  found.falcon = meant.front();
  found.others.clear();
  return found;
}

void FalconSearch::keep(const SeenFalcon& falcon) {
  if (!choice_.any()) return;
  choice_.serial = falcon.serial;
  if (falcon.serial.empty()) choice_.port = falcon.port;
}

}  // namespace relievo::falcon
