// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/recording/replay_notes.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <system_error>
#include <utility>

namespace relievo {

namespace {
/// How a file is found from a folder; recordings and rasters may be moved together.
std::string foundFrom(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path relative = std::filesystem::relative(file, folder, error);
  return (error || relative.empty() ? file : relative).generic_string();
}
}  // namespace

void ReplayNotes::addScene(RecordedScene scene, const SceneMaps& maps, bool recording) {
  if (maps.firmness_from) {
    scene.firmness = maps.firmness_from->sha256;
    firmness_files_[scene.firmness] = maps.firmness_from->file;
  }
  if (!maps.map_state.empty()) {
    const auto known = std::find(map_states_.begin(), map_states_.end(), maps.map_state);
    scene.map = static_cast<std::uint64_t>(known - map_states_.begin()) + 1;
    if (known == map_states_.end()) map_states_.push_back(maps.map_state);
  }
  constexpr std::size_t kScenesInUse = 4;  // Of the loop, its change, the mailbox and this one.
  if (!recording && scenes_.size() >= kScenesInUse) scenes_.erase(scenes_.begin());
  scenes_.push_back(std::move(scene));
}

void ReplayNotes::addOptions(std::string line, bool recording) {
  constexpr std::size_t kOptionsInUse = 3;  // The loop may still work with the last but one.
  if (!recording && options_lines_.size() >= kOptionsInUse) {
    options_lines_.erase(options_lines_.begin());
  }
  options_lines_.push_back(std::move(line));
}

// A recording may begin while the hand is led.
void ReplayNotes::addPath(std::string line, bool recording) {
  if (!recording) guide_lines_.clear();
  guide_lines_.push_back(std::move(line));
}

std::string ReplayNotes::lines(const std::filesystem::path& folder) const {
  std::string lines;
  std::set<std::uint64_t> maps;
  std::set<std::string> rasters;
  for (const RecordedScene& scene : scenes_) {
    lines += sceneLine(scene);
    const bool new_map = scene.map > 0 && maps.insert(scene.map).second;
    if (new_map) lines += mapLine(scene.map, map_states_[scene.map - 1]);
    const bool new_raster = !scene.firmness.empty() && rasters.insert(scene.firmness).second;
    if (!new_raster) continue;
    lines += firmnessLine(scene.firmness, foundFrom(folder, firmness_files_.at(scene.firmness)));
  }
  for (const std::string& line : options_lines_) lines += line;
  for (const std::string& line : guide_lines_) lines += line;
  return lines;
}

}  // namespace relievo
