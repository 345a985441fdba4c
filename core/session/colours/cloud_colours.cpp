// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/colours/cloud_colours.h"

#include <string>

#include "core/io/raster/colour_raster.h"
#include "core/io/raster/tiff_head.h"
#include "core/message/catalogue.h"
#include "core/session/choices.h"
#include "core/session/colours/surface_colours.h"
#include "core/tiles/level_files.h"
#include "core/tiles/points/scatter.h"

namespace relievo {

std::filesystem::path spillFolder(const LargeMapOptions& large) {
  return large.file.parent_path().empty() ? "." : large.file.parent_path();
}

bool takeValues(LargeMap& map, const StreamedValues& values, const MemoryPlan& plan) {
  say(map.messages, values.warnings());
  if (!values.any()) return false;
  map.info.colour = values.colourFact();
  map.info.intensity = values.intensityRange();
  if (plan.values_bytes > 0) return true;
  constexpr std::uint64_t kMegabyte = 1'000'000;
  map.not_done.push_back(
      said<MessageId::colours_need_memory>((plan.colours_need + kMegabyte - 1) / kMegabyte));
  return false;
}

void requireFreeNames(const std::vector<GridFrame>& frames, const std::filesystem::path& finest) {
  for (std::size_t level = 0; level < frames.size(); ++level) {
    ColourFiles::requireFree(levelFile(finest, static_cast<int>(level)));
  }
}

bool hasOwnColours(const std::filesystem::path& map_file) {
  std::error_code unknown;
  for (const std::filesystem::path& file : {colourFileOf(map_file), intensityFileOf(map_file)}) {
    if (std::filesystem::exists(file, unknown) && isOwnTiff(file)) return true;
  }
  return false;
}

CloudColours::CloudColours(const LargeMap& map, const GridFrame& frame,
                           const StreamedValues& values,
                           const std::function<bool(const FilePoint&)>& keeps,
                           const LargeMapOptions& large, std::size_t memory_bytes, const Task& task)
    : values_(values),
      file_(large.file),
      store_(frame.size, {.merges = false,
                          .memory_bytes = memory_bytes,
                          .spill_folder = spillFolder(large),
                          .threads = large.threads}),
      colours_(store_, frame,
               scatterValues(values.source(keeps), map.view_from_file, frame, store_, task),
               {.rule = colourRuleOf(map.rule),
                .colours = values.hasColours(),
                .intensities = values.hasIntensities(),
                .spill_folder = spillFolder(large)}) {}

std::unique_ptr<ColourFiles> CloudColours::write(LargeMap& map, double factor, const Task& task) {
  colours_.close(task);
  map.has_colours = colours_.hasColours();
  map.has_intensities = colours_.hasIntensities();
  if (!map.has_colours && !map.has_intensities) return nullptr;
  auto files = std::make_unique<ColourFiles>(file_, map.frames, factor, map.has_colours,
                                             map.has_intensities);
  colours_.write(
      [&](const Rgba* colours, const GreyAlpha* intensities) { files->add(colours, intensities); },
      task);
  const std::size_t measured = colours_.measuredCells();
  if (map.has_colours) {
    map.messages.push_back(colourWords({measured, colours_.colouredCells()}));
  }
  if (map.has_intensities) {
    map.messages.push_back(intensityWords({measured, colours_.intensityCells()},
                                          colours_.shownIntensities(values_.intensityRange())));
  }
  map.spilled_bytes += store_.spilledBytes();
  return files;
}

}  // namespace relievo
