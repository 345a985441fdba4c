// SPDX-License-Identifier: BSD-3-Clause
// States that come back from projects and pictures.
#include "app/batch/state.h"
#include "app/batch/verb.h"
#include "core/base/error.h"
#include "core/project/carried_state.h"
#include "ui/figure/file_hash.h"

namespace relievo::batch {

Stored loadStored(const Project& project, const Task& task) {
  Stored stored{.surface = {}, .project = project};
  const std::string sha256 = sha256Of(project.file, task);
  if (!sha256.empty() && !project.sha256.empty() && sha256 != project.sha256) {
    tell("'" + project.file +
         "' has changed since (checksum differs). It is drawn as it is now. (E501)");
    stored.project.sha256 = sha256;  // What is drawn now comes from these bytes.
    stored.input_changed = true;
  }
  stored.surface = loadForVerb(project.file, project.options, ImportOptions{}, task);
  // A region typed for one version of the file may not exist on another.
  if (project.region.level.value >= stored.surface.ladder.levels()) {
    throw FileError("The map of '" + project.file + "' has no level " +
                    std::to_string(project.region.level.value) + ". Nothing was drawn.");
  }
  return stored;
}

Stored loadFromImage(const std::string& picture, const Task& task) {
  const auto state = carriedState(picture);
  if (!state) {
    throw FileError("'" + picture + "' does not carry a state of relievo. Nothing was drawn.");
  }
  Project project = projectFromState(*state, std::filesystem::path(picture).filename().string());
  std::error_code error;
  const auto folder = std::filesystem::absolute(picture, error).parent_path();
  project.file = (folder / project.file).lexically_normal().string();
  return loadStored(project, task);
}

}  // namespace relievo::batch
