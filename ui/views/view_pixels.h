// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

inline constexpr double kPlainDpi = 96;  ///< Dots per inch of a desktop that asks for no more.
inline constexpr int kFocusFramePx = 2;  ///< Around a view's picture; shows the focus.

}  // namespace relievo
