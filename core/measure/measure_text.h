// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure/measure.h"
#include "core/measure/section.h"

namespace relievo {

// Files of measurements. Numbers in round-trip form with decimal points, LF, UTF-8. `header` is a
// text whose lines become comments with "#"; empty: none.

/// The plane of a measurement that has one, for people: "level at 2.5 mm", "upright: 0.6 x + 0.8 y
/// = 12 mm"; of others empty.
/// @param unit  that lengths are told in, of `unit_mm` each
std::string planeText(const Measurement& m, double unit_mm = 1, std::string_view unit = "mm");
/// The same for programs, in round-trip form: "NX NY NZ OFFSET".
std::string planeNumbers(const Measurement& m);

/// How many decimals of a value its uncertainty leaves meaning to: the first digit of the
/// uncertainty is always seen, of larger ones the second.
int decimalsFor(double uncertainty);

/// A measurement with what was read of it.
struct Measured {
  Measurement measurement;
  std::optional<Reading> reading;  ///< Nothing: `problem` says why.
  std::string problem;
};

/// One row per quantity: name, kind, quantity, value, uncertainty, unit, not_measured, plane,
/// places_mm ("X Y; X Y"). What could not be read is a comment with its problem.
std::string measurementsCsv(const std::vector<Measured>& list, std::string_view header = {});
/// The same, read here.
std::string measurementsCsv(const MapCells& map, const std::vector<Measurement>& list,
                            std::string_view header = {});

/// One row per sample: along_mm, x_mm, y_mm, z_mm, uncertainty_mm, origin (its code).
std::string profileCsv(const std::vector<ProfileRow>& rows, std::string_view header = {});

/// The profile as a drawing: height against distance, the same scale on both axes unless the
/// heights would then fill less than a tenth of the width; not measured parts are dashed. Text
/// stays text.
std::string profileSvg(const std::vector<ProfileRow>& rows, std::string_view title);

/// The section as a drawing in its plane, the same scale on both axes: seen from above if it is
/// level, from the side with heights upward if it is upright, else along its normal.
std::string sectionSvg(const std::vector<SectionCurve>& curves, const PlaneMm& plane,
                       std::string_view title);

/// One row per point: curve (from 1, longest first), closed (0, 1), x_mm, y_mm, z_mm.
std::string sectionCsv(const std::vector<SectionCurve>& curves, std::string_view header = {});

}  // namespace relievo
