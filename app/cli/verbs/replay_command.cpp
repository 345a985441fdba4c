// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/verbs/replay_command.h"

#include <algorithm>
#include <charconv>
#include <CLI/CLI.hpp>

#include "app/cli/json.h"
#include "app/cli/published/published_input.h"
#include "app/cli/verbs/devices/told_limits.h"
#include "core/base/failure.h"
#include "core/provenance/embedded.h"
#include "core/provenance/name_text.h"

namespace relievo::batch {
namespace {

/// What follows a word at the start of one of the header's lines, as JSON.
Json headerJson(const LogTable& log, const std::string& word) {
  const std::size_t at = log.header.find(word);
  if (at == std::string::npos) return Json(Json::value_t::discarded);
  const std::size_t from = at + word.size();
  return Json::parse(log.header.substr(from, log.header.find('\n', from) - from), nullptr, false);
}

}  // namespace

std::optional<std::vector<std::string>> commandIn(const LogTable& log) {
  const Json json = headerJson(log, "parameters ");
  if (!json.is_object() || !json.contains("command")) return std::nullopt;
  const Json& command = json["command"];
  if (!command.is_array() || command.empty() ||
      !std::all_of(command.begin(), command.end(),
                   [](const Json& part) { return part.is_string(); })) {
    return std::nullopt;
  }
  std::vector<std::string> words;
  for (const Json& word : command) words.push_back(nameFromText(word.get<std::string>()));
  return words;
}

std::vector<std::string> commandOf(const LogTable& log, const std::string& file) {
  if (auto command = commandIn(log)) return std::move(*command);
  // Whatever ends the window's recordings also says how they are run again.
  const bool of_window = log.header.starts_with("relievo recording");
  const bool ended = (log.header + log.footer).find("loop ticks ") != std::string::npos;
  if (of_window && !ended) {
    throw failure<MessageId::recording_not_verifiable>(file);
  }
  throw failure<MessageId::log_of_no_command>(file);
}

TouchArguments argumentsOf(const std::vector<std::string>& command) {
  TouchArguments arguments;
  CLI::App parser;
  if (command.front() == "record") {
    declareRecord(parser, arguments);
  } else {
    declareTouch(parser, arguments);
  }
  leaveWebAddress(parser.get_option("FILE"));
  parser.add_option("--report", "")->expected(1);
  try {
    parser.parse(std::vector<std::string>(command.rbegin(), command.rend() - 1));
  } catch (const CLI::ParseError& error) {
    throw failure<MessageId::log_command_unknown>(error.what());
  }
  arguments.map.as_recorded = arguments.region.as_recorded = true;
  return arguments;
}

double liftIn(const LogTable& log) {
  const std::string_view text = headerLine(log.header, kLiftWords);
  double lift_n = 0;
  std::from_chars(text.data(), text.data() + text.size(), lift_n);
  return lift_n;
}

std::optional<DeviceInfo> toldIn(const LogTable& log) {
  return fromToldLimits(headerLine(log.header, kToldLimits));
}

std::optional<InputFile> firmnessOfCommand(const LogTable& log) {
  const auto command = commandIn(log);
  if (!command) return std::nullopt;
  const std::string file = argumentsOf(*command).firmness;
  if (file.empty()) return std::nullopt;
  InputFile raster{.file = file, .sha256 = {}};
  const Json state = headerJson(log, std::string(kStateKey) + " ");
  const Json::json_pointer sha256("/touch/firmness/sha256");
  if (!state.is_discarded() && state.contains(sha256) && state[sha256].is_string()) {
    raster.sha256 = state[sha256].get<std::string>();
  }
  return raster;
}

}  // namespace relievo::batch
