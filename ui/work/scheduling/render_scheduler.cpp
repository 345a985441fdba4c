// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/scheduling/render_scheduler.h"

#include <utility>

namespace relievo {
namespace {
constexpr qint64 kLongRoundMs = 20;
// On a busy computer, and while somebody drags, every round is long: nobody waits for more than
// one.
constexpr int kMostRests = 2;
}  // namespace

void RenderScheduler::schedule(QObject* who, std::function<void()> work) {
  turns_.push_back({who, std::move(work)});
  if (!next_.isActive()) next_.start(0, this);
}

// The timer comes once a round: perhaps in the one of what asked, of the painting of the picture
// before, or of a worker's result.
void RenderScheduler::timerEvent(QTimerEvent* /*event*/) {
  const bool was_long = !since_round_.isValid() || since_round_.restart() > kLongRoundMs;
  if (!since_round_.isValid()) since_round_.start();
  if (std::exchange(worked_, false)) return;
  if (was_long && ++rests_ < kMostRests) return;
  rests_ = 0;
  worked_ = true;
  while (!turns_.empty()) {
    const Turn turn = std::move(turns_.front());
    turns_.pop_front();
    if (!turn.who) continue;
    turn.work();
    break;
  }
  since_round_.start();
  if (turns_.empty()) next_.stop();
}

}  // namespace relievo
