// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/settings_file.h"

#include <array>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "haptics/device/falcon/firmware.h"

namespace relievo::falcon {

namespace fs = std::filesystem;

fs::path settingsFile() {
  const char* config = std::getenv("XDG_CONFIG_HOME");  // NOLINT(concurrency-mt-unsafe)
  if (config != nullptr && config[0] == '/') return fs::path(config) / "relievo/falcon.conf";
  const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe)
  return fs::path(home == nullptr ? "/" : home) / ".config/relievo/falcon.conf";
}

namespace {
struct Line {
  std::string name, text;
};

std::vector<Line> linesOf(const fs::path& file) {
  std::vector<Line> lines;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t space = line.find(' ');
    if (space != std::string::npos)
      lines.push_back({line.substr(0, space), line.substr(space + 1)});
  }
  return lines;
}

std::string textOf(double value) {
  std::array<char, 32> number{};
  return {number.data(), std::to_chars(number.data(), number.data() + number.size(), value).ptr};
}

/// What a calibration finds of one Falcon.
void takeOwn(const std::string& name, double value, FalconSettings& settings) {
  if (name == "counts_per_n_mm" && value >= kLeastCountsPerNmm && value <= kMostCountsPerNmm) {
    settings.counts_per_n_mm = value;
  }
  if (name == "grip_weight_n" && value >= 0 && value <= kMostGripN) settings.grip_weight_n = value;
}
}  // namespace

FalconSettings readSettings(const fs::path& file, const std::string& serial) {
  FalconSettings settings;
  const std::vector<Line> lines = linesOf(file);
  for (const bool own : {false, true}) {
    const std::string mark = own && !serial.empty() ? "@" + serial : std::string();
    for (const Line& line : lines) {
      const std::string& text = line.text;
      if (line.name == "firmware") settings.firmware = text;
      double value = 0;  // from_chars: a locale may write numbers with a comma.
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc() || end != text.data() + text.size()) continue;
      for (const std::string name : {"counts_per_n_mm", "grip_weight_n"}) {
        if (line.name == name + mark) takeOwn(name, value, settings);
      }
      if (line.name == "left_handed") settings.left_handed = value == 1;
    }
  }
  return settings;
}

void writeSettings(const FalconSettings& settings, const fs::path& file,
                   const std::string& serial) {
  const auto refuse = [&file] { throw failure<MessageId::falcon_settings_not_written>(file); };
  const std::string mark = serial.empty() ? std::string() : "@" + serial;
  std::vector<Line> lines{{"counts_per_n_mm" + mark, textOf(settings.counts_per_n_mm)},
                          {"grip_weight_n" + mark, textOf(settings.grip_weight_n)},
                          {"left_handed", settings.left_handed ? "1" : "0"}};
  for (Line& kept : linesOf(file)) {
    const bool others =
        kept.name.starts_with("counts_per_n_mm") || kept.name.starts_with("grip_weight_n");
    if (others && kept.name != lines[0].name && kept.name != lines[1].name) {
      lines.push_back(std::move(kept));
    }
  }
  if (!settings.firmware.empty()) lines.push_back({"firmware", settings.firmware});
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  try {
    AtomicFile written(file);
    for (const Line& line : lines) written.write(line.name + ' ' + line.text + '\n');
    written.commit();
  } catch (const WriteError&) {
    refuse();
  }
}

FirmwareSource storedFirmwareSource() {
  return [] { return firmwareSource(readSettings(settingsFile()).firmware)(); };
}

}  // namespace relievo::falcon
