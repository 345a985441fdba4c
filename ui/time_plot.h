// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <QWidget>
#include <span>

#include "ui/strip_plot.h"
#include "ui/touch_readout.h"

class QTimer;

namespace relievo {

/// The paper's force figure, live: z of hand and proxy, and the force, over the last ten seconds.
/// [GUI thread]
class TimePlot : public QWidget {
  Q_OBJECT
 public:
  explicit TimePlot(QWidget* parent = nullptr);

  void add(std::span<const TouchPlotPoint> points);
  void clear();
  /// Curves' and axes' colours from the current theme.
  void takeColours();
  std::size_t points() const { return points_.size(); }

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void redraw();

  std::deque<TouchPlotPoint> points_;
  StripPlot heights_, forces_;
  QTimer* timer_;
  bool stale_ = false;
};

}  // namespace relievo
