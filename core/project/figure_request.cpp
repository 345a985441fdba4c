// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/figure_request.h"

#include <algorithm>
#include <string>

#include "core/base/failure.h"
#include "core/relief/eye_angle.h"

namespace relievo {

std::optional<FigureLayout> figureLayout(std::string_view name) {
  const auto* const found = std::find(kFigureLayoutNames.begin(), kFigureLayoutNames.end(), name);
  if (found == kFigureLayoutNames.end()) return std::nullopt;
  return static_cast<FigureLayout>(found - kFigureLayoutNames.begin());
}

namespace {

template <MessageId refusal>
void requireWithin(double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw failure<refusal>(static_cast<int>(low), static_cast<int>(high));
}

}  // namespace

void check(const FigureRequest& f) {
  requireWithin<MessageId::figure_width>(f.width_mm, 20, 2000);
  requireWithin<MessageId::figure_dpi>(f.dpi, 30, 2400);
  requireWithin<MessageId::figure_text_size>(f.text_pt, 4, 36);
  requireWithin<MessageId::figure_eye_angle>(f.eye_angle_deg, kLeastEyeAngleDeg, kMostEyeAngleDeg);
  if (f.scale_1_to && !(*f.scale_1_to > 0)) {
    throw failure<MessageId::figure_scale>();
  }
  if (f.transparent && isAnaglyph(f.stereo)) {
    throw failure<MessageId::figure_anaglyph_paper>();
  }
  const bool pair = f.stereo == StereoPrint::side_by_side || f.stereo == StereoPrint::over_under;
  if (pair && f.layout != FigureLayout::detail) {
    throw failure<MessageId::figure_pair_layout>();
  }
  if (f.eye != FigureEye::both && (!pair || f.layout != FigureLayout::detail)) {
    throw failure<MessageId::figure_eye_layout>();
  }
  if (f.layout == FigureLayout::plot && f.recording.empty()) {
    throw failure<MessageId::figure_plot_recording>();
  }
}

}  // namespace relievo
