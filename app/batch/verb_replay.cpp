// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <CLI/CLI.hpp>
#include <memory>

#include "app/batch/json.h"
#include "app/batch/replay_window.h"
#include "app/batch/touch_setup.h"
#include "app/batch/verb.h"
#include "haptics/record/replay.h"

namespace relievo::batch {
namespace {

struct ReplayArguments {
  std::string log, input, out;
  bool verify = false;
};

/// The command that made a log, from its header's line "parameters {...}".
std::vector<std::string> commandOf(const LogTable& log, const std::string& file) {
  const std::string word = "parameters ";
  const std::size_t at = log.header.find(word);
  if (at != std::string::npos) {
    const std::size_t from = at + word.size();
    const Json json =
        Json::parse(log.header.substr(from, log.header.find('\n', from) - from), nullptr, false);
    if (json.is_object() && json.contains("command") && json["command"].is_array() &&
        !json["command"].empty() &&
        std::all_of(json["command"].begin(), json["command"].end(),
                    [](const Json& part) { return part.is_string(); })) {
      return json["command"].get<std::vector<std::string>>();
    }
  }
  throw FileError(
      "The log \"" + file +
      "\" does not say what made it; only logs of touch, record and the window can be replayed.");
}

TouchArguments argumentsOf(const std::vector<std::string>& command) {
  TouchArguments arguments;
  CLI::App parser;
  if (command.front() == "record") {
    declareRecord(parser, arguments);
  } else {
    declareTouch(parser, arguments);
  }
  parser.add_option("--report", "")->expected(1);
  try {
    parser.parse(std::vector<std::string>(command.rbegin(), command.rend() - 1));
  } catch (const CLI::ParseError& error) {
    throw FileError("The log was made by a command that this version does not understand: " +
                    std::string(error.what()) + ".");
  }
  return arguments;
}

Outcome runReplay(const ReplayArguments& a, const Task& task) {
  const LogTable log = readLog(a.log);
  std::unique_ptr<SampleLog> out;
  const auto each = [&out](const HapticSample& sample, double t_s) {
    if (out) out->write(sample, t_s);
  };
  if (!a.out.empty() && log.footer.find("replay core ") != std::string::npos) {
    out = openLog(a.out, log.header);
  }
  std::string input = a.input;
  std::optional<ReplayResult> of_window = replayOfWindow(log, a.log, a.input, each, task);
  if (!of_window) {
    TouchArguments touch = argumentsOf(commandOf(log, a.log));
    if (!a.input.empty()) touch.map.file = a.input;
    input = touch.map.file;
    const TouchSetup setup = prepareTouch(touch, task);
    if (!a.out.empty()) out = openLog(a.out, log.header, setup.space.get());
    of_window = replay(*setup.space, setup.core, log, each, task);
  }
  const ReplayResult& result = *of_window;
  if (out) out->close();

  Json json;
  json["log"] = a.log;
  json["input"] = input;
  json["ticks"] = result.ticks;
  json["different_ticks"] = result.different;
  json["identical"] = result.different == 0;
  std::string line = a.log + ": " + std::to_string(result.ticks) + " ticks replayed, ";
  if (result.first) {
    const ReplayDifference& first = *result.first;
    json["first_difference"] = {{"tick", first.tick},
                                {"column", first.column},
                                {"logged", first.logged},
                                {"replayed", first.replayed}};
    line += std::to_string(result.different) + " differ; the first is " + first.column +
            " in tick " + std::to_string(first.tick) + ": " + Json(first.logged).dump() +
            " in the log, " + Json(first.replayed).dump() + " now";
  } else {
    line += "all the same to the last bit";
  }
  constexpr int kVerifyMismatch = 5;
  return {.json = json.dump(2),
          .lines = {line},
          .exit_code = a.verify && result.different > 0 ? kVerifyMismatch : 0};
}

}  // namespace

Verb replayVerb() {
  auto arguments = std::make_shared<ReplayArguments>();
  return {.name = "replay",
          .help = "Give the hand of a log to the same surface again and compare",
          .declare =
              [arguments](CLI::App& verb) {
                verb.add_option("log", arguments->log, "LOG.csv or LOG.h5")->required();
                verb.add_option("--input", arguments->input,
                                "The scan or map, if it is not where the log says");
                verb.add_option("-o,--output", arguments->out, "Write what came out, too");
                verb.add_flag("--verify", arguments->verify,
                              "Exit 5 if a single bit differs from the log");
              },
          .run = [arguments](const Task& task) { return runReplay(*arguments, task); }};
}

}  // namespace relievo::batch
