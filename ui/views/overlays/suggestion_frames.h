// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QPointF>
#include <QWidget>
#include <vector>

#include "core/region/region.h"

namespace relievo {

/// A window that is suggested; its rank is its place in the list.
struct SuggestedFrame {
  RectMm rect;
  bool is_current = false;
  friend bool operator==(const SuggestedFrame&, const SuggestedFrame&) = default;
};

/// Frames of suggested windows with their ranks over the whole object. Lets the pointer through.
/// [GUI thread]
class SuggestionFrames : public QWidget {
  Q_OBJECT
 public:
  SuggestionFrames(QWidget* view, std::function<QPointF(double x_mm, double y_mm)> point_of);
  void setFrames(const std::vector<SuggestedFrame>& frames);
  const std::vector<SuggestedFrame>& frames() const { return frames_; }
  void place();  ///< After the view changed its size.

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::function<QPointF(double, double)> point_of_;
  std::vector<SuggestedFrame> frames_;
};

}  // namespace relievo
