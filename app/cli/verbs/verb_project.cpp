// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <CLI/CLI.hpp>

#include "app/cli/dependencies.h"
#include "app/cli/json.h"
#include "app/cli/report_text.h"
#include "app/cli/state.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/project/embedded_state.h"
#include "core/project/package.h"
#include "core/project/project.h"
#include "core/project/project_files.h"

namespace relievo::batch {
namespace {

namespace fs = std::filesystem;

struct ProjectArguments {
  std::string action, file, out, to, search;
  std::vector<std::string> figures, recordings;
  bool without_input = false;
};

constexpr std::array<const char*, 3> kFileStates{"as before", "missing", "changed"};

Json checkJson(const std::vector<FileCheck>& checks) {
  Json files = Json::array();
  for (const FileCheck& check : checks) {
    files.push_back({{"file", check.file.file},
                     {"sha256", check.file.sha256},
                     {"state", kFileStates.at(static_cast<std::size_t>(check.state))}});
  }
  return files;
}

bool allAsBefore(const std::vector<FileCheck>& checks) {
  return std::all_of(checks.begin(), checks.end(),
                     [](const FileCheck& check) { return check.state == FileState::as_before; });
}

std::vector<std::string> namesOf(const auto& list) {
  std::vector<std::string> names;
  names.reserve(list.size());
  for (const auto& entry : list) names.push_back(entry.name);
  return names;
}

/// A project from a picture, figure or log of ours: what it shows, and logs as recordings.
CommandResult makeNew(const ProjectArguments& a, const Task& task) {
  if (a.out.empty()) throw failure<MessageId::project_new_needs_name>();
  auto carried = embeddedProject(a.file);
  const std::string shown = fs::path(a.file).filename().string();
  if (!carried) {
    throw failure<MessageId::project_of_no_region>(shown);
  }
  Project project = std::move(*carried);
  project.picture.reset();
  if (project.places.empty()) {
    project.places.push_back({fs::path(shown).stem().string(), project.region, project.gain});
  }
  for (const std::string& recording : a.recordings) {
    const auto touched = embeddedProject(recording);
    if (touched && touched->sha256 != project.sha256) {
      throw failure<MessageId::project_of_other_recording>(
          fs::path(recording).filename().string(), fs::path(touched->file).filename().string(),
          shown);
    }
    project.recordings.push_back(inputFile(recording, {}, task));
    project.recordings.back().file = fs::absolute(recording).lexically_normal().generic_string();
  }
  writeProject(a.out, project);
  return {.json = reportText(Json{{"project", a.out}, {"places", namesOf(project.places)}}),
          .lines = {a.out + ": a project on " + fs::path(project.file).filename().string()}};
}

CommandResult showInfo(const ProjectArguments& a, const Task& task) {
  const Project p =
      isPackageOfRelievo(a.file) ? projectInPackage(a.file, task) : readProject(a.file);
  Json json;
  json["input"] = p.file;
  json["sha256"] = p.sha256;
  json["version"] = p.version;
  json["places"] = namesOf(p.places);
  json["measurements"] = namesOf(p.measurements);
  json["recordings"] = Json::array();
  for (const InputFile& file : p.recordings) json["recordings"].push_back(file.file);
  json["steps"] = p.history.size();
  CommandResult outcome{.json = reportText(json), .lines = {}};
  json = Json::parse(outcome.json);  // With names that are UTF-8.
  for (const auto& [key, value] : json.items()) {
    outcome.lines.push_back(key + ": " +
                            (value.is_string() ? value.template get<std::string>() : value.dump()));
  }
  return outcome;
}

/// Exit 5 if a file is missing or is another one.
CommandResult check(const ProjectArguments& a, const Task& task) {
  const std::vector<FileCheck> checks = checkFiles(readProject(a.file), task);
  CommandResult outcome{.json = reportText(Json{{"files", checkJson(checks)}}), .lines = {}};
  for (const FileCheck& one : checks) {
    outcome.lines.push_back(one.file.file + ": " +
                            kFileStates.at(static_cast<std::size_t>(one.state)));
  }
  if (!allAsBefore(checks)) {
    outcome.exit_code = 5;
    tell("Files of the project are missing or have changed (E501). Find them with project relink.");
  }
  return outcome;
}

/// Files that are not as before are looked for by their checksums.
CommandResult relink(const ProjectArguments& a, const Task& task) {
  Project project = readProject(a.file);
  const fs::path folder = fs::absolute(a.file).parent_path();
  const std::vector<FileCheck> before = checkFiles(project, task);
  std::vector<std::string*> files{&project.file};
  for (InputFile& recording : project.recordings) files.push_back(&recording.file);
  std::size_t found = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (before[i].state == FileState::as_before) continue;
    std::optional<fs::path> place;
    if (!a.to.empty() && sha256OfFile(a.to, task) == before[i].file.sha256) place = a.to;
    if (!place && (a.to.empty() || !a.search.empty())) {
      place = foundByChecksum(before[i].file, a.search.empty() ? folder : fs::path(a.search), task);
    }
    if (!place) continue;
    *files[i] = fs::absolute(*place).lexically_normal().generic_string();
    ++found;
  }
  if (found > 0) writeProject(a.out.empty() ? a.file : a.out, project);
  const std::vector<FileCheck> after = checkFiles(project, task);
  CommandResult outcome{.json = reportText(Json{{"relinked", found}, {"files", checkJson(after)}}),
                        .lines = {counted(found, "file was", "files were") + " found again"}};
  if (!allAsBefore(after)) {
    outcome.exit_code = 5;
    tell(
        "Not all files were found by their checksums (E501). Give one with --to, or a folder with "
        "--search.");
  }
  return outcome;
}

CommandResult pack(const ProjectArguments& a, const Task& task) {
  if (a.out.empty()) throw failure<MessageId::project_package_needs_name>();
  const Project project = readProject(a.file);
  PackageContents contents{
      .with_input = !a.without_input,
      .figures = {},
      .dependencies = [scans = !a.without_input](const fs::path& recording, const Task& work) {
        return dependenciesOf(recording, scans, work);
      }};
  for (const std::string& figure : a.figures) contents.figures.emplace_back(figure);
  writePackage(a.out, project, contents, task);
  return {.json = reportText(Json{{"package", a.out}, {"sha256", sha256OfFile(a.out, task)}}),
          .lines = {a.out + ": packed for citation"}};
}

CommandResult verify(const ProjectArguments& a, const Task& task) {
  const PackageCheck result = verifyPackage(a.file, task);
  CommandResult outcome{
      .json = reportText(Json{{"files", result.files}, {"problems", result.problems}}),
      .lines = {a.file + ": " +
                counted(result.files, "file is as it was", "files are as they were") + " packed"}};
  for (const std::string& problem : result.problems) tell(problem);
  if (!result.problems.empty()) outcome.exit_code = 5;
  return outcome;
}

/// Each action takes its own options.
void checkOptions(const ProjectArguments& a) {
  const auto only = [&](const char* option, bool given,
                        std::initializer_list<const char*> actions) {
    std::string list;
    for (const char* action : actions) list += (list.empty() ? "" : " or ") + std::string(action);
    const bool applies = std::any_of(actions.begin(), actions.end(),
                                     [&](const char* action) { return a.action == action; });
    if (!given || applies) return;
    throw failure<MessageId::option_of_other_action>(option, list, a.action);
  };
  only("--output", !a.out.empty(), {"new", "relink", "package"});
  only("--to", !a.to.empty(), {"relink"});
  only("--search", !a.search.empty(), {"relink"});
  only("--recording", !a.recordings.empty(), {"new"});
  only("--figure", !a.figures.empty(), {"package"});
  only("--without-input", a.without_input, {"package"});
}

CommandResult runProject(const ProjectArguments& a, const Task& task) {
  checkOptions(a);
  if (a.action == "new") return makeNew(a, task);
  if (a.action == "info") return showInfo(a, task);
  if (a.action == "check") return check(a, task);
  if (a.action == "relink") return relink(a, task);
  if (a.action == "package") return pack(a, task);
  return verify(a, task);
}

VerbFiles filesOf(const ProjectArguments& a) {
  VerbFiles files;
  if (a.out.empty()) return files;  // Relink: the project itself.
  const auto is_there = [](const fs::path& file) {
    std::error_code unknown;  // Whoever reads it says so.
    return fs::exists(file, unknown);
  };
  files.writes(a.out);
  files.reads(a.to, "the file that was moved");
  for (const std::string& log : a.recordings) files.reads(log, "a recording of the project");
  for (const std::string& figure : a.figures) files.reads(figure, "a figure that is packed");
  if (a.action != "relink") files.reads(a.file, "the file that is read");
  if (!is_there(a.file) || a.action == "verify") return files;
  const auto project = embeddedProject(a.file);
  if (!project) return files;
  files.reads(project->file);
  for (const InputFile& log : project->recordings) {
    files.reads(log.file, "a recording of the project");
  }
  return files;
}

}  // namespace

