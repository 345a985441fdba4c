// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/measure/measure.h"
#include "core/measure/section.h"

namespace relievo {

// Files of measurements. Numbers in round-trip form with decimal points, LF, UTF-8. `header` is a
// text whose lines become comments with "#"; empty: none.

/// One row per quantity: name, kind, quantity, value, uncertainty, unit, not_measured.
std::string measurementsCsv(const MapCells& map, const std::vector<Measurement>& list,
                            std::string_view header = {});

/// One row per sample: along_mm, x_mm, y_mm, z_mm, uncertainty_mm, origin (its code).
std::string profileCsv(const std::vector<ProfileRow>& rows, std::string_view header = {});

/// The profile as a drawing: height against distance, the same scale on both axes unless the
/// heights would then fill less than a tenth of the width; not measured parts are dashed. Text
/// stays text.
std::string profileSvg(const std::vector<ProfileRow>& rows, std::string_view title);

/// One row per point: curve (from 1, longest first), closed (0, 1), x_mm, y_mm, z_mm.
std::string sectionCsv(const std::vector<SectionCurve>& curves, std::string_view header = {});

}  // namespace relievo
