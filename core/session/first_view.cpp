// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/first_view.h"

#include "core/base/error.h"
#include "core/io/input_facts.h"
#include "core/io/point_stream.h"
#include "core/session/large/large_map.h"
#include "core/session/large/tiled_surface.h"
#include "core/tiles/published/published_tiles.h"

namespace relievo {
namespace {

constexpr std::uint64_t kFirstSample = 250'000;
constexpr std::uint64_t kSecondSample = 2'000'000;
constexpr std::uint64_t kWorthASecond = 10;  ///< Times the sample.

FirstView viewOfTiles(const std::filesystem::path& file) {
  FirstView view;
  view.surface = openTiledSurface(file);
  view.used = view.surface.map.frame.size.count();
  view.all = view.surface.info.points;
  return view;
}

void viewsOfPoints(const std::filesystem::path& file, const SurfaceOptions& options,
                   const ImportOptions& import, const FirstViewOptions& views, const Task& task) {
  const std::uint64_t all = PointStream(file, import).info().points;
  if (all < views.least_points) return;
  for (const std::uint64_t wanted : {kFirstSample, kSecondSample}) {
    if (wanted != kFirstSample && all < kWorthASecond * wanted) return;
    FirstView view;
    view.surface = sampleSurface(file, options, wanted, import, task);
    view.used = view.surface.info.finite_points;
    view.all = all;
    views.on_view(view);
  }
}

}  // namespace

void makeFirstViews(const std::filesystem::path& file, const SurfaceOptions& options,
                    const ImportOptions& import, const FirstViewOptions& views, const Task& task) {
  try {
    const InputFacts facts = inputFacts(file, task);
    if (facts.kind == InputKind::tiled_map) {
      // One from the web is fetched once: what comes of it first is the map itself.
      if (addressOfKeptMap(file).empty()) views.on_view(viewOfTiles(file));
    } else if (facts.in_blocks) {
      viewsOfPoints(file, options, import, views, task);
    }
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    return;  // The file's reader comes next and says it.
  }
}

}  // namespace relievo
