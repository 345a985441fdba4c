// SPDX-License-Identifier: BSD-3-Clause
// What of the measurements is seen beside the list: labels in the views, a profile's curve.
#include <QTableWidget>

#include "core/base/error.h"
#include "core/measure/measure_text.h"
#include "ui/panels/measure_panel.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

constexpr std::size_t kMostLabels = 60;  // More would hide the relief.

/// Where a label stands: in the middle of a line, within an outline, at an angle's corner.
PlaceMm middleOf(const Measurement& m) {
  const std::vector<PlaceMm>& p = m.places;
  if (m.kind == MeasureKind::area) {
    PlaceMm sum;
    for (const PlaceMm& place : p) sum = {sum.x + place.x, sum.y + place.y};
    const auto count = static_cast<double>(p.size());
    return {sum.x / count, sum.y / count};
  }
  const std::size_t half = p.size() / 2;
  if (p.size() % 2 == 1) return p[half];
  return {0.5 * (p[half - 1].x + p[half].x), 0.5 * (p[half - 1].y + p[half].y)};
}

QString labelText(const Measurement& m, const Reading& reading) {
  const Quantity& first = reading.quantities.front();
  return QStringLiteral("%1: %2 %3")
      .arg(QString::fromStdString(m.name), numberText(first.value, decimalsFor(first.uncertainty)),
           QString::fromUtf8(first.unit.data(), static_cast<int>(first.unit.size())));
}

}  // namespace

std::vector<ViewLabel> MeasurePanel::labels() const {
  std::vector<ViewLabel> labels;
  if (!document_.isOpen()) return labels;
  const double gain = document_.project().gain;
  for (const Measurement& m : measurements()) {
    if (labels.size() == kMostLabels) break;
    const auto entry = readings_->of(m);
    if (!entry || !entry->reading || entry->reading->quantities.empty()) continue;
    ViewMm at;
    if (m.kind == MeasureKind::section) {
      if (entry->reading->curves.empty()) continue;
      const std::vector<ViewMm>& curve = entry->reading->curves.front().points;
      at = curve[curve.size() / 2];
    } else if (!m.places.empty()) {
      const PlaceMm middle = middleOf(m);
      at = {middle.x, middle.y, 0};
      try {
        if (const auto point = readings_->pointAt(middle)) at.z = point->at.z;
      } catch (const FileError&) {  // Said in the list.
      }
    } else {
      continue;
    }
    at.z *= gain;
    labels.push_back({at, labelText(m, *entry->reading)});
  }
  return labels;
}

std::optional<int> MeasurePanel::shownProfile() const {
  if (!document_.isOpen()) return std::nullopt;
  const auto is_profile = [this](int row) {
    return measurements()[static_cast<std::size_t>(row)].kind == MeasureKind::profile;
  };
  if (const auto row = selected(); row && is_profile(*row)) return row;
  for (int row = static_cast<int>(measurements().size()) - 1; row >= 0; --row) {
    if (is_profile(row)) return row;
  }
  return std::nullopt;
}

std::vector<ProfileRow> MeasurePanel::profileRows(int row) const {
  const auto entry = readings_->of(measurements()[static_cast<std::size_t>(row)]);
  return entry && entry->reading ? entry->rows : std::vector<ProfileRow>();
}

}  // namespace relievo
