// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/message/message.h"

namespace relievo {

/// How often an object was touched on a day, and for how long. Nothing of anybody: no time of day,
/// no place, no order, no sound.
struct ObjectCount {
  std::int64_t starts = 0;
  double touched_s = 0;
};

/// Counts of each day and object, in a file of which the newest 400 days are kept. Days are given,
/// as "2026-11-24". [one thread]
class VisitCounts {
 public:
  static constexpr std::size_t kMostDays = 400;

  using Days = std::map<std::string, std::map<std::string, ObjectCount>>;

  /// What `counts.json` in a folder holds. One that cannot be read is set aside as
  /// `counts.damaged.json`, and problem() says so.
  explicit VisitCounts(std::filesystem::path folder);

  void start(const std::string& day, const std::string& object);
  void touch(const std::string& day, const std::string& object, double seconds);
  /// Writes what has come since it was written; makes the folder. @throw WriteError
  void save();

  const Days& days() const noexcept { return days_; }
  const std::optional<Message>& problem() const noexcept { return problem_; }

 private:
  std::filesystem::path folder_;
  Days days_;
  bool changed_ = false;
  std::optional<Message> problem_;
};

}  // namespace relievo
