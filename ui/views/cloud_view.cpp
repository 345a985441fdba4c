// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/cloud_view.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <algorithm>
#include <cmath>
#include <QAccessible>
#include <QMouseEvent>
#include <QPainter>
#include <utility>

#include "core/prepare/recipe.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/views/view_pixels.h"
#include "ui/vtk/window_pink.h"

namespace relievo {
namespace {

constexpr double kReachPx = 12;  // Of the cross.
constexpr double kTurnDeg = 5;   // A key press; with Shift a degree.
constexpr double kDragDegPerPx = 0.4;
constexpr double kZoom = 1.25;
constexpr double kCrossStepPx = 12;  // A key press; with Shift one.
constexpr double kFreehandPx = 4;    // Between corners of an outline drawn with the mouse.
constexpr std::size_t kFluentPoints = 120'000;  // Drawn in a blink without a graphics card.
constexpr int kStillMs = 200;
constexpr int kFreehandCorners = 3;  // A drag that set so many drew the whole outline.

}  // namespace

/// The OpenGL part; sees no mouse and no keys.
class CloudView::Canvas : public QVTKOpenGLNativeWidget {
 public:
  Canvas(QWidget* parent, CloudScene& scene) : QVTKOpenGLNativeWidget(parent), scene_(scene) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setEnableHiDPI(true);
    setDefaultCursor(Qt::ArrowCursor);
    setRenderWindow(window_);
    if (interactor() != nullptr) interactor()->SetInteractorStyle(nullptr);
    window_->SetMultiSamples(0);
    scene_.attachTo(window_);
  }
  /// Many changes between two frames are one picture: Qt joins them.
  void requestRender() {
    stale_ = true;
    update();
  }

 protected:
  void paintGL() override {
    prepare();  // After a change of size VTK draws in here by itself.
    if (std::exchange(stale_, false)) renderWindow()->Render();
    QVTKOpenGLNativeWidget::paintGL();
  }

 private:
  void prepare() {
    const QSize pixels = size() * devicePixelRatioF();
    scene_.prepare({std::max(1, pixels.width()), std::max(1, pixels.height())},
                   devicePixelRatioF() * textScale());
  }

  CloudScene& scene_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  bool stale_ = false;
};

/// Marks, cross and outline above the picture.
class CloudView::Overlay : public QWidget {
 public:
  explicit Overlay(CloudView* view) : QWidget(view), view_(view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    view_->drawOver(painter);
  }

 private:
  CloudView* view_;
};

CloudView::CloudView(const QString& name, QWidget* parent)
    : QWidget(parent), scene_(std::make_unique<CloudScene>()) {
  setAccessibleName(name);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 140);
  canvas_ = new Canvas(this, *scene_);
  overlay_ = new Overlay(this);
  takeColours();
  camera_.view = *standardRotation("front");
  scene_->setCamera(camera_);
  still_.setSingleShot(true);
  still_.setInterval(kStillMs);
  connect(&still_, &QTimer::timeout, this, [this] {
    scene_->setCoarseness(1);
    canvas_->requestRender();
  });
}

// The canvas draws the scene: it goes first.
CloudView::~CloudView() {
  delete canvas_;
}

void CloudView::takeColours() {
  const QColor ground = currentColours().viewport;
  scene_->setBackground(ground.redF(), ground.greenF(), ground.blueF());
  canvas_->requestRender();
}

void CloudView::setCloud(std::shared_ptr<const CloudPoints> cloud) {
  cloud_ = std::move(cloud);
  scene_->setPoints(cloud_);
  if (!seen_ && cloud_ && !cloud_->points.empty()) {
    seen_ = true;
    fit();
  }
  canvas_->requestRender();
  overlay_->update();
}

void CloudView::setBox(const std::optional<CloudBox>& box) {
  box_ = box;
  scene_->setBox(box);
  canvas_->requestRender();
}

void CloudView::setArrow(const std::optional<CloudArrow>& arrow) {
  if (arrow == arrow_) return;
  arrow_ = arrow;
  scene_->setArrow(arrow);
  if (fitted_) fit();
  canvas_->requestRender();
}

void CloudView::setMarks(std::vector<Mark> marks) {
  marks_ = std::move(marks);
  overlay_->update();
}

void CloudView::setOutline(std::optional<Outline> outline) {
  if (outline_open_) return;  // One is being drawn.
  outline_ = std::move(outline);
  overlay_->update();
}

