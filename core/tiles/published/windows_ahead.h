// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "core/region/window.h"
#include "core/tiles/tiled_map.h"

namespace relievo {

struct Message;

/// Windows of a map whose tiles may be far away, for whoever must not wait: the window that can be
/// had at once, of a coarser level if need be, and then the one that was wanted. Fetches by threads
/// of its own: what is wanted first, then a level coarser around it, then what lies ahead of the
/// movement. What nobody wants any more is not asked for. A server that gives no answer is asked
/// again every second. That a window is coarser than wanted, that none is any more, that the server
/// gives no answer and that it answers again is said once each. docs/adr/0201.
class WindowsAhead {
 public:
  struct Given {
    std::shared_ptr<const RegionWindow> window;  ///< Its level is the one that it was cut from.
    Level wanted;                                ///< Finer than that: it follows.
    bool coloured = false;  ///< Its colours are in memory, too, if it has any; else they follow.
  };
  /// Called by a thread of this object, in order; they must not wait for it.
  struct Calls {
    std::function<void(const Given&)> give;
    std::function<void(const Message&)> say;  ///< May be empty.
  };

  WindowsAhead(std::shared_ptr<const TiledMap> map, Calls calls);
  /// No call is made after this returns.
  ~WindowsAhead();
  WindowsAhead(const WindowsAhead&) = delete;
  WindowsAhead& operator=(const WindowsAhead&) = delete;

  /// Replaces what was wanted before. Does not wait. [any thread but the haptic loop]
  void want(const Region& region, double gain = 1);

  /// The best window that needs nothing to be fetched. Nothing: no level is there at all, which a
  /// map from the web does not have. [any thread but the haptic loop] @throw as TiledMap::window
  static std::shared_ptr<const RegionWindow> atHand(const TiledMap& map, const Region& region,
                                                    double gain);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
