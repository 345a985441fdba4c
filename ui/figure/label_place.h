// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/project/shown_lengths.h"
#include "ui/figure/mark_places.h"

namespace relievo {

/// Which file axis points up: north where the data are a map.
QString upName(const Surface& surface);

/// As typeset: with a minus instead of a hyphen.
QString numeral(const std::string& number);
QString words(std::string_view text);

/// Whether a box is whole within a panel and over none of those taken.
bool isFree(const QRectF& box, const QRectF& panel, const std::vector<QRectF>& taken);

struct DrawnMeasurement {
  const Measurement& m;
  const Reading& reading;
  const ShownLengths& lengths;
};

/// The lines of a measurement on paper: its places, and the curves of a section.
struct MeasuredLines {
  QPolygonF places;
  std::vector<QPolygonF> curves;
};
MeasuredLines linesOf(const PanelSpace& space, const DrawnMeasurement& measured);

/// Name and value beside the measurement. Where they are too wide for the panel the value stands
/// below the name, which is shortened before the value is; nothing if no place is free.
std::optional<PlacedMark> labelOf(const FigureInk& ink, const PanelSpace& space,
                                  const DrawnMeasurement& measured,
                                  const std::vector<QRectF>& taken);

}  // namespace relievo
