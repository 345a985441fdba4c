// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/openable.h"

#include "core/base/failure.h"
#include "core/project/project.h"
#include "core/project/project_files.h"
#include "core/session/open_input.h"

namespace relievo {
namespace {

void openOnce(const std::filesystem::path& file, const Task& task) {
  if (file.extension() == ".json") {
    const Project project = readProject(file);
    openInput(foundInput(file, project.file, project.sha256, task), {}, task);
    return;
  }
  const InputFacts facts = inputFacts(file, task);
  if (facts.host_file == HostFileKind::none) openInput(file, {.facts = facts}, task);
}

}  // namespace

std::optional<Message> openingRefusal(const std::filesystem::path& file, const Task& task) {
  try {
    openOnce(file, task);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    return messageOf(error);
  }
  return std::nullopt;
}

}  // namespace relievo
