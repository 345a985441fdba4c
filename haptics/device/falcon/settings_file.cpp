// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/settings_file.h"

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/base/error.h"
#include "haptics/device/falcon/firmware.h"

namespace relievo::falcon {

namespace fs = std::filesystem;

fs::path settingsFile() {
  const char* config = std::getenv("XDG_CONFIG_HOME");  // NOLINT(concurrency-mt-unsafe)
  if (config != nullptr && config[0] == '/') return fs::path(config) / "relievo/falcon.conf";
  const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe)
  return fs::path(home == nullptr ? "/" : home) / ".config/relievo/falcon.conf";
}

FalconSettings readSettings(const fs::path& file) {
  FalconSettings settings;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t space = line.find(' ');
    if (space == std::string::npos) continue;
    const std::string name = line.substr(0, space), text = line.substr(space + 1);
    if (name == "firmware") settings.firmware = text;
    double value = 0;  // from_chars: a locale may write numbers with a comma.
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) continue;
    if (name == "counts_per_n_mm" && value >= kLeastCountsPerNmm && value <= kMostCountsPerNmm) {
      settings.counts_per_n_mm = value;
    }
    if (name == "left_handed") settings.left_handed = value == 1;
  }
  return settings;
}

void writeSettings(const FalconSettings& settings, const fs::path& file) {
  const auto refuse = [&file] {
    throw WriteError("The Falcon's settings could not be written to \"" + file.string() +
                     "\". They hold until the program ends. Check the folder's permissions.");
  };
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  std::array<char, 32> number{};
  const auto end =
      std::to_chars(number.data(), number.data() + number.size(), settings.counts_per_n_mm).ptr;
  const fs::path part = file.string() + ".part";
  std::ofstream stream(part, std::ios::trunc);
  stream << "counts_per_n_mm " << std::string(number.data(), end) << "\nleft_handed "
         << (settings.left_handed ? 1 : 0) << '\n';
  if (!settings.firmware.empty()) stream << "firmware " << settings.firmware << '\n';
  stream.close();
  if (!stream) refuse();
  fs::rename(part, file, error);
  if (error) refuse();
}

FirmwareSource storedFirmwareSource() {
  return [] { return firmwareSource(readSettings(settingsFile()).firmware)(); };
}

}  // namespace relievo::falcon
