// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/message/message.h"
#include "ui/work/latest_worker.h"

namespace relievo {

struct Surface;

/// What can be said of the object of a visit, found by a worker. [GUI thread]
class ExhibitFacts {
 public:
  static constexpr std::size_t kMost = 3;  ///< More are not kept in mind.
  using Take = std::function<void(const std::vector<Message>& facts)>;

  /// Null: there is nothing to say.
  void find(const std::shared_ptr<const Surface>& surface);
  /// Gives them away now, or as soon as they are known.
  void give(Take take);
  bool areAwaited() const { return awaits_ != nullptr; }

 private:
  std::vector<Message> facts_;
  Take awaits_;
  LatestWorker worker_;  // Ends first.
};

}  // namespace relievo
