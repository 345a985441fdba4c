// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/detail_view.h"

#include <algorithm>
#include <cmath>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "core/region/carry.h"
#include "core/session/colours/surface_colours.h"
#include "core/tiles/tiled_map.h"
#include "ui/vtk/ball_size.h"

namespace relievo {
namespace {

constexpr double kZoomStep = 1.25;
constexpr double kDepthStepMm = 0.25;  // Of hand, per notch or key press.
constexpr double kMostDepthMm = 10;
constexpr double kTurnDegPerPixel = 0.4;
constexpr double kZoomPixels = 20;  // Of dragging upwards, for one notch of the wheel.
constexpr double kDeg = 3.14159265358979323846 / 180;

std::shared_ptr<const HeldGrid> gridOf(const Surface& surface, const RegionWindow& window) {
  auto grid = std::make_shared<HeldGrid>();
  const double step = window.spacingMm();
  grid->frame = {{kWindowSamples, kWindowSamples},
                 step,
                 window.region.x_mm + 0.5 * step,
                 window.region.y_mm + 0.5 * step};
  grid->heights_mm = window.heights_mm;
  grid->origins = window.origins;
  // Colours of a map from the web follow.
  const bool are_here = !surface.tiles || surface.tiles->coloursAtHand(window.region);
  if (are_here || !surface.tiles->isRemote()) grid->own = windowColours(surface, window);
  return grid;
}

}  // namespace

DetailView::DetailView(Document& document, RenderScheduler& turns, QWidget* parent)
    : SurfaceView(turns, parent), document_(document) {
  setObjectName(QStringLiteral("detail_view"));
  setAccessibleName(tr("Detail view"));
  setBindings({});
  showCursor();
  connect(&document_, &Document::windowChanged, this, &DetailView::showWindow);
  connect(&document_, &Document::turnChanged, this, &DetailView::showTurn);
  showWindow();
}

void DetailView::showWindow() {
  const auto window = document_.window();
  if (!window) {  // Closed, perhaps in the middle of a drag or a press.
    forgetNewest();
    drag_ = Drag::none;
    mouse_presses_ = false;
    key_depth_mm_ = 0;
    setGrid(nullptr);
    return;
  }
  setGrid(gridOf(*document_.surface(), *window));
  // What comes finer from the web is at the same place.
  Region place = window->region;
  place.level = document_.project().region.level;
  if (camera_region_ != place) fitCamera();
  camera_region_ = place;
  clearProbe();
  if (inside_ && drag_ == Drag::none) keepHand();
}

/// Over another window: at its place, so that steps of detail go on about it; where that is not in
/// the window, below the pointer that carries it, or as far as the window goes.
void DetailView::keepHand() {
  const Region& r = document_.window()->region;
  const double x = std::clamp(hand_.x, r.x_mm, r.x_mm + r.side_mm);
  const double y = std::clamp(hand_.y, r.y_mm, r.y_mm + r.side_mm);
  const bool is_over = x == hand_.x && y == hand_.y;
  if (!is_over && pointer_ && !pressing()) return pointHandAt(*pointer_);
  placeHand(x, y);
}

void DetailView::fitCamera() {
  const Region& r = document_.project().region;
  ReliefCamera next = camera();
  next.rect = {r.x_mm, r.y_mm, r.side_mm, r.side_mm};
  setCamera(next);
}

bool DetailView::isTurned() const {
  const Project& shown = document_.project();
  return shown.azimuth_deg != 0 || shown.elevation_deg != 0;
}

void DetailView::straighten() {
  document_.straighten();
}

void DetailView::turnBy(double azimuth_deg, double elevation_deg, int merge_id) {
  const Project& shown = document_.project();
  document_.turnView(shown.azimuth_deg + azimuth_deg, shown.elevation_deg + elevation_deg,
                     merge_id);
  Q_EMIT turnedBySomebody();
}

void DetailView::showTurn() {
  ReliefCamera next = camera();
  next.azimuth_deg = document_.project().azimuth_deg;
  next.elevation_deg = document_.project().elevation_deg;
  setCamera(next);
  Q_EMIT turned(isTurned());
}

Rotation DetailView::cameraRotation() const {
  const double a = camera().azimuth_deg * kDeg;
  const double e = camera().elevation_deg * kDeg;
  // Rows: the camera's right, up, and the direction towards the viewer, in view axes.
  return {std::cos(a),
          0,
          -std::sin(a),
          -std::sin(a) * std::sin(e),
          std::cos(e),
          -std::cos(a) * std::sin(e),
          std::sin(a) * std::cos(e),
          std::sin(e),
          std::cos(a) * std::cos(e)};
}

Rotation DetailView::lookRotation() const {
  const auto& m = document_.surface()->view_from_file.m;
  const double scale = std::hypot(m[0], m[4], m[8]);
  const Rotation camera = cameraRotation();
  Rotation turned{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        turned[3 * i + j] += camera[3 * i + k] * m[4 * k + j] / scale;
      }
    }
  }
  return turned;
}

