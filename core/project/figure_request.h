// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/relief/look.h"
#include "core/relief/stereo.h"

namespace relievo {

/// What stands beside what.
enum class FigureLayout {
  detail,            ///< The region alone.
  reference_detail,  ///< The whole object with the window's outline, and the region (the paper's).
  before_after,      ///< The region as measured, and with its gaps and holes filled.
  levels,            ///< The region at several levels of the pyramid, coarsest first.
  plot,              ///< Reference and region above the plots of a recording.
};
inline constexpr std::array<std::string_view, 5> kFigureLayoutNames{
    "detail", "reference", "beforeafter", "levels", "plot"};
inline constexpr std::string_view name(FigureLayout layout) noexcept {
  return kFigureLayoutNames[static_cast<std::size_t>(layout)];
}
std::optional<FigureLayout> figureLayout(std::string_view name);

/// Everything about a figure that the relief itself does not decide; one record for the dialog
/// "Figure..." and `relievo figure`. Lengths are millimetres and points (1/72 inch) on paper.
struct FigureRequest {
  FigureLayout layout = FigureLayout::reference_detail;
  double width_mm = 180;             ///< Of the figure, 20 .. 2000.
  double dpi = 300;                  ///< 30 .. 2400.
  std::optional<double> scale_1_to;  ///< The region at 1:N instead; the width follows from it.
  double text_pt = 8;                ///< 4 .. 36.
  ReliefLook look;
  bool scale_bar = true, height_bar = true, up_mark = true, window_outline = true;
  bool hatch = true;    ///< Over what was not measured.
  bool legend = true;   ///< Of colours and hatches.
  bool letters = true;  ///< a, b, c in the panels' corners.
  bool measurements = true;
  bool transparent = false;  ///< No paper behind the relief. Without anaglyph.
  StereoPrint stereo = StereoPrint::off;
  FigureEye eye = FigureEye::both;
  double eye_angle_deg = 4;
  std::optional<double> zero_plane_mm;  ///< Nothing: mid height.
  bool swap_eyes = false;
  bool limit_parallax = true;  ///< Less eye angle where kComfortDeg would be passed.
  std::string recording;       ///< CSV of a recording, for `plot`.
  friend bool operator==(const FigureRequest&, const FigureRequest&) = default;
};

/// @throw ArgumentError  a number beyond its limits, or choices that exclude each other
void check(const FigureRequest& request);

}  // namespace relievo
