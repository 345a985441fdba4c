// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/recording.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/failure.h"
#include "core/io/pipe_or_file.h"
#include "core/project/embedded_state.h"
#include "core/provenance/embedded.h"
#include "core/provenance/parameters_json.h"
#include "core/recording/log_note.h"
#include "core/recording/log_table.h"

namespace relievo {
namespace {

/// All numbers of a text, whatever stands between them.
std::vector<double> numbersOf(std::string_view text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end) {
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error == std::errc()) numbers.push_back(value);
    at = error == std::errc() ? next : at + 1;
  }
  return numbers;
}

/// How the map was made from the file, if a state says it.
std::optional<std::array<double, 16>> viewFromFileIn(std::string_view state) {
  const Json json = Json::parse(state, nullptr, false);
  const Json::json_pointer place("/made/view_from_file");
  if (json.is_discarded() || !json.contains(place)) return std::nullopt;
  try {
    return json.at(place).get<std::array<double, 16>>();
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // These are no sixteen numbers.
  }
}

/// What the carried state says: input, map and the window at the start.
void takeState(TouchRecording& recording) {
  const Project project = projectFromState(recording.state, recording.name).value_or(Project{});
  recording.input = project.file;
  recording.input_sha256 = project.sha256;
  recording.windows.push_back(
      {recording.rows.front().window_id, project.region, project.gain, true});
  recording.view_from_file = viewFromFileIn(recording.state);
}

/// Older logs of `record` name only input, region and level.
void takePlainLines(TouchRecording& recording, std::string_view header) {
  recording.input = headerLine(header, "input ");
  const std::vector<double> region = numbersOf(headerLine(header, "region_mm "));
  if (region.size() != 5 || !(region[2] > 0)) return;
  recording.windows.push_back(
      {recording.rows.front().window_id,
       {region[0], region[1], region[2], Level{static_cast<int>(region[4])}},
       1,
       true});
}

/// Lines "window ID: region_mm X Y SIDE level L gain G" at the recording's end.
void takeWindowLines(TouchRecording& recording, std::string_view footer) {
  while (!footer.empty()) {
    const std::size_t end = std::min(footer.find('\n'), footer.size());
    const std::string_view line = footer.substr(0, end);
    footer.remove_prefix(std::min(end + 1, footer.size()));
    if (!line.starts_with("window ")) continue;
    const std::vector<double> n = numbersOf(line);
    if (n.size() != 6 || !(n[3] > 0) || !(n[5] > 0)) continue;
    const auto id = static_cast<std::uint64_t>(n[0]);
    std::erase_if(recording.windows, [&](const TouchedWindow& known) { return known.id == id; });
    recording.windows.push_back({id, {n[1], n[2], n[3], Level{static_cast<int>(n[4])}}, n[5]});
  }
}

/// A note belongs to the tick at which it was begun, though its text came later.
void takeEvents(TouchRecording& recording, const LogTable& log) {
  const auto add_note = [&](const Note& note) {
    const auto row =
        std::lower_bound(log.rows.begin(), log.rows.end(), note.tick,
                         [](const TouchRow& one, std::uint64_t tick) { return one.tick < tick; });
    const TouchRow& of = row == log.rows.end() ? log.rows.back() : *row;
    recording.events.push_back({.t_s = of.t_s, .text = note.text, .is_note = true});
  };
  for (const LogEvent& event : log.events) {
    if (const auto note = noteIn(event.text)) {
      add_note(*note);
    } else {
      recording.events.push_back({.t_s = event.t_s, .text = event.text});
    }
  }
  for (std::string_view lines : {std::string_view(log.header), std::string_view(log.footer)}) {
    while (!lines.empty()) {
      const std::size_t end = std::min(lines.find('\n'), lines.size());
      if (const auto note = noteIn(lines.substr(0, end))) add_note(*note);
      lines.remove_prefix(std::min(end + 1, lines.size()));
    }
  }
  std::stable_sort(recording.events.begin(), recording.events.end(),
                   [](const TouchEvent& a, const TouchEvent& b) { return a.t_s < b.t_s; });
}

}  // namespace

TouchRecording readRecording(const std::filesystem::path& file, const Task& task) {
  requirePipeOrFile(file);  // A name that is wrong is no damaged recording.
  LogTable log = readLog(file, LogUse::show, task);
  TouchRecording recording;
  recording.name = file.filename().string();
  const auto back = std::adjacent_find(
      log.rows.begin(), log.rows.end(),
      [](const TouchRow& row, const TouchRow& next) { return next.t_s < row.t_s; });
  if (back != log.rows.end()) {
    throw failure<MessageId::recording_goes_back>(file.filename(), back - log.rows.begin() + 2);
  }
  takeEvents(recording, log);
  recording.rows = std::move(log.rows);
  recording.state = headerLine(log.header, std::string(kStateKey) + " ");
  if (recording.state.empty()) {
    takePlainLines(recording, log.header);
  } else {
    takeState(recording);
  }
  // A recording of the window has its last lines in room that its header kept for them.
  takeWindowLines(recording, log.header);
  takeWindowLines(recording, log.footer);
  return recording;
}

}  // namespace relievo
