// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/large.h"
#include "app/cli/report_text.h"

#include <unistd.h>

#include <chrono>
#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>

#include "app/cli/json.h"
#include "app/cli/map_report.h"
#include "app/cli/options/map_option_use.h"
#include "app/cli/options/number_option.h"
#include "app/cli/processes.h"
#include "core/base/failure.h"
#include "core/base/threads.h"
#include "core/base/time_left.h"
#include "core/io/raster/colour_raster.h"
#include "core/project/caption.h"
#include "core/project/tiled_work.h"
#include "core/region/smoothing.h"
#include "core/session/input_names.h"
#include "core/session/large/large_map.h"
#include "core/session/large/tiled_surface.h"
#include "core/tiles/level_files.h"
#include "core/tiles/tiled_map.h"

namespace relievo::batch {
namespace {

/// Steps, percents and how long a step still takes on one line of a terminal, nothing into files
/// and pipes.
class ProgressLine {
 public:
  explicit ProgressLine(bool shown) : shown_(shown) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(std::string_view step, double fraction) {
    if (!shown_) return;
    const int percent = static_cast<int>(100 * fraction);
    if (step == step_ && percent == percent_) return;
    const auto now = std::chrono::steady_clock::now();
    if (step != step_) {
      began_ = now;
      began_at_ = fraction;
    }
    step_ = step;
    percent_ = percent;
    const double seconds = std::chrono::duration<double>(now - began_).count();
    std::cerr << "\r\033[Krelievo: " << step << ", " << percent << " %"
              << timeLeftWords(seconds, began_at_, fraction) << std::flush;
  }
  void clear() {
    if (shown_ && percent_ >= 0) std::cerr << "\r\033[K" << std::flush;
    percent_ = -1;
  }

