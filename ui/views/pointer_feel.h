// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <QObject>
#include <QPointF>

class QMouseEvent;

namespace relievo {

class DetailView;

/// How many times as far as the mouse the pointer goes, where the surface rises by so much along
/// its way: half as far up 45 degrees, twice as far down, never less than a quarter, so that
/// nothing holds it. After Lécuyer, Burkhardt, Etienne: Feeling bumps and holes without a haptic
/// interface (CHI 2004).
double feltGain(double rise_per_way) noexcept;

/// Diameter of the pointer at a height, from 0, the lowest of the window, to 1. After Lécuyer,
/// Burkhardt, Tan: A study of the modification of the speed and size of the cursor (2008).
int feltDiameterPx(double height_share) noexcept;

/// "Feel with the mouse": while no button is held the pointer is slower uphill and faster downhill
/// than the mouse, and larger on heights. Where a program may not move the pointer (Wayland), only
/// its size tells. [GUI thread]
class PointerFeel : public QObject {
  Q_OBJECT
 public:
  explicit PointerFeel(DetailView& view);

  bool isOn() const { return is_on_; }
  void setOn(bool on);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool moved(const QMouseEvent& event);
  bool isOfOurs(const QPoint& at);
  void showSize(const QPointF& at);

  DetailView& view_;
  bool is_on_ = false;
  bool can_move_pointer_;
  std::optional<QPoint> mouse_;  ///< Where the last event was; none: outside.
  QPointF pointer_;              ///< The same, after the surface; to parts of a pixel.
  std::deque<QPoint> asked_;     ///< Where the pointer was put, and is not yet.
  int diameter_px_ = 0;
};

}  // namespace relievo