void CloudView::setTool(Tool tool) {
  tool_ = tool;
  dragging_ = drawing_ = false;
  if (outline_open_) outline_.reset();
  outline_open_ = false;
  if (tool != Tool::turn) cross_ = QRectF(rect()).center();
  setCursor(tool == Tool::turn ? Qt::OpenHandCursor : Qt::CrossCursor);
  sayCross();
  overlay_->update();
}

void CloudView::look(const Rotation& view) {
  camera_.view = view;
  fit();
}

void CloudView::fit() {
  if (!cloud_ || cloud_->points.empty()) return;
  FileBounds box{cloud_->origin, cloud_->origin};
  bool first = true;
  for (const auto& q : cloud_->points) {
    const FilePoint p =
        cloud_->origin +
        FilePoint{static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2])};
    if (first) box = {p, p};
    first = false;
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
  if (arrow_) {
    for (const FilePoint& p : {arrow_->from, arrow_->to}) {
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
    }
  }
  setCamera(fitted(camera_, box, pictureSize()));
  fitted_ = true;
}

void CloudView::setCamera(const CloudCamera& camera) {
  camera_ = camera;
  fitted_ = false;
  scene_->setCamera(camera_);
  canvas_->requestRender();
  overlay_->update();
  if (tool_ != Tool::turn) sayCross();
  Q_EMIT cameraChanged();
}

void CloudView::drawCoarselyForNow() {
  if (!cloud_) return;
  const std::size_t drawn =
      cloud_->triangles.empty() ? cloud_->points.size() : cloud_->triangles.size();
  if (drawn <= kFluentPoints) return;
  scene_->setCoarseness(std::max<std::size_t>(2, cloud_->points.size() / kFluentPoints));
  still_.start();
}

void CloudView::turnBy(double right_deg, double up_deg, double tilt_deg) {
  if (outline_open_) return;
  drawCoarselyForNow();
  setCamera(turnedBy(camera_, right_deg, up_deg, tilt_deg));
}

void CloudView::push(double right, double up, double nearer) {
  const double side = std::min(pictureSize().width, pictureSize().height);
  if (right != 0 || up != 0) shiftBy({side * right, -side * up});
  if (nearer != 1) zoomBy(nearer, QRectF(rect()).center());
}

void CloudView::zoomBy(double factor, const QPointF& about) {
  const QPointF at = toPicture(about);
  const auto before = seenUnder(camera_, pictureSize(), {at.x(), at.y()});
  CloudCamera next = camera_;
  next.height /= factor;
  const auto after = seenUnder(next, pictureSize(), {at.x(), at.y()});
  const Rotation& r = next.view;
  const FilePoint right{r[0], r[1], r[2]}, up{r[3], r[4], r[5]};
  next.middle = next.middle + (before[0] - after[0]) * right + (before[1] - after[1]) * up;
  drawCoarselyForNow();
  setCamera(next);
}

void CloudView::shiftBy(const QPointF& pixels) {
  const double unit = camera_.height / pictureSize().height;
  const Rotation& r = camera_.view;
  const FilePoint right{r[0], r[1], r[2]}, up{r[3], r[4], r[5]};
  CloudCamera next = camera_;
  next.middle = next.middle - (pixels.x() * unit) * right + (pixels.y() * unit) * up;
  drawCoarselyForNow();
  setCamera(next);
}

PictureSize CloudView::pictureSize() const {
  return {std::max(1, width() - 2 * kFocusFramePx), std::max(1, height() - 2 * kFocusFramePx)};
}

QPointF CloudView::toPicture(const QPointF& at) const {
  return at - QPointF(kFocusFramePx, kFocusFramePx);
}

QPointF CloudView::pixelOf(const FilePoint& p) const {
  const PicturePlace place = placeOf(camera_, pictureSize(), p);
  return QPointF(place.x, place.y) + QPointF(kFocusFramePx, kFocusFramePx);
}

std::optional<FilePoint> CloudView::pointAt(const QPointF& at) const {
  if (!cloud_) return std::nullopt;
  const QPointF p = toPicture(at);
  const auto found =
      pointUnder(camera_, pictureSize(), {p.x(), p.y()}, kReachPx, cloud_->origin, cloud_->points);
  if (!found) return std::nullopt;
  const auto& q = cloud_->points[*found];
  return cloud_->origin +
         FilePoint{static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2])};
}

void CloudView::setCross(const QPointF& at) {
  cross_ = {std::clamp(at.x(), 0.0, width() - 1.0), std::clamp(at.y(), 0.0, height() - 1.0)};
  overlay_->update();
}