Verb projectVerb() {
  auto arguments = std::make_shared<ProjectArguments>();
  return {
      .name = "project",
      .help = "Make, look at, check, relink and pack projects",
      .declare =
          [arguments](CLI::App& verb) {
            verb.add_option(
                    "ACTION", arguments->action,
                    "new: from a picture or log; info: what a project or package holds; check: "
                    "files and checksums; "
                    "relink: find moved files; package: zip for citation; verify: such a zip")
                ->required()
                ->check(CLI::IsMember({"new", "info", "check", "relink", "package", "verify"}));
            verb.add_option("FILE", arguments->file, "Project, or what the action works on")
                ->required();
            verb.add_option("-o,--output", arguments->out, "What is written");
            verb.add_option("--to", arguments->to, "relink: the file that was moved");
            verb.add_option("--search", arguments->search, "relink: look in this folder and below");
            verb.add_option("--recording", arguments->recordings, "new: a log that belongs to it");
            verb.add_option("--figure", arguments->figures, "package: a figure to take along");
            verb.add_flag("--without-input", arguments->without_input,
                          "package: only the input's name and checksum");
          },
      .files = [arguments] { return filesOf(*arguments); },
      .run = [arguments](const Task& task) { return runProject(*arguments, task); }};
}

}  // namespace relievo::batch
