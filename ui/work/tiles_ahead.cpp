// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/tiles_ahead.h"

#include "core/tiles/published/windows_ahead.h"
#include "core/tiles/tiled_map.h"

namespace relievo {

TilesAhead::TilesAhead(std::shared_ptr<const TiledMap> map) : map_(std::move(map)) {
  if (!map_->isRemote()) {
    files_ = std::make_unique<TilePrefetcher>(map_);
    return;
  }
  // Its threads leave what they have for this one.
  web_ = std::make_unique<WindowsAhead>(
      map_, WindowsAhead::Calls{.give =
                                    [this](const WindowsAhead::Given& given) {
                                      QMetaObject::invokeMethod(
                                          this,
                                          [this, window = given.window, coloured = given.coloured] {
                                            take(window, coloured);
                                          },
                                          Qt::QueuedConnection);
                                    },
                                .say =
                                    [this](const Message& message) {
                                      QMetaObject::invokeMethod(
                                          this, [this, message] { Q_EMIT said(message); },
                                          Qt::QueuedConnection);
                                    }});
}

TilesAhead::~TilesAhead() = default;

std::shared_ptr<const RegionWindow> TilesAhead::now(const TiledMap& map, const Region& region,
                                                    double gain) {
  if (map.isRemote()) {
    if (auto window = WindowsAhead::atHand(map, region, gain)) return window;
  }
  return std::make_shared<const RegionWindow>(map.window(region, gain));
}

void TilesAhead::around(const Region& wanted, const RegionWindow& shown) {
  if (files_) return files_->around(wanted);
  shown_ = shown.region;
  gain_ = shown.gain;
  coloured_ = map_->coloursAtHand(shown_);
  web_->want(wanted, gain_);
}

void TilesAhead::take(const std::shared_ptr<const RegionWindow>& window, bool coloured) {
  Region place = window->region;
  place.level = shown_.level;
  if (place != shown_ || window->gain != gain_) return;  // Of an earlier wish.
  const bool is_finer = window->region.level < shown_.level;
  const bool has_colours = window->region.level == shown_.level && coloured && !coloured_;
  if (!is_finer && !has_colours) return;
  shown_ = window->region;
  coloured_ = coloured;
  Q_EMIT better(window);
}

}  // namespace relievo