void DetailView::showProbe(const Probe& probe) {
  const auto window = document_.window();
  if (!window || probe.window_id != window->id) return;
  setProbeDrawn(probe, kBallOfSide * window->region.side_mm);
}

void DetailView::clearProbe() {
  setProbeDrawn({}, 1);
}

void DetailView::setPressDepthMm(double depth_hand_mm) {
  const double depth = std::clamp(depth_hand_mm, kDepthStepMm, kMostDepthMm);
  if (depth == press_depth_mm_) return;
  press_depth_mm_ = depth;
  Q_EMIT pressDepthChanged(depth);
  if (mouse_presses_) placeHand(hand_.x, hand_.y);
}

ViewMm DetailView::onSurface(const QPointF& point) const {
  const auto window = document_.window();
  const auto top = static_cast<double>(window->max_mm);
  const auto bottom = static_cast<double>(window->min_mm);
  const ViewMm high = at(point, top);
  if (!isTurned() || !(top > bottom)) return high;
  const ViewMm low = at(point, bottom);
  // From the viewer downwards, in steps of about a sample, to the first place below the surface.
  const double run = std::hypot(low.x - high.x, low.y - high.y);
  const int steps = std::clamp(static_cast<int>(run / window->spacingMm()) + 1, 1, 1000);
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const ViewMm p = high + t * (low - high);
    if (windowHeightMm(*window, p.x, p.y) >= p.z) return p;
  }
  return low;
}

void DetailView::pointHandAt(const QPointF& point) {
  pointer_ = point;
  const ViewMm p = onSurface(point);
  placeHand(p.x, p.y);
}

bool DetailView::carryHandTo(double x_mm, double y_mm) {
  const auto window = document_.window();
  if (!window) return false;
  const Region& r = window->region;
  if (x_mm < r.x_mm || x_mm > r.x_mm + r.side_mm || y_mm < r.y_mm || y_mm > r.y_mm + r.side_mm) {
    return false;
  }
  pointer_.reset();
  placeHand(x_mm, y_mm);
  return true;
}

void DetailView::placeHand(double x_mm, double y_mm) {
  const auto window = document_.window();
  if (!window) return;
  const double depth = mouse_presses_ ? press_depth_mm_ : key_depth_mm_;
  hand_ = handOver(*window, x_mm, y_mm, pressing(), depth);
  inside_ = true;
  Q_EMIT handMoved(hand_, true);
}

DetailView::Drag DetailView::dragOf(Qt::MouseButton button) const {
  const bool looks = mode_ == PointerMode::look;
  PointerAct act = PointerAct::none;
  if (button == Qt::LeftButton && looks) act = bindings_.look_left;
  if (button == Qt::MiddleButton) act = looks ? bindings_.look_middle : bindings_.touch_middle;
  if (button == Qt::RightButton) act = looks ? bindings_.look_right : bindings_.touch_right;
  switch (act) {
    case PointerAct::turn:
      return Drag::turn;
    case PointerAct::move:
      return Drag::pan;
    case PointerAct::zoom:
      return Drag::zoom;
    case PointerAct::none:
      break;
  }
  return Drag::none;
}

void DetailView::showCursor() {
  if (drag_ == Drag::turn) {
    setCursor(Qt::ClosedHandCursor);
  } else if (drag_ == Drag::pan) {
    setCursor(Qt::SizeAllCursor);
  } else if (drag_ == Drag::zoom) {
    setCursor(Qt::SizeVerCursor);
  } else if (picking_) {
    setCursor(Qt::PointingHandCursor);
  } else if (own_cursor_) {
    setCursor(*own_cursor_);
  } else {
    setCursor(mode_ == PointerMode::look ? Qt::OpenHandCursor : Qt::CrossCursor);
  }
}

void DetailView::setOwnCursor(const std::optional<QCursor>& cursor) {
  own_cursor_ = cursor;
  showCursor();
}

