// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/dependencies.h"

#include <set>
#include <string>

#include "app/cli/json.h"
#include "app/cli/state.h"
#include "app/cli/verbs/replay_command.h"
#include "core/io/web/web_link.h"
#include "core/project/embedded_state.h"
#include "core/recording/log_table.h"
#include "core/tiles/tiled_map.h"
#include "haptics/record/recorded_loop.h"

namespace relievo::batch {
namespace {

namespace fs = std::filesystem;

InputFile atPlace(const fs::path& recording, const fs::path& named, const std::string& sha256,
                  const Task& task) {
  return {.file = foundInput(recording, named, sha256, task).generic_string(), .sha256 = sha256};
}

void addScan(std::vector<InputFile>& all, const fs::path& recording, const Project& scan,
             const Task& task) {
  if (isWebAddress(scan.file)) return;  // Only what was looked at of it is here.
  all.push_back(atPlace(recording, scan.file, scan.sha256, task));
  if (!TiledMap::isOne(all.back().file)) return;
  for (const fs::path& level : TiledMap(all.back().file).otherFiles()) {
    all.push_back({.file = level.generic_string(), .sha256 = sha256OfFile(level, task)});
  }
}

}  // namespace

std::vector<InputFile> dependenciesOf(const fs::path& recording, bool scans, const Task& task) {
  const LogTable log = readLog(recording, LogUse::plot, task);
  std::vector<InputFile> all;
  const RecordedFiles files = recordedFiles(log.footer);
  const fs::path folder = fs::absolute(recording).parent_path();
  for (const auto& [sha256, file] : files.firmness) {
    all.push_back(atPlace(recording, (folder / file).lexically_normal(), sha256, task));
  }
  if (const auto raster = firmnessOfCommand(log)) {
    all.push_back(atPlace(recording, raster->file, raster->sha256, task));
  }
  if (!scans) return all;
  std::set<std::string> known;
  for (const auto& [map, state] : files.maps) {
    const auto scan = embeddedProject(recording, state);
    if (scan && known.insert(scan->sha256).second) addScan(all, recording, *scan, task);
  }
  return all;
}

}  // namespace relievo::batch
