// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/measure_readings.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/session/map_facts.h"
#include "core/tiles/tiled_map.h"
#include "ui/language/error_text.h"

namespace relievo {
namespace {

/// But for the name.
bool readsTheSame(const Measurement& a, const Measurement& b) {
  return a.kind == b.kind && a.places == b.places && a.plane_mm == b.plane_mm &&
         a.normal == b.normal;
}

/// Of the finest level around a place: all that its height is read from is within.
Region placeAbout(const Surface& surface, const PlaceMm& place) {
  constexpr double kCells = 6;
  const double side = kCells * surface.ladder.spacings_mm.front();
  return {
      .x_mm = place.x - 0.5 * side, .y_mm = place.y - 0.5 * side, .side_mm = side, .level = {0}};
}

/// Of a larger map an area may take longer than the window may be held up.
constexpr std::size_t kMostCellsAtOnce = 1'000'000;

bool atOnce(const Surface& surface, MeasureKind kind) {
  if (surface.tiles && surface.tiles->isRemote()) return false;  // It may have to be fetched.
  switch (kind) {
    case MeasureKind::section:
      return false;
    case MeasureKind::profile:
      return surface.tiles == nullptr;
    case MeasureKind::area:
      return surface.tiles == nullptr && surface.map.frame.size.count() <= kMostCellsAtOnce;
    default:
      return true;
  }
}

MeasureReadings::Entry entryOf(const MapCells& cells, const Measurement& m) {
  MeasureReadings::Entry entry;
  try {
    entry.reading = read(cells, m);
    if (m.kind == MeasureKind::profile) entry.rows = profile(cells, m.places);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    entry.problem = spokenError(error);
  }
  return entry;
}

}  // namespace

MeasureReadings::MeasureReadings(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&document_, &Document::surfaceChanged, this, [this] {
    worker_.cancel();
    known_.clear();
  });
}

std::shared_ptr<const MeasureReadings::Entry> MeasureReadings::of(const Measurement& m) {
  const auto found = std::find_if(known_.begin(), known_.end(),
                                  [&](const Known& known) { return readsTheSame(known.first, m); });
  if (found != known_.end()) return found->second;
  const Surface& surface = *document_.surface();
  if (atOnce(surface, m.kind)) {
    known_.emplace_back(m, std::make_shared<const Entry>(entryOf(mapCells(surface), m)));
  } else {
    known_.emplace_back(m, nullptr);
    // Several may be missing: one job reads them all.
    if (!std::exchange(asked_, true)) {
      QMetaObject::invokeMethod(
          this, [this] { readMissing(); }, Qt::QueuedConnection);
    }
  }
  return known_.back().second;
}

void MeasureReadings::keepOnly(const std::vector<Measurement>& list) {
  std::erase_if(known_, [&](const Known& known) {
    return std::none_of(list.begin(), list.end(),
                        [&](const Measurement& m) { return readsTheSame(known.first, m); });
  });
}

bool MeasureReadings::isHere(const PlaceMm& place) const {
  const Surface& surface = *document_.surface();
  if (!surface.tiles || !surface.tiles->isRemote()) return true;
  return surface.tiles->levelAtHand(placeAbout(surface, place)) == Level{0};
}

void MeasureReadings::fetch(const PlaceMm& place) {
  const auto surface = document_.surface();
  fetcher_.start(
      [surface, region = placeAbout(*surface, place)](const Task& task) {
        try {
          for (const TileName& tile : surface->tiles->tilesUnder(region)) {
            surface->tiles->tile({tile.level}, tile.part, tile.number, task);
          }
        } catch (const Error&) {  // Whoever asks again is told that it is not here.
        }
      },
      [] {});
}

std::optional<SurfacePoint> MeasureReadings::pointAt(const PlaceMm& place) const {
  if (!isHere(place)) return std::nullopt;
  return surfacePoint(mapCells(*document_.surface()), place);
}

void MeasureReadings::readMissing() {
  asked_ = false;
  const auto missing = std::make_shared<std::vector<Known>>();
  std::copy_if(known_.begin(), known_.end(), std::back_inserter(*missing),
               [](const Known& known) { return known.second == nullptr; });
  if (missing->empty()) return;
  worker_.start(
      [missing, surface = document_.surface()](const Task& task) {
        try {
          const MapCells cells = mapCells(*surface, task);
          for (auto& [m, entry] : *missing) {
            entry = std::make_shared<const Entry>(entryOf(cells, m));
          }
        } catch (const Cancelled&) {
          return;  // Of another surface, or asked for again with others.
        }
      },
      [this, missing] {
        for (const auto& [m, entry] : *missing) {
          for (Known& known : known_) {
            if (readsTheSame(known.first, m)) known.second = entry;
          }
        }
        Q_EMIT changed();
      });
}

}  // namespace relievo