double DetailView::risePerWay(const QPointF& from, const QPointF& to) const {
  const auto window = document_.window();
  if (!window) return 0;
  const ViewMm a = onSurface(from);
  const ViewMm b = onSurface(to);
  const double way_mm = std::hypot(b.x - a.x, b.y - a.y);
  if (!(way_mm > 0)) return 0;
  const double rise_mm = windowHeightMm(*window, b.x, b.y) - windowHeightMm(*window, a.x, a.y);
  return document_.project().gain * rise_mm / way_mm;
}

double DetailView::heightShare(const QPointF& point) const {
  constexpr double kFlat = 0.5;
  const auto window = document_.window();
  if (!window || !(window->max_mm > window->min_mm)) return kFlat;
  const ViewMm p = onSurface(point);
  const auto lowest = static_cast<double>(window->min_mm);
  return (windowHeightMm(*window, p.x, p.y) - lowest) /
         (static_cast<double>(window->max_mm) - lowest);
}

void DetailView::setPointerMode(PointerMode mode) {
  if (mode == mode_) return;
  mode_ = mode;
  if (std::exchange(mouse_presses_, false)) placeHand(hand_.x, hand_.y);
  showCursor();
}

void DetailView::mousePressEvent(QMouseEvent* event) {
  if (!document_.isOpen() || drag_ != Drag::none) return;
  drag_point_ = event->localPos();
  drag_start_ = document_.project().region;
  if (event->button() == Qt::LeftButton && picking_) {
    const ViewMm p = onSurface(event->localPos());
    Q_EMIT picked(p.x, p.y);
    return;
  }
  if (event->button() == Qt::LeftButton && mode_ == PointerMode::touch) {
    mouse_presses_ = true;
    key_depth_mm_ = 0;
    pointHandAt(event->localPos());
    return;
  }
  drag_ = dragOf(event->button());
  if (drag_ == Drag::none) {
    QWidget::mousePressEvent(event);
    return;
  }
  drag_button_ = event->button();
  showCursor();
}

void DetailView::setBindings(const PointerBindings& bindings) {
  bindings_ = bindings;
  setWhatsThis(
      tr("The part inside the pink window. The pointer carries the hand just above the surface. "
         "What dragging does, F7 changes between the two: %1. %2; the wheel meanwhile presses "
         "deeper, and with another button held it changes the resolution. Keys: arrows, Page Down, "
         "Page Up.")
          .arg(bindingsText(PointerMode::look, bindings),
               bindingsText(PointerMode::touch, bindings)));
}

void DetailView::setPicking(bool on) {
  picking_ = on;
  showCursor();
}

void DetailView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (picking_ && event->button() == Qt::LeftButton) {
    Q_EMIT pickingEnded();
  } else {
    mousePressEvent(event);
  }
}

void DetailView::mouseMoveEvent(QMouseEvent* event) {
  if (!document_.isOpen()) return;
  const Qt::MouseButton held = mouse_presses_ ? Qt::LeftButton : drag_button_;
  if ((event->buttons() & held) == 0) letGo();  // Somebody else got the release.
  const QPointF point = event->localPos();
  if (drag_ == Drag::turn) {
    follow([this, point] {
      if (drag_ == Drag::turn) turnTo(point);
    });
  } else if (drag_ == Drag::pan) {
    follow([this, point] {
      if (drag_ == Drag::pan) pan(point);
    });
  } else if (drag_ == Drag::zoom) {
    const int notches = static_cast<int>((drag_point_.y() - point.y()) / kZoomPixels);
    if (notches == 0) return;
    drag_point_.ry() -= notches * kZoomPixels;
    zoomAbout(QRectF(rect()).center(), notches);
  } else {
    pointHandAt(point);
  }
}

void DetailView::pan(const QPointF& point) {
  const double mm = mmPerPixel() / drag_start_.side_mm;
  const QPointF way = point - drag_point_;
  const auto next = moved(document_.surface()->ladder, drag_start_, -way.x() * mm, way.y() * mm);
  document_.region().preview(next.value_or(drag_start_));
}

void DetailView::turnTo(const QPointF& point) {
  const QPointF way = point - std::exchange(drag_point_, point);
  turnBy(-kTurnDegPerPixel * way.x(), kTurnDegPerPixel * way.y());
}

void DetailView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && mouse_presses_) {
    mouse_presses_ = false;
    if (document_.isOpen()) pointHandAt(event->localPos());
    return;
  }
  if (drag_ == Drag::none || event->button() != drag_button_) return;
  const bool moved_window = drag_ == Drag::pan;
  forgetNewest();
  if (moved_window && event->localPos() != drag_point_) pan(event->localPos());
  if (drag_ == Drag::turn) turnTo(event->localPos());
  drag_ = Drag::none;
  showCursor();
  if (moved_window) document_.region().commit(tr("Move window"));
}

