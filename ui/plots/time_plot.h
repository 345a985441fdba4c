// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <QWidget>
#include <span>

#include "core/recording/force_curve.h"
#include "ui/plots/strip_plot.h"

class QTimer;

namespace relievo {

/// The paper's force figure, live: z of hand and proxy, and the force, over the last ten seconds.
/// [GUI thread]
class TimePlot : public QWidget {
  Q_OBJECT
 public:
  explicit TimePlot(QWidget* parent = nullptr);

  void add(std::span<const ForcePoint> points);
  void clear();
  /// Curves' and axes' colours from the current theme.
  void takeColours();
  std::size_t points() const { return points_.size(); }
  /// Would it look otherwise if it were drawn now? A hand that rests draws nothing.
  bool isStale() const { return stale_; }

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void redraw();
  std::optional<ForcePoint> restingAt() const;

  std::deque<ForcePoint> points_;
  std::optional<ForcePoint> drawn_rest_;  ///< Of all points drawn, if they all look alike.
  StripPlot heights_, forces_;
  QTimer* timer_;
  bool stale_ = false;
};

}  // namespace relievo
