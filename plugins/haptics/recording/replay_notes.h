// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/session/firmness.h"
#include "haptics/record/recorded_loop.h"

namespace relievo {

/// What a surface is made of besides its window.
struct SceneMaps {
  std::vector<float> finer_mm;  ///< See fillTexture(); empty: no texture.
  std::vector<float> firmness;  ///< See fill(); empty: the window's origins say where it is firm.
  // For recordings.
  std::shared_ptr<const FirmnessMap> firmness_from;  ///< Null: as an empty `firmness`.
  std::string map_state;                             ///< Host::mapState().
};

/// What a replay needs besides the samples: surfaces and settings of a session. While nothing is
/// recorded only those are kept that the loop may still work with. [GUI thread]
class ReplayNotes {
 public:
  /// A surface that the loop was given. @param recording  whether one runs
  void addScene(RecordedScene scene, const SceneMaps& maps, bool recording);
  /// Settings that it was given, as optionsLine() writes them.
  void addOptions(std::string line, bool recording);
  /// What the hand may be led along, as guideLine() writes it.
  void addPath(std::string line, bool recording);
  /// Lines for the end of a recording in a folder, from which files are named.
  std::string lines(const std::filesystem::path& folder) const;

 private:
  std::vector<RecordedScene> scenes_;
  std::vector<std::string> options_lines_, guide_lines_;
  std::map<std::string, std::string> firmness_files_;  // By SHA-256.
  std::vector<std::string> map_states_;                // Map 1 is the first.
};

}  // namespace relievo
