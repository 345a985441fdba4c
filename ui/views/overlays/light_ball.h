// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "core/relief/look.h"

namespace relievo {

/// A small sphere in a corner of a view that shows from where the key light shines, and is dragged
/// to move it: its rim is light along the surface, its middle light from the viewer. Arrows do the
/// same, 5 degrees a step. Shows and asks; the light is the document's. [GUI thread]
class LightBall : public QWidget {
  Q_OBJECT
 public:
  explicit LightBall(QWidget* view);

  void show(const LightOptions& light);
  const LightOptions& light() const { return light_; }
  /// Of a relief image that no lamp shines on there is none.
  void setUsable(bool usable);
  void place();  ///< After the view changed its size.

  /// Where in the widget the light's spot lies, and which light a place means.
  QPointF spotOf(const LightOptions& light) const;
  LightOptions lightAt(const QPointF& point) const;

 Q_SIGNALS:
  /// @param drag  how many presses of the button there have been: those of one are one step
  void dragged(const relievo::LightOptions& light, int drag);
  /// By keys: so many steps clockwise and upwards.
  void stepped(int clockwise, int higher);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  double radius() const;

  LightOptions light_;
  bool usable_ = true, dragging_ = false;
  int drags_ = 0;
};

/// Lower, and the light along the surface would be seen as darkness.
inline constexpr double kLeastLightDeg = 5;
/// The light some degrees on, within what there is.
LightOptions turnedLight(LightOptions light, double clockwise_deg, double higher_deg);

}  // namespace relievo
