// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

namespace relievo::falcon {

/// Which question is answered by which answer, and what is to be done when none comes: measures
/// after 5, 10 and 15 ms, then one every 20 ms. All ask again, with zero force: a bad line gets
/// many chances before the processor is taken for dead. No clock of its own. [link]
class Silence {
 public:
  static constexpr std::int64_t kMs = 1'000'000;
  static constexpr int kStall = 3;  ///< The measure at 20 ms.

  static constexpr std::int64_t measureAfter(int step) {
    return step < kStall ? (step + 1) * 5 * kMs : (step - kStall + 1) * 20 * kMs;
  }

  /// It runs anew, or what was under way was thrown away: now counts as an answer.
  void restart(std::int64_t now_ns) {
    last_answer_ns_ = now_ns;
    under_way_ = step_ = 0;
    doubtful_ = false;
  }
  /// A question goes out. @param at_rest  its answer tells nothing of the pace
  void ask(std::int64_t now_ns, bool at_rest) {
    if (under_way_ == 0) {  // Else the answer is waited for since the first of them.
      asked_ns_ = now_ns;
      asked_at_rest_ = at_rest;
    }
    ++under_way_;
  }
  /// An answer has come, of which one question less is under way.
  void answer() {
    under_way_ = std::max(0, under_way_ - 1);
    if (under_way_ == 0) doubtful_ = false;
  }
  /// It was counted: silence begins now.
  void heard(std::int64_t now_ns) {
    wake(now_ns);
    failed_reads_ = 0;
  }
  /// It rested, and silence begins now.
  void wake(std::int64_t now_ns) {
    last_answer_ns_ = now_ns;
    step_ = 0;
  }
  /// A read broke off. @return how many did in a row, without an answer between them
  int failRead() { return ++failed_reads_; }
  /// Asked again because an answer may be lost, or only late: then two will come, or else one would
  /// stay queued for ever. If only one comes, the next silence settles it.
  void askedAgain(bool two_may_come) {
    doubtful_ = two_may_come;
    under_way_ = doubtful_ ? 2 : 1;
  }
  /// The measure that is due; a write that waits for the bridge takes longer than several.
  int nextMeasure(std::int64_t now_ns) {
    while (step_ < kStall && now_ns - last_answer_ns_ >= measureAfter(step_ + 1)) ++step_;
    return step_++;
  }

  bool isUnderWay() const { return under_way_ > 0; }
  bool isDoubtful() const { return doubtful_; }
  int underWay() const { return under_way_; }
  int step() const { return step_; }
  std::int64_t lastAnswerNs() const { return last_answer_ns_; }
  std::int64_t askedNs() const { return asked_ns_; }
  bool askedAtRest() const { return asked_at_rest_; }

 private:
  std::int64_t last_answer_ns_ = 0, asked_ns_ = 0;
  int under_way_ = 0;           // Questions without an answer.
  int step_ = 0;                // How far the measures have gone.
  int failed_reads_ = 0;        // In a row.
  bool asked_at_rest_ = false;  // At asked_ns_.
  bool doubtful_ = false;       // One of those under way may have lost its answer.
};

}  // namespace relievo::falcon
