// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/prepare/align/align.h"

namespace relievo {

/// Brings scans of one object into the coordinates of one of them (the step's methods `points` and
/// `auto`; `stored` begins with what the files say): each pair that meets is fitted alone, then all
/// poses are solved together, loops are checked and every scan is judged (docs/adr/0093). The same
/// input and seed give the same bytes. A scan that nothing holds is told in its verdict; a plate
/// that slides stays where picks put it. Uses rand(): one call at a time in a process. [worker]
/// @throw ArgumentError  fewer than two scans, a scan of fewer than 100 different points or in
///                       another unit than the reference, picks that do not say a pose; the
///                       sentence names the scan
/// @throw Cancelled
[[nodiscard]] AlignAnswer alignScans(const Align& how, std::span<const AlignScan> scans,
                                     const Task& task);

}  // namespace relievo
