// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <QPointF>
#include <QString>
#include <QWidget>
#include <vector>

#include "core/base/vec3.h"

namespace relievo {

/// A text beside a place on the surface: what a line or an area reads.
struct ViewLabel {
  ViewMm at;
  QString text;
  friend bool operator==(const ViewLabel&, const ViewLabel&) = default;
};

/// Labels of measurements and the mark of a profile's cursor over a view's picture. Drawn by Qt, so
/// that a cursor that is dragged costs no picture of the relief. Lets the pointer through.
/// [GUI thread]
class ViewLabels : public QWidget {
  Q_OBJECT
 public:
  /// @param point_over  where in the view a place is seen
  ViewLabels(QWidget* view, std::function<QPointF(const ViewMm&)> point_over);

  void setLabels(const std::vector<ViewLabel>& labels);
  void setMark(const std::optional<ViewMm>& mark);
  /// The picture is one for each eye, side by side: nothing can lie over it.
  void setOff(bool off);
  const std::vector<ViewLabel>& labels() const { return labels_; }
  const std::optional<ViewMm>& mark() const { return mark_; }
  void place();  ///< After view or camera changed.

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawMark(QPainter& painter) const;

  std::function<QPointF(const ViewMm&)> point_over_;
  std::vector<ViewLabel> labels_;
  std::optional<ViewMm> mark_;
  bool off_ = false;
};

}  // namespace relievo
