// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/published/windows_ahead.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <limits>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/failure.h"
#include "core/tiles/published/published_tiles.h"

namespace relievo {
namespace {

constexpr std::chrono::seconds kUntilAskedAgain{1};
constexpr int kNothing = std::numeric_limits<int>::max();  ///< No level was given.

/// What was given last of a wish.
struct Shown {
  int level = kNothing;
  bool coloured = false;
};

Region aboutCentre(const Region& region, double scale, int level) {
  const double side = scale * region.side_mm;
  return {.x_mm = region.centreX() - 0.5 * side,
          .y_mm = region.centreY() - 0.5 * side,
          .side_mm = side,
          .level = {level}};
}

struct Wish {
  Region region;
  double gain = 1;
};

}  // namespace

struct WindowsAhead::Impl {
  Impl(std::shared_ptr<const TiledMap> tiled, Calls whom);

  void lineUp(const Region& region);
  void give(const std::stop_token& stop);
  void giveBetter(const Wish& now, Shown& shown);
  void sayDetail(int level, int wanted);
  void fetch(const std::stop_token& stop);
  void takeEnd(const TileName& tile, const std::exception_ptr& error);
  void say(const Message& message);

  std::shared_ptr<const TiledMap> map;
  Calls calls;

  std::mutex mutex;
  std::condition_variable_any changed;
  // Under the mutex:
  std::optional<Wish> wish;
  std::optional<Region> before;  ///< The wish before: says where it goes.
  std::uint64_t wishes = 0, arrivals = 0;
  std::deque<TileName> queue;
  std::set<TileName> under_way, refused;
  bool lost = false;
  std::chrono::steady_clock::time_point ask_again;
  std::deque<Message> to_say;

  bool said_coarser = false;  ///< Last. [the thread that gives]

