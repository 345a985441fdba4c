// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "app/cli/dependencies.h"
#include "app/cli/json.h"
#include "app/cli/published/published_input.h"
#include "app/cli/report_text.h"
#include "app/cli/state.h"
#include "app/cli/verb.h"
#include "app/cli/verbs/packed_file.h"
#include "app/cli/verbs/replay_command.h"
#include "app/cli/verbs/replay_window.h"
#include "app/cli/verbs/touch_setup.h"
#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/input_facts.h"
#include "core/io/web/web_link.h"
#include "core/project/embedded_state.h"
#include "core/project/package.h"
#include "core/project/project.h"
#include "core/provenance/embedded.h"
#include "core/provenance/program.h"
#include "core/recording/log_check.h"
#include "haptics/record/force_law.h"
#include "haptics/record/recorded_loop.h"
#include "haptics/record/replay.h"
#include "haptics/rt/build_id.h"

namespace relievo::batch {
namespace {

struct ReplayArguments {
  std::string log, input, out;
  bool verify = false;
  OutsideFiles outside_files = OutsideFiles::refuse;
};

constexpr int kVerifyMismatch = 5;

bool isPackage(const std::string& file) {
  return inputFacts(file).host_file == HostFileKind::package;
}

bool isOfWindow(const LogTable& log) {
  return log.footer.find("replay core ") != std::string::npos;
}

/// A folder of its own, gone afterwards.
class WorkFolder {
 public:
  WorkFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "relievo-package-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw failure<MessageId::no_folder_to_unpack>();
    }
    path_ = name;
  }
  ~WorkFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// What of a log is computed again, and what its checksums alone can tell.
Json jsonOfColumns(bool recomputed) {
  Json columns = Json::array();
  for (const LogColumn& column : kNumberColumns) {
    if (column.is_recomputed == recomputed) columns.push_back(column.name);
  }
  if (!recomputed) columns.insert(columns.end(), {"event", "header", "footer"});
  return columns;
}

std::string listed(const Json& names) {
  std::string text;
  for (const Json& name : names) {
    text += (text.empty() ? "" : ", ") + name.get<std::string>();
  }
  return text;
}

Json jsonOfCheck(const LogCheck& check) {
  return {{"state", name(check.state)},
          {"rows", check.rows},
          {"where", check.where.empty() ? Json() : Json(check.where)}};
}

std::string sentenceOf(const LogCheck& check) {
  const std::string first = "its first " + std::to_string(check.rows) + " rows";
  switch (check.state) {
    case LogCheck::State::none:
      return "It carries no checksum, as an earlier build made it: what is not computed again was "
             "not checked";
    case LogCheck::State::whole:
      return "By its checksums every row, event and line is as it was written";
    case LogCheck::State::unfinished:
      return "It was not finished, as its program was ended or the disk was full; by its "
             "checksums " +
             first + ", with events and header, are as they were written";
    case LogCheck::State::changed:
      return "It was changed: " + check.where +
             (check.rows > 0 ? "; " + first + " are" : std::string());
  }
  return {};
}

Json jsonOfLaw(const LogTable& log) {
  const std::optional<int> law = lawIn(log.header);
  return {{"recorded", law ? Json(*law) : Json()}, {"this_build", kForceLaw}};
}

/// Which program recorded a log; of its library the build, where the log depends on it.
Json jsonOfRecorder(const LogTable& log) {
  const Json state =
      Json::parse(headerLine(log.header, std::string(kStateKey) + " "), nullptr, false);
  const Json::json_pointer commit("/program/commit");
  const std::string_view version = headerLine(log.header, "version ");
  const std::string build = recordedBuild(log.footer);
  return {{"version", version.empty() ? Json() : Json(version)},
          {"commit", !state.is_discarded() && state.contains(commit) ? state[commit] : Json()},
          {"build", build.empty() ? Json() : Json(build)}};
}
Json jsonOfThisProgram() {
  return {{"version", programVersion()}, {"commit", programCommit()}, {"build", buildId()}};
}

std::string sentenceOfRecorder(const Json& recorder) {
  const auto named = [](const Json& program) {
    std::string text;
    for (const char* key : {"version", "commit", "build"}) {
      if (!program[key].is_string()) continue;
      text += (text.empty() ? "" : ", ") + std::string(key) + " " + program[key].get<std::string>();
    }
    return text.empty() ? std::string("a program that it does not name") : text;
  };
  return "Recorded by " + named(recorder) + "; this is " + named(jsonOfThisProgram());
}

/// Why a replay need not be the same here; empty: nothing but the file can differ.
std::string whyDifferent(const LogTable& log) {
  std::string law = lawDifference(log.header);
  const std::string build = recordedBuild(log.footer);
  if (!law.empty() || build.empty() || build == buildId()) return law;
  return "Another build recorded it, under the same force law: build " + build +
         "; this is build " + buildId() + ".";
}

/// What the hand of a verb's log was led along; null: it was not led.
std::shared_ptr<const GuidePath> guideIn(const LogTable& log) {
  const auto guides = recordedGuides(log.footer);
  return guides.empty() ? nullptr : std::make_shared<const GuidePath>(guides.begin()->second);
}

/// One recording of a package, made by a verb or in the window, on the package's input.
/// @throw FileError  it says how it was made, but cannot be replayed here
ReplayResult replayPacked(const LogTable& log, const std::string& recording,
                          const std::string& input, const std::filesystem::path& folder,
                          const Task& task) {
  const auto each = [](const HapticSample&, double) {};
  const RecordingPlace place{.file = recording, .input = input, .package_folder = folder};
  if (const auto of_window = replayOfWindow(log, place, each, task)) return *of_window;
  TouchArguments touch = argumentsOf(commandOf(log, recording));
  touch.map.file = input;
  touch.lift_n = liftIn(log);
  touch.told = toldIn(log);
  touch.recorded_guide = guideIn(log);
  if (const auto raster = firmnessOfCommand(log)) {
    touch.firmness = packedFile(folder, recording, raster->file, raster->sha256, task).string();
  }
  const TouchSetup setup = prepareTouch(touch, task);
  return replay(*setup.space, setup.core, setup.options.chain, log, each, task);
}

/// What became of one recording of a package. @return false if it is not the same
bool verifyRecording(const std::string& recording, const std::string& input,
                     const std::filesystem::path& folder, Json& report, std::string& line,
                     const Task& task) {
  const LogTable log = readLog(recording, LogUse::replay, task);
  line = std::filesystem::path(recording).filename().string() + ": ";
  const LogCheck check = checkLog(recording, task);
  const bool is_changed = check.state == LogCheck::State::changed;
  report = {{"recording", std::filesystem::path(recording).filename().string()},
            {"integrity", jsonOfCheck(check)}};
  try {
    const ReplayResult result = replayPacked(log, recording, input, folder, task);
    report["replayed"] = true;
    report["ticks"] = result.ticks;
    report["different_ticks"] = result.different;
    report["law"] = jsonOfLaw(log);
    report["recorded_by"] = jsonOfRecorder(log);
    const std::string why = result.different == 0 ? std::string() : whyDifferent(log);
    if (!why.empty()) report["why"] = why;
    line += std::to_string(result.ticks) +
            (result.different == 0 ? " ticks replayed, all the same to the last bit"
                                   : " ticks replayed, " + std::to_string(result.different) +
                                         " differ" + (why.empty() ? "" : ". " + why)) +
            ". " + sentenceOf(check);
    return result.different == 0 && !is_changed;
  } catch (const FileError& error) {
    report["replayed"] = false;
    report["ticks"] = log.rows.size();
    report["problem"] = error.what();
    line += std::to_string(log.rows.size()) + " rows read, but not replayed. " + error.what();
    return false;
  }
}

/// Every file of a package against its checksum, then every recording against its surface.
CommandResult verifyAll(const ReplayArguments& a, const Task& task) {
  const PackageCheck check = verifyPackage(a.log, task);
  Json json{{"package", a.log},
            {"files", check.files},
            {"problems", check.problems},
            {"recordings", Json::array()}};
  for (const std::string& problem : check.problems) tell(problem);
  CommandResult outcome{
      .json = {},
      .lines = {a.log + ": " + counted(check.files, "file is as it was", "files are as they were") +
                " packed"},
      .exit_code = check.problems.empty() ? 0 : kVerifyMismatch};
  if (check.problems.empty()) {
    const WorkFolder folder;
    unpackPackage(a.log, folder.path(), task);
    const Project project = readProject(folder.path() / "project.json");
    const std::string input = a.input.empty() ? project.file : a.input;
    std::error_code missing;
    if (!project.recordings.empty() && !std::filesystem::exists(input, missing)) {
      throw failure<MessageId::package_without_input>(project.sha256);
    }
    for (const InputFile& recording : project.recordings) {
      Json& report = json["recordings"].emplace_back();
      const bool same = verifyRecording(recording.file, input, folder.path(), report,
                                        outcome.lines.emplace_back(), task);
      if (!same) outcome.exit_code = kVerifyMismatch;
    }
  }
  json["identical"] = outcome.exit_code == 0;
  outcome.json = reportText(json);
  return outcome;
}

VerbFiles filesOf(const ReplayArguments& a) {
  VerbFiles files;
  files.reads(a.log, "the recording that is read");
  files.reads(a.input);
  files.writes(a.out);
  return files;
}

/// What the log names is read as well. @throw ArgumentError, FileError
void checkOutput(const ReplayArguments& a, const LogTable& log, const Task& task) {
  if (a.out.empty()) return;
  VerbFiles files;
  files.writes(a.out);
  if (isOfWindow(log)) {
    files.readsStateOf(a.log, a.input);
    for (const InputFile& file : dependenciesOf(a.log, true, task)) {
      files.reads(file.file, "a file that the recording needs");
    }
  } else {
    const TouchArguments touch = argumentsOf(commandOf(log, a.log));
    files.reads(a.input.empty() ? touch.map.file : a.input);
    files.reads(touch.firmness, "the stiffness map that is read");
  }
  check(files);
}

/// Of an address in the log only what was opened here before is taken, as of one in a project.
/// @param named  by the command in the log  @throw FileError  E501, it was not opened
std::string inputOf(const ReplayArguments& a, const std::string& named) {
  if (!a.input.empty()) return a.input;
  return isWebAddress(named) ? foundInput(a.log, named).string() : named;
}

/// What the command in a log reads, which whoever made the log chose. @throw FileError
void requireOwnFiles(const ReplayArguments& a, const LogTable& log, const Task& task) {
  const auto state = embeddedProject(a.log);
  const std::string sha256 = state ? state->sha256 : std::string();
  const TouchArguments touch = argumentsOf(commandOf(log, a.log));
  if (a.input.empty() && !isWebAddress(touch.map.file)) {
    requireOwn(a.log, {.file = touch.map.file, .sha256 = sha256}, a.outside_files,
               "Give it with --input if it is the right one.", task);
  }
  if (const auto raster = firmnessOfCommand(log)) {
    requireOwn(a.log, *raster, a.outside_files, "Put the raster beside the log.", task);
  }
}

/// The hand of one recording, given to its surface again. @throw FileError, ArgumentError
ReplayResult replayed(const ReplayArguments& a, Json& json, const Task& task) {
  const LogTable log = readLog(a.log, LogUse::replay, task);
  json["law"] = jsonOfLaw(log);
  json["recorded_by"] = jsonOfRecorder(log);
  json["this_program"] = jsonOfThisProgram();
  const std::string why = whyDifferent(log);
  json["why"] = why.empty() ? Json() : Json(why);
  checkOutput(a, log, task);
  std::unique_ptr<SampleLog> out;
  const auto each = [&out](const HapticSample& sample, double t_s) {
    if (out) out->write(sample, t_s);
  };
  if (!a.out.empty() && isOfWindow(log)) out = openLog(a.out, log.header);
  json["input"] = calledInput(a.input);
  std::optional<ReplayResult> result = replayOfWindow(
      log, {.file = a.log, .input = a.input, .outside_files = a.outside_files}, each, task);
  if (!result) {
    requireOwnFiles(a, log, task);
    TouchArguments touch = argumentsOf(commandOf(log, a.log));
    touch.map.file = inputOf(a, touch.map.file);
    json["input"] = calledInput(touch.map.file);
    touch.lift_n = liftIn(log);
    touch.told = toldIn(log);
    touch.recorded_guide = guideIn(log);
    const TouchSetup setup = prepareTouch(touch, task);
    if (!a.out.empty()) out = openLog(a.out, log.header, setup.space.get());
    result = replay(*setup.space, setup.core, setup.options.chain, log, each, task);
  }
  if (out) out->close();
  return *result;
}

/// What a replay found, as a report and as a sentence.
std::string said(const ReplayResult& result, Json& json) {
  json["ticks"] = result.ticks;
  json["different_ticks"] = result.different;
  json["identical"] = result.different == 0;
  std::string line = std::to_string(result.ticks) + " ticks replayed, ";
  if (!result.first) {
    json.erase("why");
    return line + "all the same to the last bit";
  }
  const ReplayDifference& first = *result.first;
  json["first_difference"] = {{"tick", first.tick},
                              {"column", first.column},
                              {"logged", first.logged},
                              {"replayed", first.replayed}};
  line += std::to_string(result.different) + " differ; the first is " + first.column + " in tick " +
          std::to_string(first.tick) + ": " + Json(first.logged).dump() + " in the log, " +
          Json(first.replayed).dump() + " now";
  return line + (json["why"].is_null() ? "" : ". " + json["why"].get<std::string>());
}

CommandResult runReplay(const ReplayArguments& a, const Task& task) {
  if (isPackage(a.log)) {
    if (!a.out.empty()) {
      throw failure<MessageId::output_of_a_package>();
    }
    return verifyAll(a, task);
  }
  const LogCheck check = checkLog(a.log, task);
  const bool is_changed = check.state == LogCheck::State::changed;
  Json json{{"log", a.log},
            {"integrity", jsonOfCheck(check)},
            {"recomputed", jsonOfColumns(true)},
            {"only_by_checksum", jsonOfColumns(false)}};
  std::string line;
  bool is_same = false;
  try {
    const ReplayResult result = replayed(a, json, task);
    line = said(result, json);
    is_same = result.different == 0;
  } catch (const FileError& error) {
    // What was changed may be what a replay needs; that it was changed is the answer then.
    if (!a.verify || !is_changed) throw;
    json["identical"] = false;
    json["problem"] = error.what();
    line = std::string("not replayed. ") + error.what();
  }
  std::vector<std::string> lines{
      a.log + ": " + line, sentenceOf(check) + ".",
      "Computed again and compared: " + listed(json["recomputed"]) +
          ". Told by checksums alone: " + listed(json["only_by_checksum"]) + "."};
  if (json.contains("recorded_by")) lines.push_back(sentenceOfRecorder(json["recorded_by"]) + ".");
  return {.json = reportText(json),
          .lines = lines,
          .exit_code = a.verify && (!is_same || is_changed) ? kVerifyMismatch : 0};
}

}  // namespace

Verb replayVerb() {
  auto arguments = std::make_shared<ReplayArguments>();
  return {.name = "replay",
          .help = "Give the hand of a log to the same surface again and compare",
          .declare =
              [arguments](CLI::App& verb) {
                verb.add_option("log", arguments->log,
                                "LOG.csv or LOG.h5; or a package for citation: all of it")
                    ->required();
                mayBeWebAddress(
                    verb.add_option("--input", arguments->input,
                                    "The scan or map, or the address of a published map, if it is "
                                    "not where the log says"));
                verb.add_option("-o,--output", arguments->out, "Write what came out, too");
                verb.add_flag("--verify", arguments->verify,
                              "Exit 5 if a single bit differs, or the log was changed");
                addOutsideOption(verb, arguments->outside_files);
              },
          .files = [arguments] { return filesOf(*arguments); },
          .run = [arguments](const Task& task) { return runReplay(*arguments, task); }};
}

}  // namespace relievo::batch
