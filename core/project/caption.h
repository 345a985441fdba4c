// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/origin.h"
#include "core/project/project.h"
#include "core/region/window.h"
#include "core/relief/stereo.h"

namespace relievo {

/// How a state became a picture.
struct CaptionFacts {
  ReliefLook look = {};
  StereoPrint stereo = StereoPrint::off;
  FigureEye eye = FigureEye::both;
  bool swap_eyes = false;
  bool hand_by_shape = false;                            ///< Drawn, and told by its shape alone.
  double eye_angle_deg = 0;                              ///< As drawn.
  std::optional<double> mm_per_pixel = std::nullopt;     ///< On the object; nothing: not of pixels.
  std::optional<double> paper_mm_per_mm = std::nullopt;  ///< On paper; nothing: not printed.
  std::vector<Measurement> measurements = {};            ///< Those that are drawn over it.
};
/// Of a picture of exactly the region, as `render` and the views draw it.
CaptionFacts pictureFacts(const Project& project, double mm_per_pixel);

/// The text that belongs under a picture, one paragraph of UTF-8, decimal points whatever the
/// locale: object, unit, view, method, height per cell, holes, resolution, level, pyramid factor,
/// sigma, vertical exaggeration, light or relief image, stereo, scale, planes of what is measured,
/// shares of measured cells in the region, program and checksum. Lengths in the object's unit
/// (core/project/shown_lengths.h).
/// @param window  the region's samples
std::string captionOf(const Project& project, const Surface& surface, const RegionWindow& window,
                      const CaptionFacts& facts);

/// How people are told the engine: "CPU", "OpenGL"; others as they are.
std::string methodName(const std::string& engine);

/// A number with at most `digits` significant digits and no trailing zeros; a larger one to the
/// next integer, without an exponent.
std::string shortNumber(double value, int digits = 4);

/// Of a window's samples by origin, 0 to 1.
std::array<double, kOriginCount> sharesOf(const RegionWindow& window);

/// "87.2 % measured, 1 % interpolated": measured ones always, others where there are any.
/// @param shares  of all cells by origin, 0 to 1
std::string sharesText(const std::array<double, kOriginCount>& shares);

}  // namespace relievo
