// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/reference_view.h"

#include <algorithm>
#include <cmath>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "core/base/error.h"
#include "core/session/colours/surface_colours.h"
#include "core/session/large/crop_level.h"
#include "ui/language/error_text.h"
#include "ui/style/text.h"
#include "ui/views/overlays/pink_overlay.h"

namespace relievo {
namespace {

constexpr double kGripPixels = 7;
constexpr double kClickPixels = 4;  // Shorter than this is a click, not a drag.
constexpr int kMostSamples = 400;   // Per side; software graphics stay fluent.
constexpr double kMargin = 0.04;    // Around the object's square, of its side.
constexpr double kArrowStep = 0.05;
constexpr double kDrawStep = 0.02;  // Of the map's longer side, per key.
constexpr double kResizeStep = 1.1;
constexpr double kLeastCells = 8;  // Side of the smallest window, in finest cells.

/// The coarsest detail that still fills the view. Of a thin map a coarser one may have a single
/// row.
std::shared_ptr<const HeldGrid> referenceGrid(const Surface& surface) {
  Level level;
  for (; level.value + 1 < surface.ladder.levels(); ++level.value) {
    const GridSize size = levelFrame(surface, level).size;
    if (std::max(size.cols, size.rows) <= kMostSamples) break;
    const GridSize next = levelFrame(surface, Level{level.value + 1}).size;
    if (std::min(next.cols, next.rows) < 2) break;
  }
  DepthMap map = cropLevel(surface, level);
  auto grid = std::make_shared<HeldGrid>();
  grid->frame = map.frame;
  grid->heights_mm = std::move(map.heights_mm);
  grid->origins = std::move(map.origins);
  grid->own = levelColours(surface, level);
  return grid;
}

/// The whole object's window with a margin. That is square however long or tall the object is, and
/// all of it is in view, so that its edges and corners can be grabbed.
RectMm fittedRect(const DetailLadder& map) {
  const Region whole = wholeRegion(map);
  const double margin = kMargin * whole.side_mm;
  return {whole.x_mm - margin, whole.y_mm - margin, whole.side_mm + 2 * margin,
          whole.side_mm + 2 * margin};
}

Qt::CursorShape cursorFor(PinkPart part) {
  switch (part) {
    case PinkPart::outside:
      return Qt::CrossCursor;
    case PinkPart::inside:
      return Qt::SizeAllCursor;
    case PinkPart::left:
    case PinkPart::right:
      return Qt::SizeHorCursor;
    case PinkPart::bottom:
    case PinkPart::top:
      return Qt::SizeVerCursor;
    case PinkPart::left_bottom:
    case PinkPart::right_top:
      return Qt::SizeBDiagCursor;
    case PinkPart::right_bottom:
    case PinkPart::left_top:
      return Qt::SizeFDiagCursor;
  }
  return Qt::ArrowCursor;
}

QString nameOf(PinkPart part) {
  if (part == PinkPart::outside) return ReferenceView::tr("Draw window");
  return part == PinkPart::inside ? ReferenceView::tr("Move window")
                                  : ReferenceView::tr("Resize window");
}

}  // namespace

ReferenceView::ReferenceView(Document& document, RenderScheduler& turns, QWidget* parent)
    : SurfaceView(turns, parent),
      document_(document),
      suggested_(new SuggestionFrames(this, [this](double x, double y) { return pointOf(x, y); })),
      pink_(new PinkOverlay(this)) {
  setObjectName(QStringLiteral("reference_view"));
  setAccessibleName(tr("Overview"));
  setToolTip({});
  setWhatsThis(tr(
      "The whole object. The pink window is what the detail view shows: drag inside it to move "
      "it, drag its edges to resize it, drag outside to draw a new one. The wheel changes the "
      "resolution. Keys: arrows, Shift+arrows, + and -; Space, arrows and Enter draw a window."));
  connect(&document_, &Document::surfaceChanged, this, &ReferenceView::showSurface);
  connect(&document_, &Document::windowChanged, this, &ReferenceView::showWindow);
  showSurface();
  showWindow();
}

void ReferenceView::showSurface() {
  forgetNewest();
  drag_.reset();
  key_draw_.reset();
  if (!document_.isOpen()) {
    setGrid(nullptr);
    return;
  }
  const Surface& surface = *document_.surface();
  try {
    setGrid(referenceGrid(surface));
  } catch (const FileError& error) {  // Of a map by tiles whose files went meanwhile.
    setGrid(nullptr);
    setWhereAmI(spokenError(error));
  }
  setCamera({.rect = fittedRect(surface.ladder)});
  placePink();
}

void ReferenceView::placePink() {
  if (!document_.isOpen()) {
    pink_->setFrame({});
    return;
  }
  const Region& r = document_.project().region;
  pink_->setFrame(QRectF(pointOf(r.x_mm, r.y_mm + r.side_mm), pointOf(r.x_mm + r.side_mm, r.y_mm)));
}

void ReferenceView::resizeEvent(QResizeEvent* event) {
  SurfaceView::resizeEvent(event);
  suggested_->place();
  pink_->setGeometry(rect());
  placePink();
}

void ReferenceView::showWindow() {
  if (!document_.isOpen()) {
    setPink({});
    placePink();
    return;
  }
  const Region& r = document_.project().region;
  setPink(RectMm{r.x_mm, r.y_mm, r.side_mm, r.side_mm});
  placePink();
  setWhereAmI(windowText());
}

QString ReferenceView::windowText() const {
  const Region& r = document_.project().region;
  return tr("Resolution %1 of %2, window %3 wide, lower left corner at x %4, y %5")
      .arg(document_.detail())
      .arg(document_.details())
      .arg(lengthText(r.side_mm), lengthText(r.x_mm), lengthText(r.y_mm));
}

QPointF ReferenceView::pointOf(double x_mm, double y_mm) const {
  // The camera is orthographic and never tilted here: positions and points are proportional.
  const QPointF probe(100, 100);
  const ViewMm a = at({0, 0}, 0);
  const ViewMm b = at(probe, 0);
  return {(x_mm - a.x) / (b.x - a.x) * probe.x(), (y_mm - a.y) / (b.y - a.y) * probe.y()};
}

double ReferenceView::toleranceMm() const {
  return kGripPixels * mmPerPixel();
}

void ReferenceView::mousePressEvent(QMouseEvent* event) {
  if (!document_.isOpen() || event->button() != Qt::LeftButton) return;
  if (key_draw_) document_.region().revert();
  key_draw_.reset();
  const ViewMm p = at(event->localPos(), 0);
  const Region& region = document_.project().region;
  PinkPart part = pinkPartAt(region, p.x, p.y, toleranceMm());
  // A window around the whole object cannot be moved: a drag in it draws.
  if (part == PinkPart::inside && region.side_mm >= document_.surface()->ladder.sideMm(1)) {
    part = PinkPart::outside;
  }
  drag_ = Drag{part, event->localPos(), p.x, p.y, region};
}

void ReferenceView::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) == 0) letGo();  // Somebody else got the release.
  if (drag_) {
    follow([this, point = event->localPos()] {
      if (drag_) dragTo(point);
    });
  } else {
    showCursor(event->localPos());
  }
}