void CloudView::sayCross() {
  QString text;
  if (tool_ == Tool::point) {
    const auto p = pointAt(cross_);
    text = p ? tr("A point under the cross: %1, %2, %3")
                   .arg(numberText(p->x, 2), numberText(p->y, 2), numberText(p->z, 2))
             : tr("No point under the cross");
  } else if (tool_ == Tool::outline) {
    const auto corners = outline_open_ ? outline_->corners.size() : 0;
    text = tr("%n corner(s) so far", nullptr, static_cast<int>(corners));
  }
  if (text == where_am_i_) return;
  where_am_i_ = text;
  setAccessibleDescription(text);
}

void CloudView::place() {
  if (tool_ == Tool::outline) {
    addCorner(cross_);
    return;
  }
  if (const auto p = pointAt(cross_)) {
    Q_EMIT pointChosen(*p);
  } else {
    Q_EMIT said(tr("No point under the cross"));
  }
}

void CloudView::addCorner(const QPointF& at) {
  if (!outline_open_) outline_ = Outline{camera_.view, {}};
  outline_open_ = true;
  if (outline_->corners.size() >= kMostOutlineCorners) return;
  const QPointF p = toPicture(at);
  outline_->corners.push_back(seenUnder(camera_, pictureSize(), {p.x(), p.y()}));
  sayCross();
  overlay_->update();
}

void CloudView::closeOutline() {
  if (!outline_open_) return;
  if (outline_->corners.size() < 3) {
    Q_EMIT said(tr("An outline needs three corners"));
    return;
  }
  outline_open_ = false;
  const Outline drawn = *outline_;
  sayCross();
  Q_EMIT outlineDrawn(drawn);
}

void CloudView::takeBack() {
  if (!outline_open_) return;
  if (!outline_->corners.empty()) outline_->corners.pop_back();
  if (outline_->corners.empty()) {
    outline_.reset();
    outline_open_ = false;
  }
  sayCross();
  overlay_->update();
}

void CloudView::mousePressEvent(QMouseEvent* event) {
  last_ = event->localPos();
  dragging_ = true;
  if (tool_ == Tool::turn || event->button() != Qt::LeftButton) return;
  setCross(event->localPos());
  if (tool_ == Tool::outline) {
    drawing_ = true;
    drag_corners_ = 0;
    addCorner(cross_);
  }
}

void CloudView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF moved = event->localPos() - last_;
  const bool left = (event->buttons() & Qt::LeftButton) != 0;
  if (event->buttons() == Qt::NoButton) dragging_ = drawing_ = false;  // The release went astray.
  if (tool_ != Tool::turn && (left || event->buttons() == Qt::NoButton)) {
    setCross(event->localPos());
    if (drawing_ && left && std::hypot(moved.x(), moved.y()) >= kFreehandPx) {
      last_ = event->localPos();
      ++drag_corners_;
      addCorner(cross_);
    }
    if (event->buttons() == Qt::NoButton) return;
  }
  if (!dragging_) return;
  const bool turns = tool_ == Tool::turn ? left : (event->buttons() & Qt::MiddleButton) != 0;
  if (turns && !outline_open_) {
    turnBy(kDragDegPerPx * moved.x(), -kDragDegPerPx * moved.y());
  } else if ((event->buttons() & (Qt::RightButton | Qt::MiddleButton)) != 0) {
    shiftBy(moved);
  } else {
    return;
  }
  last_ = event->localPos();
}

void CloudView::mouseReleaseEvent(QMouseEvent* event) {
  dragging_ = false;
  if (event->button() != Qt::LeftButton || tool_ == Tool::turn) return;
  if (tool_ == Tool::point) {
    setCross(event->localPos());
    sayCross();
    place();
    return;
  }
  // A drag is a whole outline; single clicks are corners, until Enter closes it.
  if (std::exchange(drawing_, false) && drag_corners_ >= kFreehandCorners) closeOutline();
}

void CloudView::wheelEvent(QWheelEvent* event) {
  zoomBy(std::pow(kZoom, event->angleDelta().y() / 120.0), event->position());
  event->accept();
}

bool CloudView::arrow(QKeyEvent* event, double step) {
  QPointF by;
  switch (event->key()) {
    case Qt::Key_Left:
      by = {-1, 0};
      break;
    case Qt::Key_Right:
      by = {1, 0};
      break;
    case Qt::Key_Up:
      by = {0, -1};
      break;
    case Qt::Key_Down:
      by = {0, 1};
      break;
    default:
      return false;
  }
  const bool fine = (event->modifiers() & Qt::ShiftModifier) != 0;
  if (tool_ != Tool::turn && (event->modifiers() & Qt::ControlModifier) == 0) {
    setCross(cross_ + (fine ? 1 : step) * by);
    sayCross();
    if (tool_ == Tool::point) Q_EMIT said(where_am_i_);
    return true;
  }
  if (outline_open_) return true;  // It belongs to the direction that it was begun in.
  const double deg = fine ? 1 : kTurnDeg;
  turnBy(deg * by.x(), -deg * by.y());
  return true;
}

