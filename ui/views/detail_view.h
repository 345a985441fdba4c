// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <QCursor>

#include "core/depth/view.h"
#include "core/region/hand.h"
#include "ui/views/pointer_bindings.h"
#include "ui/views/surface_view.h"
#include "ui/work/document.h"

namespace relievo {

/// The window's 200 x 200 samples, and the hand on them. The pointer carries the hand just above
/// the surface. To look, a left drag turns; to touch, the left button presses the hand in, and
/// Ctrl+wheel or the wheel while pressing changes the depth. Middle drag turns, right drag moves
/// the window, the wheel zooms about the pointer; all of it as the bindings say.
/// Keys: arrows move the hand one cell (Shift: ten), Page Down and Page Up press in and lift.
/// [GUI thread]
class DetailView : public SurfaceView {
  Q_OBJECT
 public:
  DetailView(Document& document, RenderScheduler& turns, QWidget* parent = nullptr);

  /// Draws the hand where the force loop says it is; ignored if it belongs to another window.
  void showProbe(const Probe& probe);
  void clearProbe();

  double pressDepthMm() const { return press_depth_mm_; }
  void setPressDepthMm(double depth_hand_mm);
  bool pressing() const { return mouse_presses_ || key_depth_mm_ > 0; }
  /// To a place of the window, as keys carry it; elsewhere it stays. @return it is there
  bool carryHandTo(double x_mm, double y_mm);
  std::optional<ViewMm> hand() const { return inside_ ? std::optional(hand_) : std::nullopt; }

  PointerMode pointerMode() const { return mode_; }
  /// A hand that is pressed in by the mouse is lifted.
  void setPointerMode(PointerMode mode);
  /// What the view tells of itself (What's This) follows.
  void setBindings(const PointerBindings& bindings);

  /// In the place of the pointer that says what dragging does; nothing: that one. [GUI thread]
  void setOwnCursor(const std::optional<QCursor>& cursor);
  /// How much the surface, as exaggerated as it is felt, rises from one point of the view to
  /// another, for each mm of way; 0 where there is no way, or no surface.
  double risePerWay(const QPointF& from, const QPointF& to) const;
  /// Of the surface under a point, from 0, the lowest of the window, to 1; 0.5 where all is flat.
  double heightShare(const QPointF& point) const;

  /// While something is measured, the left button and Enter pick places instead of pressing in.
  void setPicking(bool on);

  bool isTurned() const;
  /// Back to looking straight down on the relief.
  void straighten();
  /// As somebody turns it, by mouse, key or device; what is shown by other means is no such turn.
  /// @param merge_id  see Document::edit
  void turnBy(double azimuth_deg, double elevation_deg, int merge_id = Document::kTurnsInARow);
  /// Rotation from the present view frame to the one the camera looks along.
  Rotation cameraRotation() const;
  /// Rotation from the file's axes to the frame that the camera looks along. @pre a surface is open
  Rotation lookRotation() const;

 Q_SIGNALS:
  void handMoved(relievo::ViewMm position, bool inside);
  void pressDepthChanged(double depth_hand_mm);
  /// The wheel, while the left button presses the hand in and another one is held, too.
  void resolutionAsked(bool finer);
  void picked(double x_mm, double y_mm);
  void pickingEnded();  ///< A double click or the key F.
  void turned(bool away_from_straight);
  void turnedBySomebody();  ///< turnBy()

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void letGo() override;

 private:
  enum class Drag { none, turn, pan, zoom };

  /// What a press of this button begins.
  Drag dragOf(Qt::MouseButton button) const;
  void showCursor();

  void showWindow();
  void showTurn();
  void fitCamera();
  /// Where the sight line through a point first meets the surface.
  ViewMm onSurface(const QPointF& point) const;
  void pointHandAt(const QPointF& point);
  void placeHand(double x_mm, double y_mm);
  void keepHand();
  void zoomAbout(const QPointF& point, int notches);
  void stepResolution(const QPointF& point, bool finer);
  void turnTo(const QPointF& point);
  void pan(const QPointF& point);
  bool moveHandByKey(int key, double cells);

  Document& document_;
  std::optional<Region> camera_region_;
  PointerMode mode_ = PointerMode::look;
  PointerBindings bindings_;
  std::optional<QCursor> own_cursor_;
  Drag drag_ = Drag::none;
  Qt::MouseButton drag_button_ = Qt::NoButton;  ///< That holds the drag.
  QPointF drag_point_;
  Region drag_start_;
  ViewMm hand_;
  std::optional<QPointF> pointer_;  ///< Carries the hand; none: the keys do.
  bool inside_ = false;
  bool mouse_presses_ = false;
  bool picking_ = false;
  double key_depth_mm_ = 0;  ///< Pressed in by keys, mm of hand; 0: hovering.
  double press_depth_mm_ = kPressDepthMm;
  int wheel_rest_ = 0;
};

}  // namespace relievo
