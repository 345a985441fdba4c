// SPDX-License-Identifier: BSD-3-Clause
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "core/base/error.h"
#include "core/tiles/tiled_map.h"

namespace relievo {

struct TilePrefetcher::Impl {
  explicit Impl(std::shared_ptr<const TiledMap> tiled) : map(std::move(tiled)) {
    thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }

  void run(const std::stop_token& stop);
  void load(const Region& region);

  std::shared_ptr<const TiledMap> map;
  std::mutex mutex;
  std::condition_variable_any changed;
  std::optional<Region> wanted;  ///< Under the mutex, as the next.
  bool busy = false;
  std::jthread thread;  ///< Last: stops and joins before what it uses goes.
};

void TilePrefetcher::Impl::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex);
  while (changed.wait(lock, stop, [this] { return wanted.has_value(); })) {
    const Region region = *std::exchange(wanted, std::nullopt);
    busy = true;
    lock.unlock();
    load(region);
    lock.lock();
    busy = false;
    changed.notify_all();
  }
}

void TilePrefetcher::Impl::load(const Region& region) {
  const auto about_centre = [&](double scale, int level) {
    const double side = scale * region.side_mm;
    return Region{.x_mm = region.centreX() - 0.5 * side,
                  .y_mm = region.centreY() - 0.5 * side,
                  .side_mm = side,
                  .level = {level}};
  };
  const double factor = map->ladder().factor;
  const int level = region.level.value;
  try {
    map->prefetch(about_centre(1.5, level));
    map->prefetch(about_centre(1 / factor, level - 1));
    map->prefetch(about_centre(factor, level + 1));
  } catch (const Error&) {
    // A damaged file: whoever asks for the window is told.
  }
}

TilePrefetcher::TilePrefetcher(std::shared_ptr<const TiledMap> map)
    : impl_(std::make_unique<Impl>(std::move(map))) {}
TilePrefetcher::~TilePrefetcher() = default;

void TilePrefetcher::around(const Region& region) {
  {
    const std::scoped_lock lock(impl_->mutex);
    impl_->wanted = region;
  }
  impl_->changed.notify_all();
}

void TilePrefetcher::wait() {
  std::unique_lock lock(impl_->mutex);
  impl_->changed.wait(lock, [this] { return !impl_->wanted && !impl_->busy; });
}

}  // namespace relievo