bool CloudView::turnKey(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      zoomBy(kZoom, QRectF(rect()).center());
      return true;
    case Qt::Key_Minus:
      zoomBy(1 / kZoom, QRectF(rect()).center());
      return true;
    case Qt::Key_Home:
      fit();
      return true;
    default:
      return arrow(event, kCrossStepPx * textScale());
  }
}

bool CloudView::toolKey(QKeyEvent* event) {
  if (tool_ == Tool::turn) return false;
  const bool control = (event->modifiers() & Qt::ControlModifier) != 0;
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (tool_ == Tool::outline && control) {
        closeOutline();
      } else {
        place();
      }
      return true;
    case Qt::Key_Space:
      place();
      return true;
    case Qt::Key_Backspace:
      takeBack();
      return true;
    case Qt::Key_Escape:
      setTool(Tool::turn);
      Q_EMIT toolLeft();
      return true;
    default:
      return false;
  }
}

void CloudView::keyPressEvent(QKeyEvent* event) {
  if (toolKey(event) || turnKey(event)) {
    event->accept();
  } else {
    QWidget::keyPressEvent(event);
  }
}

// Keys that are a tool's are not the dialog's, whose Enter means OK and whose Escape means Cancel.
bool CloudView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && tool_ != Tool::turn) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void CloudView::resizeEvent(QResizeEvent* /*event*/) {
  if (tool_ == Tool::turn || !QRectF(rect()).contains(cross_)) cross_ = QRectF(rect()).center();
  if (fitted_) fit();
  // Draws at once: after the camera is right.
  canvas_->setGeometry(
      rect().adjusted(kFocusFramePx, kFocusFramePx, -kFocusFramePx, -kFocusFramePx));
  overlay_->setGeometry(rect());
  overlay_->raise();
  canvas_->requestRender();
}

void CloudView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(),
                   hasFocus() ? palette().color(QPalette::Highlight) : currentColours().viewport);
}

void CloudView::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
  overlay_->update();
}

void CloudView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
  overlay_->update();
}

void CloudView::drawOver(QPainter& painter) const {
  const double scale = textScale();
  const QColor pink(kPink[0], kPink[1], kPink[2]);
  // A dark line below a light one shows on any ground.
  const auto stroke = [&](const auto& draw, const QColor& colour) {
    painter.setPen(QPen(Qt::black, 4 * scale));
    draw();
    painter.setPen(QPen(colour, 2 * scale));
    draw();
  };
  if (outline_ && (outline_open_ || outline_->view == camera_.view)) {
    QPolygonF polygon;
    const auto middle = seenAt(camera_, camera_.middle);
    const PictureSize size = pictureSize();
    const double unit = camera_.height / size.height;
    for (const auto& c : outline_->corners) {
      polygon << QPointF(0.5 * size.width + (c[0] - middle[0]) / unit + kFocusFramePx,
                         0.5 * size.height - (c[1] - middle[1]) / unit + kFocusFramePx);
    }
    stroke([&] { outline_open_ ? painter.drawPolyline(polygon) : painter.drawPolygon(polygon); },
           pink);
  }
  for (const Mark& mark : marks_) {
    const QPointF at = pixelOf(mark.at);
    const double r = 6 * scale;
    painter.setBrush(Qt::NoBrush);
    stroke([&] { painter.drawEllipse(at, r, r); }, pink);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    const QPointF beside = at + QPointF(1.4 * r, -0.6 * r);
    painter.setPen(Qt::black);
    for (const QPointF& by : {QPointF(1, 1), QPointF(-1, 1), QPointF(1, -1), QPointF(-1, -1)}) {
      painter.drawText(beside + by, mark.text);
    }
    painter.setPen(Qt::white);
    painter.drawText(beside, mark.text);
  }
  if (tool_ != Tool::turn && hasFocus()) {
    const double r = 14 * scale;
    stroke(
        [&] {
          painter.drawLine(cross_ - QPointF(r, 0), cross_ + QPointF(r, 0));
          painter.drawLine(cross_ - QPointF(0, r), cross_ + QPointF(0, r));
        },
        Qt::white);
  }
}

}  // namespace relievo
