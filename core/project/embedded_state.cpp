// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/embedded_state.h"

#include "core/io/input_facts.h"
#include "core/provenance/embedded.h"
#include "core/provenance/prepared_state.h"
#include "core/provenance/provenance.h"
#include "core/recording/log_table.h"

namespace relievo {
namespace {

/// Told by the first key, which in what we write names the kind.
bool isProject(std::string_view state) {
  const std::size_t first = state.find_first_not_of(" \t\r\n{");
  return first != std::string_view::npos && state.substr(first).starts_with("\"relievo_project\"");
}

}  // namespace

std::optional<Project> projectFromState(std::string_view state, const std::string& source) {
  if (isProject(state)) return projectFromJson(state, source);
  if (isPreparedState(state)) return std::nullopt;  // A cloud shows no view.
  const Provenance made = provenanceFromJson(state, source);
  if (!made.view) return std::nullopt;
  Project project;
  project.version = made.version;
  project.file = made.input.file;
  project.sha256 = made.input.sha256;
  project.bytes = made.input.bytes;
  project.accept_incomplete = made.accept_incomplete;
  project.scan = made.scan;
  project.options = made.options;
  setView(project, *made.view);
  project.picture = made.picture;
  project.figure.look = made.view->look;
  return project;
}

std::optional<std::string> embeddedStateOf(const std::filesystem::path& host_file) {
  return inputFacts(host_file).is_hdf5 ? hdf5State(host_file) : embeddedState(host_file);
}

std::optional<Project> embeddedProject(const std::filesystem::path& host_file) {
  const InputFacts facts = inputFacts(host_file);
  if (facts.host_file == HostFileKind::project) return readProject(host_file);
  const auto state = facts.is_hdf5 ? hdf5State(host_file) : embeddedState(host_file);
  return state ? embeddedProject(host_file, *state) : std::nullopt;
}

std::optional<Project> embeddedProject(const std::filesystem::path& host_file,
                                       std::string_view state) {
  auto project = projectFromState(state, host_file.filename().string());
  if (!project) return std::nullopt;
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(host_file, error).parent_path();
  project->file = namedFrom(folder, project->file);
  return project;
}

}  // namespace relievo