 private:
  bool shown_;
  std::string step_;
  int percent_ = -1;
  std::chrono::steady_clock::time_point began_;
  double began_at_ = 0;
};

void sayView(const Surface& view) {
  const HeightRange range = heightRange(view.map);
  const GridSize size = view.map.frame.size;
  tell(englishText(view.messages.back()) + " " + std::to_string(size.cols) + " x " +
       std::to_string(size.rows) + " cells of " + shortNumber(view.map.frame.spacing_mm) +
       " mm, heights " + shortNumber(range.min_mm) + " to " + shortNumber(range.max_mm) + " mm.");
}

/// @param factor  the M that its levels were made with
Json levelsJson(const LargeMap& map, double factor) {
  DetailLadder ladder{.spacings_mm = {}, .factor = factor};
  for (const GridFrame& frame : map.frames) ladder.spacings_mm.push_back(frame.spacing_mm);
  Json levels = Json::array();
  for (std::size_t l = 0; l < map.frames.size(); ++l) {
    const GridFrame& frame = map.frames[l];
    levels.push_back({{"level", l},
                      {"cells", {frame.size.cols, frame.size.rows}},
                      {"spacing_mm", frame.spacing_mm},
                      {"sigma_mm", smoothingMm(ladder, {static_cast<int>(l)})},
                      {"file", levelFile(map.file, static_cast<int>(l)).string()}});
  }
  return levels;
}

Json reportOf(const LargeMap& map, double factor) {
  const GridFrame& frame = map.frames.front();
  Json json;
  json["cells"] = {frame.size.cols, frame.size.rows};
  json["spacing_mm"] = frame.spacing_mm;
  json["engine"] = map.engine;
  json["rule"] = map.rule;
  json["shares"] = sharesJson(map.shares);
  json["view_from_file"] = batch::jsonOf(map.view_from_file);
  json["height_mm"] = {{"min", map.heights.min_mm}, {"max", map.heights.max_mm}};
  json["seconds"] = {{"first_view", map.first_view_s}, {"read", map.seconds.read},
                     {"grid", map.seconds.grid},       {"fill", map.seconds.fill},
                     {"pyramid", map.seconds.pyramid}, {"colours", map.seconds.colours}};
  json["colour_file"] = map.has_colours ? Json(colourFileOf(map.file).string()) : Json(nullptr);
  json["intensity_file"] =
      map.has_intensities ? Json(intensityFileOf(map.file).string()) : Json(nullptr);
  json["spilled_bytes"] = map.spilled_bytes;
  json["taken_over"] = map.taken_over ? Json{{"points", map.taken_over->points},
                                             {"point_parts", map.taken_over->parts},
                                             {"rows_of_tiles", map.taken_over->rows},
                                             {"filled_rows_of_tiles", map.taken_over->filled},
                                             {"damaged", map.taken_over->damaged}}
                                      : Json(nullptr);
  json["view"] = map.view_name;
  json["unit"] = name(map.unit);
  json["unit_source"] = name(map.unit_source);
  json["holes"] = holesJson(map.holes);
  json["losses"] = lossesJson(map.losses);
  json["strays"] = straysJson(map.strays);
  json["missing"] = map.missing;
  json["not_done"] = sentencesJson(map.not_done);
  json["levels"] = levelsJson(map, factor);
  return json;
}

std::vector<std::filesystem::path> namesOf(const MapArguments& arguments,
                                           const TileArguments& tiles) {
  std::vector<std::filesystem::path> names{arguments.file};
  names.insert(names.end(), tiles.more.begin(), tiles.more.end());
  return names;
}

}  // namespace

std::string timeLeftWords(double seconds, double began_at, double fraction) {
  constexpr double kMinuteS = 60, kHourS = 3600;
  const std::optional<double> estimate = secondsLeft(seconds, began_at, fraction);
  if (!estimate) return {};
  const double left = *estimate;
  const auto about = [](double number, const char* unit) {
    return ", about " + std::to_string(static_cast<long>(std::ceil(number))) + unit + " left of it";
  };
  if (left < kMinuteS) return about(5 * std::ceil(left / 5), " s");
  return left < 2 * kHourS ? about(left / kMinuteS, " min") : about(left / kHourS, " h");
}

void addTileOptions(CLI::App& verb, TileArguments& tiles) {
  verb.add_option("MORE", tiles.more,
                  "With --memory: further files of the same scan; each name, also FILE, may be a "
                  "folder, a pattern, a list or a tile index of LAS, LAZ or PLY files");
  takes(verb.add_option(
            "--memory", tiles.memory_mb,
            "Make the map by tiles within so many MB (LAS, LAZ, binary PLY, rasters); all "
            "levels are written"),
        {.low = 64, .high = 1e9, .unit = "MB"});
  takes(verb.add_option("--threads", tiles.threads,
                        "With --memory: so many work at once (usually one for each core that this "
                        "process may use)"),
        {.low = 1, .high = kMostThreads});
  verb.add_option("--job", tiles.job,
                  "With --memory: keep what is finished in this folder, so that the same command "
                  "goes on after it was stopped");
}

bool areGiven(const TileArguments& tiles) {
  if (!processes().isAlone() && (!tiles.memory_mb || tiles.job.empty())) {
    throw failure<MessageId::processes_need_folder>();
  }
  if (tiles.threads && !tiles.memory_mb) {
    throw failure<MessageId::option_needs_other>("--threads", "--memory");
  }
  if (!tiles.job.empty() && !tiles.memory_mb) {
    throw failure<MessageId::option_needs_other>("--job", "--memory");
  }
  if (!tiles.more.empty() && !tiles.memory_mb) throw failure<MessageId::several_need_memory>();
  return tiles.memory_mb.has_value();
}

std::vector<std::filesystem::path> filesOf(const MapArguments& arguments,
                                           const TileArguments& tiles) {
  if (!tiles.memory_mb) return {arguments.file};
  return filesNamed(namesOf(arguments, tiles));
}

CommandResult runByTiles(const MapArguments& arguments, const TileArguments& tiles,
                         const std::filesystem::path& finest, const Task& task) {
  const double memory_mb = tiles.memory_mb.value_or(0);
  if (!(memory_mb > 0) || !(memory_mb < 1e9)) {
    throw failure<MessageId::option_memory>();
  }
  const ImportOptions import = importOptions(arguments.scan);
  if (import.scan.every != 1) throw failure<MessageId::option_every_by_tiles>();
  ProgressLine line(::isatty(STDERR_FILENO) != 0);
  const Task shown{.stop = task.stop, .progress = [&](std::string_view step, double fraction) {
                     line.show(step, fraction);
                   }};
  TiledWork work{.names = namesOf(arguments, tiles),
                 .out = finest,
                 .options = surfaceOptions(arguments),
                 .import = import,
                 .memory_bytes = static_cast<std::uint64_t>(memory_mb * 1e6),
                 .threads = tiles.threads.value_or(0),
                 .job_folder = tiles.job,
                 .processes = &processes(),
                 .on_view = [&](const Surface& view) {
                   line.clear();
                   sayView(view);
                 }};
  const LargeMap map = makeTiledMap(work, shown);
  line.clear();
  for (const Message& message : map.messages) tell(englishText(message));
  for (const Message& left : map.not_done) tell(englishText(left));
  tellUnusedMapOptions(arguments, map);
  Json json = reportOf(map, arguments.factor);
  json["processes"] = processes().ranks();
  json["exchanged_bytes"] = processes().sentBytes();
  CommandResult outcome{.json = reportText(json), .lines = {}};
  for (const Json& level : json["levels"]) {
    outcome.lines.push_back(level["file"].get<std::string>() + ": " + level["cells"][0].dump() +
                            " x " + level["cells"][1].dump());
  }
  outcome.lines.push_back("cells: " + sharesText(map.shares));
  outcome.lines.push_back(lossesText(map.losses));
  outcome.exit_code = map.not_done.empty() ? 0 : 4;
  return outcome;
}

Surface openForVerb(const MapArguments& arguments, const Task& task) {
  if (!TiledMap::isOne(arguments.file)) return loadForVerb(arguments, task);
  surfaceOptions(arguments);  // Words that make no sense are refused here as well.
  Surface surface = openTiledSurface(arguments.file);
  tellUnusedMapOptions(arguments, surface);
  if (surface.ladder.factor != arguments.factor) {
    tell("The map's levels were made with M = " + Json(surface.ladder.factor).dump() +
         " and are used as they are.");
  }
  return surface;
}

}  // namespace relievo::batch
