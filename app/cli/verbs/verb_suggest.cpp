// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cmath>

#include "app/cli/json.h"
#include "app/cli/options/number_option.h"
#include "app/cli/report_text.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/project/caption.h"
#include "core/session/feelable.h"

namespace relievo::batch {
namespace {

struct SuggestArguments {
  MapArguments map;
  FeelOptions feel;
};

Json jsonOfWindow(const FeelableWindow& window, const DetailLadder& ladder) {
  return {{"region", jsonOf(window.region)},    {"detail", ladder.detailOf(window.region.level)},
          {"level", window.region.level.value}, {"score", window.score},
          {"felt", window.felt_share},          {"steep", window.steep_share},
          {"measured", window.measured_share},  {"width_mm", window.width_mm}};
}

std::string lineOf(std::size_t place, const FeelableWindow& window, const DetailLadder& ladder) {
  const auto percent = [](double share) { return std::to_string(std::lround(100 * share)) + " %"; };
  const Region& r = window.region;
  return std::to_string(place) + ". --region " + shortNumber(r.x_mm) + ',' + shortNumber(r.y_mm) +
         ',' + shortNumber(r.side_mm) + ',' + shortNumber(r.side_mm) + " --level " +
         std::to_string(r.level.value) + " (Resolution " +
         std::to_string(ladder.detailOf(r.level)) + " of " + std::to_string(ladder.levels()) +
         "): " + percent(window.felt_share) + " felt, most clearly relief about " +
         shortNumber(window.width_mm, 2) + " mm wide; " + percent(window.measured_share) +
         " measured, " + percent(window.steep_share) + " steep";
}

CommandResult runSuggest(const SuggestArguments& a, const Task& task) {
  const Surface surface = loadForVerb(a.map, task);
  if (surface.tiles) throw failure<MessageId::suggest_not_in_tiles>();
  const std::vector<FeelableWindow> windows =
      feelableWindows(surface.map, surface.pyramid, a.feel, task);
  CommandResult outcome;
  outcome.exit_code = exitCodeAfter(surface);
  Json rows = Json::array();
  for (const FeelableWindow& window : windows) {
    rows.push_back(jsonOfWindow(window, surface.ladder));
    outcome.lines.push_back(lineOf(rows.size(), window, surface.ladder));
  }
  if (windows.empty()) {
    outcome.lines.emplace_back("No window has relief that stands out from what a hand just feels.");
  }
  outcome.json = reportText(Json{{"file", a.map.file},
                                 {"gain", a.feel.gain},
                                 {"grip_factor", a.feel.grip_factor},
                                 {"details", surface.ladder.levels()},
                                 {"windows", rows}});
  return outcome;
}

}  // namespace

Verb suggestVerb() {
  auto arguments = std::make_shared<SuggestArguments>();
  return {.name = "suggest",
          .help = "Windows whose relief a hand feels best, at every level, ranked",
          .declare =
              [arguments](CLI::App& verb) {
                addMapOptions(verb, arguments->map);
                takes(verb.add_option("--most", arguments->feel.most, "How many windows; 10"),
                      {.low = 1, .high = 1000});
                takes(verb.add_option("--gain", arguments->feel.gain,
                                      "Vertical exaggeration under the hand; 1"),
                      {.low = 0.01, .high = 100});
                takes(verb.add_option("--grip-factor", arguments->feel.grip_factor,
                                      "How much higher relief must be for a hand on a grip than "
                                      "for a bare fingertip; 4"),
                      {.low = 0.1, .high = 100});
              },
          .run = [arguments](const Task& task) { return runSuggest(*arguments, task); }};
}

}  // namespace relievo::batch