  std::vector<std::jthread> threads;  ///< Last: they join before what they use goes.
};

WindowsAhead::Impl::Impl(std::shared_ptr<const TiledMap> tiled, Calls whom)
    : map(std::move(tiled)), calls(std::move(whom)) {
  threads.emplace_back([this](const std::stop_token& stop) { give(stop); });
  for (int i = 0; i < kWebConnections; ++i) {
    threads.emplace_back([this](const std::stop_token& stop) { fetch(stop); });
  }
}

/// What is to be fetched for a wish, what is needed first in front. Under the mutex.
void WindowsAhead::Impl::lineUp(const Region& region) {
  queue.clear();
  const auto add = [this](const Region& part) {
    for (const TileName& tile : map->tilesUnder(part)) {
      const bool comes = under_way.contains(tile) || refused.contains(tile) ||
                         std::find(queue.begin(), queue.end(), tile) != queue.end();
      if (!comes && !map->isAtHand(tile)) queue.push_back(tile);
    }
  };
  const double factor = map->ladder().factor;
  const int level = region.level.value;
  const auto coarser = map->levelAtHand(region);
  // Until the wanted level is here the next coarser one is felt, which comes sooner.
  if (!coarser || coarser->value > level + 1) add(aboutCentre(region, 1, level + 1));
  add(region);
  if (before && before->level == region.level) {
    Region next = region;
    for (int step = 0; step < 3; ++step) {
      next.x_mm += region.x_mm - before->x_mm;
      next.y_mm += region.y_mm - before->y_mm;
      add(next);
    }
  }
  add(aboutCentre(region, 2 * factor, level + 1));
  add(aboutCentre(region, 1.5, level));
  add(aboutCentre(region, 1 / factor, level - 1));
}

void WindowsAhead::Impl::say(const Message& message) {
  to_say.push_back(message);
  changed.notify_all();
}

/// Under the mutex.
void WindowsAhead::Impl::takeEnd(const TileName& tile, const std::exception_ptr& error) {
  under_way.erase(tile);
  ++arrivals;
  try {
    if (error) std::rethrow_exception(error);
    if (std::exchange(lost, false)) say(said<MessageId::web_server_back>(map->place()));
  } catch (const WebLost&) {
    if (!std::exchange(lost, true)) say(said<MessageId::web_server_lost>(map->place()));
    ask_again = std::chrono::steady_clock::now() + kUntilAskedAgain;
    queue.push_front(tile);
  } catch (const std::exception& other) {
    refused.insert(tile);  // It would be refused again.
    say(messageOf(other));
  }
}

void WindowsAhead::Impl::fetch(const std::stop_token& stop) {
  std::unique_lock lock(mutex);
  Task task;
  task.stop = stop;
  while (changed.wait(lock, stop, [this] { return !queue.empty(); })) {
    const auto now = std::chrono::steady_clock::now();
    if (lost && now < ask_again) {
      changed.wait_until(lock, stop, ask_again, [] { return false; });
      continue;
    }
    // Of a server that gave no answer one tile is asked for at a time.
    if (lost) ask_again = now + kUntilAskedAgain;
    const TileName tile = queue.front();
    queue.pop_front();
    under_way.insert(tile);
    lock.unlock();
    std::exception_ptr error;
    try {
      map->tile({tile.level}, tile.part, tile.number, task);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    if (stop.stop_requested()) return;
    takeEnd(tile, error);
    changed.notify_all();
  }
}

/// Outside the mutex. Gives a finer window than is shown, or the same with its colours.
void WindowsAhead::Impl::giveBetter(const Wish& now, Shown& shown) {
  const auto level = map->levelAtHand(now.region);
  if (!level || level->value > shown.level) return;
  Region region = now.region;
  region.level = *level;
  const bool coloured = map->coloursAtHand(region);
  if (level->value == shown.level && (shown.coloured || !coloured)) return;
  try {
    calls.give({.window = std::make_shared<const RegionWindow>(map->window(region, now.gain)),
                .wanted = now.region.level,
                .coloured = coloured});
  } catch (const Error& error) {
    // Its tiles went from the cache meanwhile, and could not be fetched again.
    if (calls.say) calls.say(messageOf(error));
    return;
  }
  shown = {.level = level->value, .coloured = coloured};
  sayDetail(level->value, now.region.level.value);
}

/// While somebody goes over a map that comes slowly every window is coarser: that is said once.
void WindowsAhead::Impl::sayDetail(int level, int wanted) {
  const bool is_coarser = wanted < level;
  if (std::exchange(said_coarser, is_coarser) == is_coarser || !calls.say) return;
  const DetailLadder& ladder = map->ladder();
  const int detail = ladder.detailOf({level});
  calls.say(is_coarser ? said<MessageId::web_level_coarser>(detail, ladder.detailOf({wanted}))
                       : said<MessageId::web_level_complete>(detail));
}

void WindowsAhead::Impl::give(const std::stop_token& stop) {
  std::uint64_t wishes_seen = 0, arrivals_seen = 0;
  Shown shown;
  std::unique_lock lock(mutex);
  while (changed.wait(lock, stop, [&] {
    return wishes != wishes_seen || arrivals != arrivals_seen || !to_say.empty();
  })) {
    if (!to_say.empty()) {
      const Message message = to_say.front();
      to_say.pop_front();
      lock.unlock();
      if (calls.say) calls.say(message);
      lock.lock();
      continue;
    }
    arrivals_seen = arrivals;
    if (!wish) continue;
    if (std::exchange(wishes_seen, wishes) != wishes) {
      shown = {};
      lineUp(wish->region);
      changed.notify_all();
    }
    const Wish now = *wish;
    lock.unlock();
    giveBetter(now, shown);
    lock.lock();
  }
}

WindowsAhead::WindowsAhead(std::shared_ptr<const TiledMap> map, Calls calls)
    : impl_(std::make_unique<Impl>(std::move(map), std::move(calls))) {}

WindowsAhead::~WindowsAhead() {
  for (std::jthread& thread : impl_->threads) thread.request_stop();
}

void WindowsAhead::want(const Region& region, double gain) {
  {
    const std::scoped_lock lock(impl_->mutex);
    if (impl_->wish) impl_->before = impl_->wish->region;
    impl_->wish = Wish{region, gain};
    ++impl_->wishes;
  }
  impl_->changed.notify_all();
}

std::shared_ptr<const RegionWindow> WindowsAhead::atHand(const TiledMap& map, const Region& region,
                                                         double gain) {
  const auto level = map.levelAtHand(region);
  if (!level) return nullptr;
  Region at = region;
  at.level = *level;
  return std::make_shared<const RegionWindow>(map.window(at, gain));
}

}  // namespace relievo
