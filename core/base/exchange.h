// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace relievo {

/// Another of the processes cannot go on, so that this one does not either.
struct OtherProcessStopped : std::runtime_error {
  OtherProcessStopped() : std::runtime_error("another process stopped") {}
};

/// Processes that make one map together: all run the same program on the same input and tell each
/// other what each found out alone. Everything large goes through files that all of them see
/// (JobFolder); what is told here is facts and bits. docs/adr/0232. [one thread]
class Exchange {
 public:
  /// Why a process could not go on.
  struct Stopped {
    int rank = 0;
    int exit_code = 0;
    std::string sentence;
  };

  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
  virtual ~Exchange() = default;

  int rank() const noexcept { return rank_; }  ///< 0 ... ranks() - 1; 0 writes the map.
  int ranks() const noexcept { return ranks_; }
  bool isFirst() const noexcept { return rank_ == 0; }
  bool isAlone() const noexcept { return ranks_ == 1; }

  /// What every process says at this place of the work, by rank. It returns when all have said it,
  /// so that what each wrote before is there. All ask for the same in the same order.
  /// @throw OtherProcessStopped
  std::vector<std::string> share(std::string_view mine);
  /// Only to wait for each other.
  void wait() { share({}); }
  /// The work is done; nothing is shared any more. @throw OtherProcessStopped
  void finish();
  /// This process cannot go on: the others' next `share` ends them, too. After finish() nobody is
  /// told.
  void stop(int exit_code, const std::string& sentence);

  /// Who stopped first, by rank, since a `share` failed or `stop` was called.
  const std::optional<Stopped>& stopped() const noexcept { return stopped_; }
  /// What went from processes to others so far, by all of them.
  std::uint64_t sentBytes() const noexcept { return sent_bytes_; }

  /// This process's part of `count` equal pieces: first ... end - 1.
  std::pair<int, int> partOf(int count) const noexcept {
    const auto before = [&](int rank) {
      return static_cast<int>(static_cast<std::int64_t>(count) * rank / ranks_);
    };
    return {before(rank_), before(rank_ + 1)};
  }

 protected:
  Exchange(int rank, int ranks) : rank_(rank), ranks_(ranks) {}

 private:
  /// Brings everybody's bytes to everybody, by rank; waits for all.
  virtual std::vector<std::string> gather(const std::string& mine) = 0;
  std::vector<std::string> gathered(const std::string& mine);

  int rank_, ranks_;
  bool is_over_ = false;
  std::optional<Stopped> stopped_;
  std::uint64_t sent_bytes_ = 0;
};

/// One process: whatever it shares is what it said.
class Alone : public Exchange {
 public:
  Alone() : Exchange(0, 1) {}

 private:
  std::vector<std::string> gather(const std::string& mine) override { return {mine}; }
};

}  // namespace relievo
