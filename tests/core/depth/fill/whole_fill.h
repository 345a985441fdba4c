// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/depth/fill/fill.h"

namespace relievo::test {

/// The filling of a map as it was before it worked on bands (docs/adr/0233): every step on the
/// whole grid, areas by labels, push-pull by layers of the whole map. What bands must give byte for
/// byte, and what they are measured beside. @throw ArgumentError  no cell was hit
FilledMap fillWholeMap(CapturedDepths&& depths, const GridFrame& frame, const FillSource& source,
                       const HoleChoice& choice);

}  // namespace relievo::test
