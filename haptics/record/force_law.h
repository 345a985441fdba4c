// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace relievo {

/// Counts the changes of what a hand with a device feels. A recording is the same to the last bit
/// only under the law that it was made with; `touch` without a device, F = -k d, knows none of it.
inline constexpr int kForceLaw = 7;

/// A line for headers: "law 3".
std::string lawLine();
/// What a header says; nothing: none is named, as before law 3.
std::optional<int> lawIn(std::string_view header);
/// Why a recording with this header need not be the same here, and what has changed since; empty:
/// it was made by this law.
std::string lawDifference(std::string_view header);

}  // namespace relievo
