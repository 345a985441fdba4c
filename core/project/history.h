// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace relievo {

/// Named steps between states, forward and back; a plain value without threads or widgets. Big
/// parts of a state are shared (`shared_ptr<const T>`), so that a step costs what it changed.
template <class State>
class History {
 public:
  static constexpr std::size_t kSteps = 500;

  /// @param steps  how many can be undone at most; the oldest are forgotten first; at least 1
  explicit History(State first, std::size_t steps = kSteps) : steps_(steps < 1 ? 1 : steps) {
    entries_.push_back({.name = {}, .state = std::move(first)});
  }

  const State& now() const { return entries_[place_].state; }

  /// One step on; what was undone before is forgotten.
  /// @param name   "Level 2 -> 1", as in "Undo: Level 2 -> 1"
  /// @param merge  steps of one gesture have the same number, not 0, and become one
  void push(std::string name, State state, std::size_t merge = 0) {
    entries_.resize(place_ + 1, entries_.front());
    if (merge != 0 && entries_.back().merge == merge && place_ > 0) {
      entries_.back().state = std::move(state);
      return;
    }
    entries_.push_back({.name = std::move(name), .state = std::move(state), .merge = merge});
    ++place_;
    while (entries_.size() > steps_ + 1) {
      entries_.pop_front();
      --place_;
    }
  }

  bool canUndo() const { return place_ > 0; }
  bool canRedo() const { return place_ + 1 < entries_.size(); }
  /// Back and forth by one step; nothing at the end. A gesture does not go on after it.
  bool undo() {
    if (!canUndo()) return false;
    entries_[place_].merge = 0;
    --place_;
    entries_[place_].merge = 0;
    return true;
  }
  bool redo() {
    if (!canRedo()) return false;
    ++place_;
    return true;
  }
  std::string undoName() const { return canUndo() ? entries_[place_].name : std::string(); }
  std::string redoName() const { return canRedo() ? entries_[place_ + 1].name : std::string(); }

  /// Names of the steps that led to now, oldest first.
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (std::size_t i = 1; i <= place_; ++i) names.push_back(entries_[i].name);
    return names;
  }

 private:
  struct Entry {
    std::string name;
    State state;
    std::size_t merge = 0;
  };
  std::size_t steps_;
  std::deque<Entry> entries_;  ///< The first has no name: where it began.
  std::size_t place_ = 0;
};

}  // namespace relievo
