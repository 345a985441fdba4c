// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/task.h"

namespace relievo {

/// Is a log as it was written? By its checksums alone: nothing is computed again.
struct LogCheck {
  enum class State : std::uint8_t {
    none,        ///< It carries no checksum: an earlier build made it.
    whole,       ///< Finished, and every byte is as it was.
    unfinished,  ///< Its writer was ended; as it was up to its last complete block.
    changed,
  };
  State state = State::none;
  std::uint64_t rows = 0;  ///< The first so many are as they were written.
  std::string where;       ///< Of a changed one, a clause: "the header is not as it was written".
};

/// A stroke's log that has no end counts as changed, as it is removed unless it is complete.
/// @throw FileError  unreadable, or no log at all  @throw Cancelled
LogCheck checkLog(const std::filesystem::path& file, const Task& task = {});

/// "whole", "not finished", "changed", "no checksum".
std::string_view name(LogCheck::State state) noexcept;

}  // namespace relievo
