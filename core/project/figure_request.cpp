// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/figure_request.h"

#include <algorithm>
#include <string>

#include "core/base/error.h"

namespace relievo {

std::optional<FigureLayout> figureLayout(std::string_view name) {
  const auto* const found = std::find(kFigureLayoutNames.begin(), kFigureLayoutNames.end(), name);
  if (found == kFigureLayoutNames.end()) return std::nullopt;
  return static_cast<FigureLayout>(found - kFigureLayoutNames.begin());
}

void check(const FigureRequest& f) {
  const auto within = [](const char* what, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw ArgumentError("A figure's " + std::string(what) + " must be " +
                        std::to_string(static_cast<int>(low)) + " to " +
                        std::to_string(static_cast<int>(high)) + ". Nothing was drawn.");
  };
  within("width in mm", f.width_mm, 20, 2000);
  within("dots per inch", f.dpi, 30, 2400);
  within("text size in points", f.text_pt, 4, 36);
  within("angle between the eyes in degrees", f.eye_angle_deg, 0.01, 20);
  if (f.scale_1_to && !(*f.scale_1_to > 0)) {
    throw ArgumentError("A scale of 1:N needs an N above 0. Nothing was drawn.");
  }
  if (f.transparent && isAnaglyph(f.stereo)) {
    throw ArgumentError(
        "An anaglyph needs its background: without paper the eyes would see "
        "different pages. Choose one of the two.");
  }
  const bool pair = f.stereo == StereoPrint::side_by_side || f.stereo == StereoPrint::over_under;
  if (pair && f.layout != FigureLayout::detail) {
    throw ArgumentError(
        "Two eyes' pictures fill a figure of their own: they need the layout "
        "'detail'. Choose it, or an anaglyph.");
  }
  if (f.eye != FigureEye::both && (!pair || f.layout != FigureLayout::detail)) {
    throw ArgumentError(
        "One eye's picture of two needs the layout 'detail' and the stereo 'sidebyside' or "
        "'overunder'. Choose both eyes, or these.");
  }
  if (f.layout == FigureLayout::plot && f.recording.empty()) {
    throw ArgumentError("A figure with plots needs a recording. Choose one, CSV or HDF5.");
  }
}

}  // namespace relievo
