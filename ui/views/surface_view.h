// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <QImage>
#include <QTimer>
#include <QWidget>

#include "ui/views/overlays/view_labels.h"
#include "ui/views/scene_state.h"

namespace relievo {

class CellLegend;
class CoarsePictures;
class ColourBar;
class GridPainter;
class RenderScheduler;
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
  /// The values at the colours' ends, of looks that leave them open: those that another view shows.
  /// Nothing: from the view's own data.
  void setRange(const std::optional<std::array<double, 2>>& range);
  /// As painted; nothing for looks without a bar of colours.
  std::optional<std::array<double, 2>> shownRange() const { return shown_range_; }
  /// @param curves  as ReliefScene::setLines
  void setLines(const std::vector<std::vector<ViewMm>>& lines,
                const std::vector<std::vector<ViewMm>>& curves = {});
  void setBackground(const QColor& colour);
  /// Over the picture, not in it: what measurements read, and the mark of a profile's cursor.
  void setLabels(const std::vector<ViewLabel>& labels) { labels_->setLabels(labels); }
  void setMark(const std::optional<ViewMm>& mark) { labels_->setMark(mark); }
  /// Point of the widget over a place.
  QPointF pointOver(const ViewMm& place) const;

  QString whereAmI() const { return where_am_i_; }
  /// Where the user is in this view, in words; assistive technology hears of a change.
  void setWhereAmI(const QString& text);

  /// The view's pixels as they are on screen.
  QImage shot();
  QSize shotSize() const;

  /// Of all views of the window: a drag in one is followed by another.
  CoarsePictures& coarsePictures();

  double mmPerPixel() const;  ///< Of the widget, at the view's centre.

  /// Views that appear from now on show copies of their pictures, or what OpenGL composes; nothing:
  /// copies where OpenGL is software. For tests.
  static void setCopied(std::optional<bool> copied);

  /// Compiles what pictures need, a step in a turn, if the window is on screen. The first picture
  /// waits for it; to be asked for as soon as one will be wanted.
  void warmUp();
  /// Draws now; else the first picture comes in its turn, after the view is first shown.
  void appear();

 Q_SIGNALS:
  void painted();  ///< By values, that is with a shownRange().
  void sized();    ///< The view has another size.

 protected:
  /// @param turns  of all views of the window; outlives this
  SurfaceView(RenderScheduler& turns, QWidget* parent);
  void showEvent(QShowEvent* event) override;
  void setGrid(std::shared_ptr<const HeldGrid> grid);
  void setCamera(const ReliefCamera& camera);
  /// For pictures of the view; on screen PinkOverlay draws it.
  void setPink(const std::optional<RectMm>& pink);
  /// Does what the pointer asks for: at once, and after that once a picture of the views at most.
  /// Of what is asked for meanwhile the newest is done.
  void follow(std::function<void()> work);
  /// What was asked for and not done yet is forgotten.
  void forgetNewest() { newest_ = nullptr; }
  /// Ends what held buttons do here: nobody holds them any more, or nobody would tell when they are
  /// let go of, as while a dialog has the mouse.
  virtual void letGo() {}
  void setProbeDrawn(const std::optional<Probe>& probe, double ball_radius_mm);
  const ReliefCamera& camera() const { return state_.camera; }

  /// View position under a point of this widget on the plane z.
  ViewMm at(const QPointF& point, double z_mm) const;

  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  class Canvas;
  void requestRender();
  void paintGrid();
  void showPlain();
  void showPainted(const PaintedGrid& painted);
  void showGrid(std::shared_ptr<const HeldGrid> grid);
  void showLegend();
  ReliefLook paintedLook() const;

  RenderScheduler& scheduler_;
  bool following_ = false;  ///< Until the pictures of what was done last had their turns.
  std::function<void()> newest_;
  SceneState state_;
  std::shared_ptr<const HeldGrid> plain_;  ///< As set; state_.grid may be painted.
  GridPainter* painter_ = nullptr;         ///< Child; owned by Qt.
  QTimer patience_;                        ///< While the colours before stand for those to come.
  std::unique_ptr<ReliefScene> scene_;
  Canvas* canvas_ = nullptr;      ///< Child; owned by Qt.
  ColourBar* bar_ = nullptr;      ///< Child; owned by Qt.
  CellLegend* legend_ = nullptr;  ///< Child; owned by Qt.
  ViewLabels* labels_ = nullptr;  ///< Child; owned by Qt.
  std::optional<std::array<double, 2>> range_, shown_range_;
  QString where_am_i_;
};

/// Makes the views' values readable; to be called once after QApplication.
void installAccessibleViews();

}  // namespace relievo