void ReferenceView::mouseReleaseEvent(QMouseEvent* event) {
  if (!drag_ || event->button() != Qt::LeftButton) return;
  forgetNewest();
  dragTo(event->localPos());  // The last place counts, and may be the only one.
  document_.region().commit(nameOf(drag_->part));
  drag_.reset();
  showCursor(event->localPos());
}

void ReferenceView::letGo() {
  if (!drag_) return;
  forgetNewest();
  document_.region().commit(nameOf(drag_->part));
  drag_.reset();
}

void ReferenceView::dragTo(const QPointF& point) {
  const QPointF way = point - drag_->pressed;
  if (!drag_->moved && std::abs(way.x()) + std::abs(way.y()) < kClickPixels) return;
  drag_->moved = true;
  const ViewMm p = at(point, 0);
  const DetailLadder& ladder = document_.surface()->ladder;
  const double least = kLeastCells * ladder.spacings_mm.front();
  const Region& start = drag_->start;
  if (drag_->part == PinkPart::inside) {
    const double dx = (p.x - drag_->x_mm) / start.side_mm;
    const double dy = (p.y - drag_->y_mm) / start.side_mm;
    document_.region().preview(moved(ladder, start, dx, dy).value_or(start));
    return;
  }
  if (drag_->part == PinkPart::outside) {
    previewDrawn(drag_->x_mm, drag_->y_mm, p.x, p.y);
    return;
  }
  document_.region().preview(
      regionFromRect(ladder, resizedSquare(start, drag_->part, p.x, p.y, least)));
}

void ReferenceView::previewDrawn(double x_mm, double y_mm, double to_x_mm, double to_y_mm) {
  const DetailLadder& ladder = document_.surface()->ladder;
  const RectMm rect = drawnSquare(x_mm, y_mm, to_x_mm, to_y_mm);
  if (rect.width_mm < kLeastCells * ladder.spacings_mm.front()) return;
  document_.region().preview(regionFromRect(ladder, rect));
}

