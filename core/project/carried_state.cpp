// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/carried_state.h"

#include <filesystem>

#include "core/base/error.h"
#include "core/provenance/provenance.h"

namespace relievo {

bool isProject(std::string_view state) {
  const std::size_t first = state.find_first_not_of(" \t\r\n{");
  return first != std::string_view::npos && state.substr(first).starts_with("\"relievo_project\"");
}

Project projectFromState(std::string_view state, const std::string& source) {
  if (isProject(state)) return projectFromJson(state, source);
  const Provenance made = provenanceFromJson(state, source);
  if (!made.view) {
    throw FileError(source +
                    " shows no region, so that there is no view to restore. Nothing was changed. "
                    "Choose a picture or a log.");
  }
  Project project;
  project.file = made.input.file;
  project.sha256 = made.input.sha256;
  project.options = made.options;
  project.region = made.view->region;
  project.gain = made.view->gain;
  project.look = project.figure.look = made.view->look;
  project.stereo = made.view->stereo;
  return project;
}

}  // namespace relievo