// A hand that keys pressed in stays: no button is held that could be let go of.
void DetailView::letGo() {
  if (std::exchange(mouse_presses_, false) && document_.isOpen()) placeHand(hand_.x, hand_.y);
  const Drag ended = std::exchange(drag_, Drag::none);
  if (ended == Drag::none) return;
  forgetNewest();
  showCursor();
  if (ended == Drag::pan) document_.region().commit(tr("Move window"));
}

void DetailView::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  if (mouse_presses_ || !inside_ || key_depth_mm_ > 0) return;
  inside_ = false;
  pointer_.reset();
  Q_EMIT handMoved(hand_, false);
}

void DetailView::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (!document_.isOpen() || (drag_ != Drag::none && !mouse_presses_)) return;
  wheel_rest_ += event->angleDelta().y();
  const int notches = wheel_rest_ / QWheelEvent::DefaultDeltasPerStep;
  wheel_rest_ -= notches * QWheelEvent::DefaultDeltasPerStep;
  if (notches == 0) return;
  if (drag_ != Drag::none) {
    stepResolution(event->position(), (notches > 0) == bindings_.forward_is_closer);
  } else if (mouse_presses_ || (event->modifiers() & Qt::ControlModifier) != 0) {
    // Pushing the wheel away from oneself pushes into the surface.
    setPressDepthMm(press_depth_mm_ + kDepthStepMm * notches);
  } else {
    zoomAbout(event->position(), bindings_.forward_is_closer ? notches : -notches);
  }
}

// What the other button has moved so far is a step before this one; from here it goes on.
void DetailView::stepResolution(const QPointF& point, bool finer) {
  forgetNewest();
  if (drag_ == Drag::pan) document_.region().commit(tr("Move window"));
  Q_EMIT resolutionAsked(finer);
  drag_point_ = point;
  drag_start_ = document_.project().region;
}

void DetailView::zoomAbout(const QPointF& point, int notches) {
  const DetailLadder& ladder = document_.surface()->ladder;
  const ViewMm p = onSurface(point);
  const Region next =
      zoomed(ladder, document_.project().region, {std::pow(kZoomStep, notches), p.x, p.y});
  if (next == wholeRegion(ladder)) {
    document_.region().whole();
  } else {
    document_.region().zoomTo(next);
  }
}

bool DetailView::moveHandByKey(int key, double cells) {
  const auto window = document_.window();
  const double step = cells * window->spacingMm();
  const Region& r = window->region;
  if (!inside_) hand_ = {r.centreX(), r.centreY(), 0};
  double x = hand_.x;
  double y = hand_.y;
  switch (key) {
    case Qt::Key_Left:
      x -= step;
      break;
    case Qt::Key_Right:
      x += step;
      break;
    case Qt::Key_Down:
      y -= step;
      break;
    case Qt::Key_Up:
      y += step;
      break;
    case Qt::Key_PageDown:
      key_depth_mm_ = std::min(key_depth_mm_ + kDepthStepMm, kMostDepthMm);
      break;
    case Qt::Key_PageUp:
      key_depth_mm_ = std::max(key_depth_mm_ - kDepthStepMm, 0.0);
      break;
    default:
      return false;
  }
  pointer_.reset();
  placeHand(std::clamp(x, r.x_mm, r.x_mm + r.side_mm), std::clamp(y, r.y_mm, r.y_mm + r.side_mm));
  return true;
}

void DetailView::keyPressEvent(QKeyEvent* event) {
  const bool ours =
      document_.isOpen() && (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) == 0;
  if (event->key() == Qt::Key_Escape && drag_ == Drag::pan) {
    forgetNewest();
    document_.region().revert();
    drag_ = Drag::none;
    showCursor();
    return;
  }
  if (ours && picking_) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && inside_) {
      Q_EMIT picked(hand_.x, hand_.y);
      return;
    }
    if (event->key() == Qt::Key_F) {
      Q_EMIT pickingEnded();
      return;
    }
  }
  const double cells = (event->modifiers() & Qt::ShiftModifier) != 0 ? 10 : 1;
  if (ours && moveHandByKey(event->key(), cells)) return;
  SurfaceView::keyPressEvent(event);
}

}  // namespace relievo
