// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "ui/vtk/cloud/cloud_scene.h"

namespace relievo {

/// Points or a mesh in space on screen: turned, moved and looked at from near by mouse and keys.
/// With a tool, a cross chooses a point, or draws an outline; it goes where the mouse points or
/// where the arrow keys carry it. Accessible as one named object whose description says what is
/// under the cross. [GUI thread]
class CloudView : public QWidget {
  Q_OBJECT
 public:
  enum class Tool { turn, point, outline };
  /// A numbered point.
  struct Mark {
    FilePoint at;
    QString text;
  };
  /// Corners as a camera with this view sees them; CropOutline has the same.
  struct Outline {
    Rotation view;
    std::vector<std::array<double, 2>> corners;
  };

  explicit CloudView(const QString& name, QWidget* parent = nullptr);
  ~CloudView() override;

  /// Fits the view if there was nothing before it.
  void setCloud(std::shared_ptr<const CloudPoints> cloud);
  const CloudPoints* cloud() const { return cloud_.get(); }
  void setBox(const std::optional<CloudBox>& box);
  /// All of it is in view, too, when the view is fitted.
  void setArrow(const std::optional<CloudArrow>& arrow);
  const std::optional<CloudArrow>& arrow() const { return arrow_; }
  const std::optional<CloudBox>& box() const { return box_; }
  void setMarks(std::vector<Mark> marks);
  /// Shown while the view looks along it.
  void setOutline(std::optional<Outline> outline);
  /// Also begins the tool anew.
  void setTool(Tool tool);
  Tool tool() const { return tool_; }

  const CloudCamera& camera() const { return camera_; }
  void look(const Rotation& view);  ///< From this side; all of the points fitted.
  void fit();
  void takeColours();  ///< Of the window.
  /// As somebody turns it: `right` moves the near side to the right, `up` upward, `tilt` is
  /// counter-clockwise. Nothing while an outline is drawn, which belongs to its direction.
  void turnBy(double right_deg, double up_deg, double tilt_deg = 0);
  /// In parts of the shorter side; and as many times nearer (> 0).
  void push(double right, double up, double nearer);

  /// Pixels of this widget; where the cross is.
  QPointF cross() const { return cross_; }
  void setCross(const QPointF& at);
  /// The pixels of a place in space.
  QPointF pixelOf(const FilePoint& p) const;
  QString whereAmI() const { return where_am_i_; }
  QSize sizeHint() const override { return {480, 360}; }

 Q_SIGNALS:
  void cameraChanged();
  void pointChosen(const relievo::FilePoint& point);
  void outlineDrawn(const relievo::CloudView::Outline& outline);
  void toolLeft();  ///< By Escape.
  /// For people who do not see it.
  void said(const QString& text);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  class Canvas;
  class Overlay;

  void setCamera(const CloudCamera& camera);
  /// Draws less of a large cloud until the view has stood still for a moment.
  void drawCoarselyForNow();
  void zoomBy(double factor, const QPointF& about);
  void shiftBy(const QPointF& pixels);
  bool turnKey(QKeyEvent* event);
  bool toolKey(QKeyEvent* event);
  bool arrow(QKeyEvent* event, double step);
  void place();
  void addCorner(const QPointF& at);
  void closeOutline();
  void takeBack();
  void sayCross();
  std::optional<FilePoint> pointAt(const QPointF& at) const;
  PictureSize pictureSize() const;
  QPointF toPicture(const QPointF& at) const;
  void drawOver(QPainter& painter) const;

  std::shared_ptr<const CloudPoints> cloud_;
  CloudCamera camera_;
  Tool tool_ = Tool::turn;
  QPointF cross_, last_;
  bool fitted_ = false;  ///< Nobody has moved it since: it follows the widget's size.
  bool seen_ = false;    ///< There was something to see.
  bool dragging_ = false, drawing_ = false;
  std::vector<Mark> marks_;
  std::optional<CloudArrow> arrow_;
  std::optional<CloudBox> box_;
  std::optional<Outline> outline_;  ///< Whole, or while it is drawn.
  bool outline_open_ = false;
  int drag_corners_ = 0;  ///< Set by the drag at hand.
  QString where_am_i_;
  std::unique_ptr<CloudScene> scene_;
  QTimer still_;                ///< Since the view moved last.
  Canvas* canvas_ = nullptr;    ///< Child; owned by Qt.
  Overlay* overlay_ = nullptr;  ///< Child; owned by Qt.
};

}  // namespace relievo
