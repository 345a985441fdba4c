// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/base/unit.h"
#include "core/message/message.h"

namespace relievo {

struct RasterHead;      // core/io/raster/raster.h
struct ScanInfo;        // core/cloud/scan.h
struct SurfaceOptions;  // core/session/surface.h

/// What somebody said of how large a raster from elsewhere is. A picture of heights, as a PNG,
/// says neither how far apart its pixels lie nor how high a step of its values is.
struct RasterScale {
  std::optional<double> pixel_mm;   ///< Distance of neighbouring samples, above 0.
  std::optional<double> height_mm;  ///< Of a step of 1; below 0: larger values lie deeper. Not 0.
  std::optional<double> zero;  ///< The value on the base plane; nothing: the one that lies lowest.
  friend bool operator==(const RasterScale&, const RasterScale&) = default;
};

/// How large the samples of a raster are taken to be.
struct ScaleInUse {
  double pixel_mm = 1;
  double height_mm = 1;  ///< Of a step of 1; not 0.
  UnitSource pixel_source = UnitSource::assumed;
  UnitSource height_source = UnitSource::assumed;
  std::optional<double> zero = {};  ///< As said.
  bool is_placed = true;            ///< The file says where its samples lie, and so how large.

  /// Of a file's lowest and highest value the one that lies lowest.
  double lowest(double low, double high) const { return height_mm > 0 ? low : high; }
  /// View z of the base plane above `value`; nothing: nobody said where it is.
  std::optional<double> baseAbove(double value) const {
    return zero ? std::optional((*zero - value) * height_mm) : std::nullopt;
  }
  /// Nobody said one of the two, neither the file nor a person.
  bool isOpen() const;
};

/// The one rule of window and command line: what was said; else the file's unit or the chosen one;
/// else, where the file says nothing and its heights would rise higher than the raster is long, a
/// height scale that makes them a tenth of that: a guess, rounded to one digit so that it looks
/// like one. A unit that somebody gives ends the guess.
/// @param low, high  heights of the file without those that stand for none
/// @param unit, unit_source  of unitInUse
ScaleInUse scaleInUse(const RasterHead& raster, LengthUnit unit, UnitSource unit_source,
                      const RasterScale& said, double low, double high);

/// What to say of a scale that nobody stated. Nothing for others.
std::optional<Message> scaleWords(const ScaleInUse& scale);

}  // namespace relievo
