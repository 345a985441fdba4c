// SPDX-License-Identifier: BSD-3-Clause
#include "app/batch/recording.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "app/batch/json.h"
#include "core/base/error.h"
#include "core/project/carried_state.h"
#include "core/provenance/embedded.h"
#include "haptics/record/events.h"
#include "haptics/record/replay.h"

namespace relievo::batch {
namespace {

constexpr std::size_t kHip = 2, kProxy = 5, kForce = 8, kContact = 13, kDetail = 18, kWindow = 19,
                      kOrigin = 20;
static_assert(kLogColumns[kHip].name == "hip_x_mm" && kLogColumns[kProxy].name == "proxy_x_mm");
static_assert(kLogColumns[kForce].name == "f_x_N" && kLogColumns[kContact].name == "contact");
static_assert(kLogColumns[kDetail].name == "detail" && kLogColumns[kWindow].name == "region_id");
static_assert(kLogColumns[kOrigin].name == "origin");

/// The rest of the first line that starts with `word`; nothing if there is none.
std::string_view lineAfter(std::string_view text, std::string_view word) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.starts_with(word)) return line.substr(word.size());
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

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

TouchRow rowOf(const std::array<double, kLogColumns.size()>& v, const std::string& name,
               std::size_t number) {
  for (const double value : v) {
    if (std::isfinite(value)) continue;
    throw FileError("The recording \"" + name + "\" has a value that is no finite number in row " +
                    std::to_string(number) + ". It is not replayed.");
  }
  const auto code = static_cast<std::size_t>(v[kOrigin]);
  return {.t_s = v[0],
          .hip = {v[kHip], v[kHip + 1], v[kHip + 2]},
          .proxy = {v[kProxy], v[kProxy + 1], v[kProxy + 2]},
          .force = {v[kForce], v[kForce + 1], v[kForce + 2]},
          .origin = code < kOriginCount ? static_cast<Origin>(code) : Origin::outside,
          .contact = v[kContact] != 0,
          .window_id = static_cast<std::uint64_t>(v[kWindow]),
          .detail = static_cast<int>(v[kDetail])};
}

/// What the carried state says: input, map and the window at the start.
void takeState(TouchRecording& recording) {
  const Project project = projectFromState(recording.state, recording.name).value_or(Project{});
  recording.input = project.file;
  recording.input_sha256 = project.sha256;
  recording.windows.push_back(
      {recording.rows.front().window_id, project.region, project.gain, true});
  const Json json = Json::parse(recording.state, nullptr, false);
  const auto made = json.find("made");
  if (made == json.end() || !made->is_object() || !made->contains("view_from_file")) return;
  recording.view_from_file.emplace();
  (*made)["view_from_file"].get_to(*recording.view_from_file);
}

/// Older logs of `record` name only input, region and level.
void takePlainLines(TouchRecording& recording, std::string_view header) {
  recording.input = lineAfter(header, "input ");
  const std::vector<double> region = numbersOf(lineAfter(header, "region_mm "));
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
                         [](const LogRow& one, std::uint64_t tick) { return tickOf(one) < tick; });
    const LogRow& of = row == log.rows.end() ? log.rows.back() : *row;
    recording.events.push_back({.t_s = of[0], .text = note.text, .is_note = true});
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
  const LogTable log = readLog(file, task);
  TouchRecording recording;
  recording.name = file.filename().string();
  recording.rows.reserve(log.rows.size());
  for (const auto& row : log.rows) {
    constexpr std::size_t kRowsPerCheck = 65536;
    if (recording.rows.size() % kRowsPerCheck == 0) task.check();
    recording.rows.push_back(rowOf(row, recording.name, recording.rows.size() + 1));
    if (recording.rows.size() < 2 || row[0] >= recording.rows[recording.rows.size() - 2].t_s) {
      continue;
    }
    throw FileError("The recording \"" + recording.name + "\" goes back in time in row " +
                    std::to_string(recording.rows.size()) + ". It is not replayed.");
  }
  recording.state = lineAfter(log.header, std::string(kStateKey) + " ");
  if (recording.state.empty()) {
    takePlainLines(recording, log.header);
  } else {
    takeState(recording);
  }
  // A recording of the window has its last lines in room that its header kept for them.
  takeWindowLines(recording, log.header);
  takeWindowLines(recording, log.footer);
  takeEvents(recording, log);
  return recording;
}

}  // namespace relievo::batch
