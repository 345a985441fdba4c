// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "core/base/task.h"
#include "core/depth/colours/colours.h"
#include "core/depth/depth_map.h"
#include "core/relief/colour_map.h"
#include "core/relief/look.h"

namespace relievo {

/// One number per sample of a depth map: what a relief image shows.
struct ReliefValues {
  std::vector<float> values;  ///< Row-major, row 0 lowest y; NaN outside the object.
  double low = 0, high = 1;   ///< The colours' ends.
  std::string_view title;     ///< "slope", for a legend.
  std::string_view unit;      ///< "mm", "\u00b0" or empty.
};

/// Computes look.kind over a map. Gradients are central differences, one-sided at the object's
/// rim. Horizons are searched in 16 directions up to the radius and end at cells that are outside.
/// The same values for any number of threads. [worker; any thread for a window's 200 x 200]
/// @param map  with spacing in mm, heights in mm
/// @throw ArgumentError  radius or light that is not a number, or below 0
/// @throw Cancelled
ReliefValues reliefValues(const DepthMap& map, const ReliefLook& look, const Task& task = {});

/// The next round numbers around a range, at most a fifth of it farther apart in all: for the ends
/// of a bar of colours. @param high  > low
std::pair<double, double> roundEnds(double low, double high);

/// @throw ArgumentError  the colours' ends are not in order
void checkRange(const ReliefLook& look);
/// @throw ArgumentError  not 0 ... 1
void checkShading(const ReliefLook& look);

/// Does the look depend on a radius?
bool hasRadius(ReliefKind kind);
/// The look's radius; where it says none, 10 samples.
double radiusMm(const ReliefLook& look, double spacing_mm);

/// Is the picture lit by lamps on top of its colours? Otherwise it is drawn as it is.
bool isLit(ReliefKind kind);
/// Does it show what the scan says of colour or intensity? Not every scan does.
bool showsOwnColours(ReliefKind kind);
/// Does the picture depend on where the one light stands?
bool hasKeyLight(const ReliefLook& look);
/// Does a bar of colours explain the picture? Not of stone, the hillshades and a scan's own
/// colours.
bool hasLegend(ReliefKind kind);
/// The map the picture is coloured by: grey for the hillshades.
ColourMap coloursOf(const ReliefLook& look);

/// Three bytes per sample, red first. `lit` gives none.
/// @param own  of the same samples, for the looks that show them: stored bytes times the shading,
///             stone where there is none @throw ArgumentError  the look needs some
std::vector<std::uint8_t> reliefColours(const ReliefValues& values, const ReliefLook& look,
                                        const GridColours& own = {});

}  // namespace relievo