bool ReferenceView::drawByKey(int key, bool both_corners) {
  if (key == Qt::Key_Space && !key_draw_ && !drag_) {
    const Region& r = document_.project().region;
    key_draw_ = KeyDraw{r.centreX(), r.centreY(), r.centreX(), r.centreY()};
    setWhereAmI(tr("Drawing a window from x %1, y %2. Arrows carry the other corner, Enter ends, "
                   "Escape returns")
                    .arg(lengthText(r.centreX()), lengthText(r.centreY())));
    Q_EMIT said(whereAmI());
    return true;
  }
  if (!key_draw_) return false;
  if (key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter) {
    document_.region().commit(nameOf(PinkPart::outside));
    key_draw_.reset();
    Q_EMIT said(windowText());
    return true;
  }
  const DetailLadder& map = document_.surface()->ladder;
  const double step = kDrawStep * std::max(map.width_mm, map.height_mm);
  const double dx = key == Qt::Key_Right ? step : key == Qt::Key_Left ? -step : 0;
  const double dy = key == Qt::Key_Up ? step : key == Qt::Key_Down ? -step : 0;
  if (dx == 0 && dy == 0) return false;
  key_draw_->to_x_mm += dx;
  key_draw_->to_y_mm += dy;
  if (both_corners) {
    key_draw_->x_mm += dx;
    key_draw_->y_mm += dy;
  }
  previewDrawn(key_draw_->x_mm, key_draw_->y_mm, key_draw_->to_x_mm, key_draw_->to_y_mm);
  Q_EMIT said(windowText());
  return true;
}

void ReferenceView::showCursor(const QPointF& point) {
  if (!document_.isOpen()) {
    unsetCursor();
    return;
  }
  const ViewMm p = at(point, 0);
  const Region& region = document_.project().region;
  PinkPart part = pinkPartAt(region, p.x, p.y, toleranceMm());
  if (part == PinkPart::inside && region.side_mm >= document_.surface()->ladder.sideMm(1)) {
    part = PinkPart::outside;
  }
  setCursor(cursorFor(part));
}

void ReferenceView::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (!document_.isOpen() || document_.region().inGesture()) return;
  wheel_rest_ += event->angleDelta().y();
  const ViewMm p = at(event->position(), 0);
  for (; wheel_rest_ >= QWheelEvent::DefaultDeltasPerStep;
       wheel_rest_ -= QWheelEvent::DefaultDeltasPerStep)
    document_.region().finer({p.x, p.y, false});
  for (; wheel_rest_ <= -QWheelEvent::DefaultDeltasPerStep;
       wheel_rest_ += QWheelEvent::DefaultDeltasPerStep) {
    document_.region().coarser({p.x, p.y, false});
  }
}

void ReferenceView::resizeBy(double factor) {
  const DetailLadder& ladder = document_.surface()->ladder;
  const Region& r = document_.project().region;
  const double least = kLeastCells * ladder.spacings_mm.front();
  const double side =
      std::clamp(r.side_mm * factor, std::min(least, ladder.sideMm(1)), ladder.sideMm(1));
  document_.region().setRect({r.centreX() - 0.5 * side, r.centreY() - 0.5 * side, side, side});
}

void ReferenceView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    if (drag_ || key_draw_) {
      forgetNewest();
      document_.region().revert();
      drag_.reset();
      key_draw_.reset();
      Q_EMIT said(windowText());
    } else {
      Q_EMIT left();
    }
    return;
  }
  if (!document_.isOpen() || (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) != 0) {
    SurfaceView::keyPressEvent(event);
    return;
  }
  const bool resize = (event->modifiers() & Qt::ShiftModifier) != 0;
  if (drawByKey(event->key(), resize)) return;
  switch (event->key()) {
    case Qt::Key_Left:
      resize ? resizeBy(1 / kResizeStep) : void(document_.region().move(-kArrowStep, 0));
      break;
    case Qt::Key_Right:
      resize ? resizeBy(kResizeStep) : void(document_.region().move(kArrowStep, 0));
      break;
    case Qt::Key_Down:
      resize ? resizeBy(1 / kResizeStep) : void(document_.region().move(0, -kArrowStep));
      break;
    case Qt::Key_Up:
      resize ? resizeBy(kResizeStep) : void(document_.region().move(0, kArrowStep));
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      document_.region().finer(document_.region().aboutCentre());
      break;
    case Qt::Key_Minus:
      document_.region().coarser(document_.region().aboutCentre());
      break;
    default:
      SurfaceView::keyPressEvent(event);
      return;
  }
  Q_EMIT said(windowText());
}

}  // namespace relievo
