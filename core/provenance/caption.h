// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "core/provenance/provenance.h"
#include "core/region/window.h"

namespace relievo {

/// How large a picture of a region is. Both in mm on the object.
struct CaptionScale {
  double mm_per_pixel = 0;
  std::optional<double> paper_mm_per_mm = std::nullopt;  ///< On paper; nothing: not printed.
};

/// The text that belongs under a picture, one paragraph of UTF-8, decimal points whatever the
/// locale: object, unit, view, engine, rule, holes, level, M, gain, light or relief image, scale,
/// shares of measured cells in the picture, program and checksum.
/// @param window  what the picture shows
std::string caption(const Provenance& provenance, const Surface& surface, const ViewState& view,
                    const RegionWindow& window, const CaptionScale& scale);

}  // namespace relievo
