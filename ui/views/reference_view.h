// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "ui/views/overlays/pink_window.h"
#include "ui/views/overlays/suggestion_frames.h"
#include "ui/views/surface_view.h"
#include "ui/work/document.h"

namespace relievo {

class PinkOverlay;

/// The whole object with the pink window. Drag outside draws a new window, inside moves it, edges
/// and corners resize it, the wheel changes the detail about the pointer, Escape returns.
/// Keys: arrows move, Shift+arrows resize, + and - change the detail. Space draws: it puts one
/// corner in the middle of the window, arrows carry the other (Shift+arrows both), Space or Enter
/// ends, and Escape returns. [GUI thread]
class ReferenceView : public SurfaceView {
  Q_OBJECT
 public:
  ReferenceView(Document& document, RenderScheduler& turns, QWidget* parent = nullptr);

  /// Point of the widget over a view position; for tests and for the keyboard.
  QPointF pointOf(double x_mm, double y_mm) const;
  /// Frames of windows that are suggested.
  void setSuggestions(const std::vector<SuggestedFrame>& frames) { suggested_->setFrames(frames); }

 Q_SIGNALS:
  void left();  ///< Escape with nothing to return from.
  /// What a key did, for who does not see it.
  void said(const QString& words);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void letGo() override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Drag {
    PinkPart part;
    QPointF pressed;
    double x_mm, y_mm;  ///< Where the pointer went down.
    Region start;
    bool moved = false;
  };
  /// A window drawn by keys: one corner stands, the arrows carry the other.
  struct KeyDraw {
    double x_mm, y_mm;
    double to_x_mm, to_y_mm;
  };

  void showSurface();
  void showWindow();
  QString windowText() const;  ///< Of the region of now, whether it is cut already or not.
  void placePink();
  void dragTo(const QPointF& point);
  void showCursor(const QPointF& point);
  void resizeBy(double factor);
  void previewDrawn(double x_mm, double y_mm, double to_x_mm, double to_y_mm);
  bool drawByKey(int key, bool both_corners);
  double toleranceMm() const;

  Document& document_;
  SuggestionFrames* suggested_;  ///< Child; owned by Qt. Below the pink window.
  PinkOverlay* pink_;            ///< Child; owned by Qt.
  std::optional<Drag> drag_;
  std::optional<KeyDraw> key_draw_;
  int wheel_rest_ = 0;  ///< Angle not yet worth a step.
};

}  // namespace relievo
