// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>

#include "ui/scene_state.h"

namespace relievo {

class ColourBar;
class GridPainter;
class QuietTurns;
struct PaintedGrid;

/// A relief on screen: one scene in one OpenGL widget. Mouse and keys come to this widget as
/// ordinary Qt events; VTK's own interaction is off. Accessible as one named object whose value is
/// `whereAmI`. [GUI thread]
class SurfaceView : public QWidget {
  Q_OBJECT
 public:
  ~SurfaceView() override;

  /// As drawn now: the grid may still be without its colours.
  const SceneState& sceneState() const { return state_; }
  /// The same with its plain grid, to be painted and drawn elsewhere.
  SceneState plainState() const;
  void setStereo(const StereoOptions& stereo);
  void setLight(const LightOptions& light);
  /// How the relief is painted; its light is that of setLight. A picture that takes long comes when
  /// it is ready: until then the one before stays, for a tenth of a second, then plain stone.
  void setLook(const ReliefLook& look);
  /// @param curves  as ReliefScene::setLines
  void setLines(const std::vector<std::vector<ViewMm>>& lines,
                const std::vector<std::vector<ViewMm>>& curves = {});
  void setBackground(const QColor& colour);

  QString whereAmI() const { return where_am_i_; }
  /// Where the user is in this view, in words; assistive technology hears of a change.
  void setWhereAmI(const QString& text);

  /// The view's pixels as they are on screen.
  QImage shot();
  QSize shotSize() const;

  double mmPerPixel() const;  ///< Of the widget, at the view's centre.

  /// Compiles what pictures need, a step in a turn, if the window is on screen. The first picture
  /// waits for it; to be asked for as soon as one will be wanted.
  void warmUp();
  /// Draws now; else the first picture comes in its turn, after the view is first shown.
  void appear();

 protected:
  /// @param turns  of all views of the window; outlives this
  SurfaceView(QuietTurns& turns, QWidget* parent);
  void showEvent(QShowEvent* event) override;
  void setGrid(std::shared_ptr<const HeldGrid> grid);
  void setCamera(const ReliefCamera& camera);
  void setPink(const std::optional<RectMm>& pink);
  void setProbeDrawn(const std::optional<Probe>& probe, double ball_radius_mm);
  const ReliefCamera& camera() const { return state_.camera; }

  /// View position under a point of this widget on the plane z.
  ViewMm at(const QPointF& point, double z_mm) const;

  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  class Canvas;
  void requestRender();
  void paintGrid();
  void showPlain();
  void showPainted(const PaintedGrid& painted);
  void showGrid(std::shared_ptr<const HeldGrid> grid);

  SceneState state_;
  std::shared_ptr<const HeldGrid> plain_;  ///< As set; state_.grid may be painted.
  GridPainter* painter_ = nullptr;         ///< Child; owned by Qt.
  QTimer patience_;                        ///< While the colours before stand for those to come.
  std::unique_ptr<ReliefScene> scene_;
  Canvas* canvas_ = nullptr;  ///< Child; owned by Qt.
  ColourBar* bar_ = nullptr;  ///< Child; owned by Qt.
  QString where_am_i_;
};

/// Makes the views' values readable; to be called once after QApplication.
void installAccessibleViews();

}  // namespace relievo
