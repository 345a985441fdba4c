// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/surface_view.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderWindowInteractor.h>
#include <algorithm>
#include <cmath>
#include <QAccessible>
#include <QAccessibleWidget>
#include <QElapsedTimer>
#include <QLocale>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QResizeEvent>
#include <utility>

#include "core/relief/stereo.h"
#include "ui/style/palette.h"
#include "ui/views/copied_picture.h"
#include "ui/views/overlays/cell_legend.h"
#include "ui/views/overlays/colour_bar.h"
#include "ui/views/overlays/grid_painter.h"
#include "ui/views/view_pixels.h"
#include "ui/vtk/drawing/mixing_window.h"
#include "ui/vtk/scale_length.h"
#include "ui/vtk/shader_warmup.h"
#include "ui/work/scheduling/render_scheduler.h"

namespace relievo {
namespace {

constexpr int kPatienceMs = 100;

/// Set by SurfaceView::setCopied.
std::optional<bool> forced_copies;  // NOLINT(*-avoid-non-const-global-variables)

class AccessibleView : public QAccessibleWidget {
 public:
  explicit AccessibleView(SurfaceView* view) : QAccessibleWidget(view, QAccessible::Graphic) {}
  QString text(QAccessible::Text kind) const override {
    // Qt tells nobody the value of what is no number; the description is read with the focus.
    if (kind != QAccessible::Value && kind != QAccessible::Description) {
      return QAccessibleWidget::text(kind);
    }
    return static_cast<SurfaceView*>(widget())->whereAmI();
  }
};

/// By the processor, in one of Mesa's ways.
bool isDrawnBySoftware(QOpenGLContext& context) {
  const QByteArray renderer(
      reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER)));
  return renderer.contains("llvmpipe") || renderer.contains("softpipe") ||
         renderer.contains("SWR") || renderer.contains("Software");
}

QAccessibleInterface* accessibleView(const QString&, QObject* object) {
  auto* view = qobject_cast<SurfaceView*>(object);
  return view != nullptr ? new AccessibleView(view) : nullptr;
}

}  // namespace

void installAccessibleViews() {
  QAccessible::installFactory(accessibleView);
}

void SceneState::applyTo(ReliefScene& scene) const {
  if (grid) {
    scene.setSurface(grid->drawn());
  } else {
    scene.clearSurface();
  }
  scene.setBackground(background.redF(), background.greenF(), background.blueF());
  scene.setLight(light);
  scene.setInterpolated(interpolatedMark(look));
  scene.setStereo(stereo);
  scene.setCamera(camera);
  scene.setPinkWindow(pink, true);
  scene.setProbe(probe, ball_radius_mm);
  scene.setLines(lines, curves);
  scene.setScaleBar(grid != nullptr);
}

/// The OpenGL part; sees no mouse and no keys. Hidden until it is warm: its parent's colour is in
/// its place. Where OpenGL is software it stays hidden, and a copy of each picture is shown.
class SurfaceView::Canvas : public QVTKOpenGLNativeWidget {
 public:
  Canvas(SurfaceView* view, ReliefScene& scene, RenderScheduler& turns)
      : QVTKOpenGLNativeWidget(view),
        scene_(scene),
        scheduler_(turns),
        picture_(new CopiedPicture(view)) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setAcceptDrops(false);
    setEnableHiDPI(true);
    setDefaultCursor(Qt::ArrowCursor);
    setUpdateBehavior(PartialUpdate);  // See paintGL.
    setRenderWindow(window_);
    if (interactor() != nullptr) interactor()->SetInteractorStyle(nullptr);
    picture_->follow([this] { drawAnew(); },
                     [this] {
                       if (seen_pixels_ != size() * devicePixelRatioF()) renderNow();
                     });
  }

  void place(const QRect& geometry) {
    setGeometry(geometry);
    picture_->setGeometry(geometry);
  }
  bool isShown() const { return copies_ ? !picture_->isHidden() : !isHidden(); }
  void warmUp() {
    if (stage_ != Stage::cold) return;
    stage_ = Stage::warming;
    scheduler_.schedule(this, [this] { warmUpStep(); });
  }
  void appearWhenWarm() {
    wanted_ = true;
    if (stage_ == Stage::warm) {
      reveal();
    } else {
      warmUp();
    }
  }
  void appearNow() {
    wanted_ = true;
    if (stage_ != Stage::warm) attachScene();
    if (!isValid()) grabFramebuffer();  // Makes the context: who draws is asked there.
    chooseWay();
    drawn_ = unseen_ = true;
    reveal();
  }

  /// With all pixels, whatever is being dragged. What is grabbed is drawn, too.
  QImage wholeShot() {
    whole_ = true;
    if (seen_coarse_) stale_ = true;
    if (copies_) {
      if (stale_ || seen_pixels_ != size() * devicePixelRatioF()) renderNow();
    } else {
      renderIfStale();
    }
    QImage shot = copies_ ? picture_->image() : grabFramebuffer();
    shot.setDevicePixelRatio(devicePixelRatioF());
    whole_ = false;
    return shot;
  }
  void renderWholeAgain() {
    if (seen_coarse_) requestRender();
  }
  /// Many changes between two frames are one picture.
  void requestRender() {
    if (stale_) return;
    stale_ = true;
    scheduler_.schedule(this, [this] { renderIfStale(); });
  }
  void renderIfStale() {
    if (!stale_ || !(copies_ ? picture_->isVisible() : isVisible())) return;
    renderNow();
    scheduler_.schedule(this, [this] {
      if (copies_) {
        picture_->update();
      } else {
        update();
      }
    });
  }

 protected:
  void showEvent(QShowEvent* event) override {
    QVTKOpenGLNativeWidget::showEvent(event);
    drawAnew();
  }
  // A layout may give several sizes one after the other. Qt would draw each at once; the last one
  // is drawn with the window.
  void resizeEvent(QResizeEvent* event) override {
    setUpdatesEnabled(false);
    unseen_ = true;
    QVTKOpenGLNativeWidget::resizeEvent(event);
    setUpdatesEnabled(true);
  }
  void paintGL() override {
    if (!drawn_) {  // Qt compiles, too, to compose a window with OpenGL in it: in another turn.
      context()->functions()->glClear(GL_COLOR_BUFFER_BIT);
      return;
    }
    // What lies over the picture, the pink frame or a bar of colours, is painted together with what
    // is below it. VTK would draw the relief for that; it is still there.
    const QSize pixels = size() * devicePixelRatioF();
    const bool same_place = pixels == seen_pixels_ && defaultFramebufferObject() == seen_in_;
    if (!std::exchange(unseen_, false) && same_place) return;
    seen_pixels_ = pixels;
    seen_in_ = defaultFramebufferObject();
    prepare();
    if (same_place) {
      handOver(pixels);
    } else {
      QVTKOpenGLNativeWidget::paintGL();  // After a change of size VTK draws in here.
    }
  }

 private:
  enum class Stage { cold, warming, warm };

  void drawAnew() {
    stale_ = false;
    requestRender();
  }
  void renderNow() {
    stale_ = false;
    drawn_ = unseen_ = true;
    prepare();
    // VTK would have the window composed before the next round, in which keys and mouse are heard.
    setAttribute(Qt::WA_UpdatesDisabled);
    renderWindow()->Render();
    setAttribute(Qt::WA_UpdatesDisabled, false);
    if (!copies_) return;
    const int* const drawn = window_->GetSize();
    QImage& image = picture_->pixels({drawn[0], drawn[1]});
    window_->copyRows({image.bits(), static_cast<std::size_t>(image.sizeInBytes())});
    seen_pixels_ = size() * devicePixelRatioF();
  }
  /// Once there is a context.
  void chooseWay() {
    if (!isValid()) return;
    makeCurrent();
    copies_ = forced_copies.value_or(isDrawnBySoftware(*context()));
  }
  void reveal() {
    if (copies_) {
      picture_->show();
    } else {
      show();
    }
  }
  void warmUpStep() {
    if (stage_ != Stage::warming) return;
    if (!first_draws_) {
      grabFramebuffer();  // Makes the context of a hidden widget.
      if (!isValid()) {   // The window was not on screen yet.
        stage_ = Stage::cold;
        return;
      }
      chooseWay();
      first_draws_ = std::make_unique<ShaderWarmup>(window_);
    } else if (first_draws_->step()) {
      // One more thing is drawn.
    } else if (!copies_ && !copied_) {
      copied_ = drawn_ = unseen_ = true;
      grabFramebuffer();  // From VTK's frame buffer into Qt's, which is a shader, too.
      drawn_ = false;
    } else {
      attachScene();
      if (wanted_) reveal();
      return;
    }
    scheduler_.schedule(this, [this] { warmUpStep(); });
  }
  /// As VTK's widget copies a picture into Qt's frame buffer, but pixel by pixel where both have as
  /// many: VTK interpolates then, too, and makes opaque afterwards what is so already; in software
  /// both cost as much as drawing all of what a hand is shown by.
  void handOver(const QSize& pixels) {
    vtkOpenGLState* const state = window_->GetState();
    state->Reset();
    state->Push();
    state->vtkglDisable(GL_SCISSOR_TEST);
    context()->functions()->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    const int* const drawn = window_->GetRenderFramebuffer()->GetLastSize();
    const bool as_many = drawn[0] == pixels.width() && drawn[1] == pixels.height();
    window_->BlitDisplayFramebuffer(0, 0, 0, drawn[0], drawn[1], 0, 0, pixels.width(),
                                    pixels.height(), GL_COLOR_BUFFER_BIT,
                                    as_many ? GL_NEAREST : GL_LINEAR);
    state->Pop();
  }
  void attachScene() {
    first_draws_.reset();
    window_->follow(&scene_);
    scene_.attachTo(window_);
    scene_.keepSurface(true);
    stage_ = Stage::warm;
  }
  void prepare() {
    seen_coarse_ = !whole_ && scheduler_.coarse().on();
    const double ratio = devicePixelRatioF() * (seen_coarse_ ? CoarsePictures::kPart : 1);
    const QSize pixels = size() * ratio;
    // Lines and the scale bar grow with the screen's density and, like text, with its size and the
    // dots that the desktop asks for.
    const int width = std::max(1, pixels.width()), height = std::max(1, pixels.height());
    scene_.setCoarse(seen_coarse_);
    scene_.setMarkScale(fittingMarkScale(
        ratio * std::max(1.0, logicalDpiX() / kPlainDpi) * textScale(), width, height));
    // Qt tells a size when it changes. What warmed up was a speck, and a widget that had its size
    // by then is not told it again. Of a coarse picture it knows nothing: VTK spreads that over the
    // widget.
    if (window_->GetSize()[0] != width || window_->GetSize()[1] != height) {
      window_->SetSize(width, height);
    }
    const double top = mapToGlobal(QPoint(0, 0)).y() * devicePixelRatioF();
    window_->setFirstRow(static_cast<int>(std::lround(top)) & 1);
    scene_.prepare(width, height);
  }

  ReliefScene& scene_;
  RenderScheduler& scheduler_;
  Stage stage_ = Stage::cold;
  bool wanted_ = false, copied_ = false, drawn_ = false, stale_ = false;
  bool whole_ = false, seen_coarse_ = false;  ///< Asked for; of the newest picture.
  bool unseen_ = false;  ///< There is a picture that is not in Qt's frame buffer yet.
  QSize seen_pixels_;    ///< Of the one that is, and which it is in.
  GLuint seen_in_ = 0;
  vtkNew<MixingWindow> window_;
  std::unique_ptr<ShaderWarmup> first_draws_;
  CopiedPicture* picture_;  ///< Child of the view, over this; owned by Qt.
  bool copies_ = false;     ///< The picture is shown, and this is not.
};

SurfaceView::SurfaceView(RenderScheduler& turns, QWidget* parent)
    : QWidget(parent), scheduler_(turns), scene_(std::make_unique<ReliefScene>()) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(120, 120);
  canvas_ = new Canvas(this, *scene_, turns);
  canvas_->hide();
  bar_ = new ColourBar(this);
  legend_ = new CellLegend(this);
  labels_ = new ViewLabels(this, [this](const ViewMm& place) { return pointOver(place); });
  painter_ = new GridPainter(this);
  connect(&turns.coarse(), &CoarsePictures::over, this, [this] { canvas_->renderWholeAgain(); });
  patience_.setSingleShot(true);
  connect(painter_, &GridPainter::painted, this, &SurfaceView::showPainted);
  connect(&patience_, &QTimer::timeout, this, &SurfaceView::showPlain);
  scene_->setDecimalMark(QLocale().decimalPoint().toLatin1());
  state_.applyTo(*scene_);
}

// The canvas draws the scene: it goes first.
SurfaceView::~SurfaceView() {
  delete canvas_;
}

void SurfaceView::setCopied(std::optional<bool> copied) {
  forced_copies = copied;
}

void SurfaceView::warmUp() {
  if (window()->windowHandle() != nullptr) canvas_->warmUp();
}

void SurfaceView::appear() {
  canvas_->appearNow();
}

void SurfaceView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  window()->installEventFilter(this);  // Once, however often.
  if (!canvas_->isShown()) canvas_->appearWhenWarm();
}

void SurfaceView::requestRender() {
  canvas_->requestRender();
}

void SurfaceView::setStereo(const StereoOptions& stereo) {
  if (stereo == state_.stereo) return;
  state_.stereo = stereo;
  scene_->setStereo(stereo);
  bar_->setPrint(printed(stereo.mode));
  showLegend();
  requestRender();
}

void SurfaceView::setLight(const LightOptions& light) {
  if (light == state_.light) return;
  state_.light = light;
  scene_->setLight(light);
  state_.look.light = light;
  if (state_.look.kind == ReliefKind::hillshade ||
      state_.look.kind == ReliefKind::multi_hillshade || showsOwnColours(state_.look.kind)) {
    paintGrid();
  }
  requestRender();
}

void SurfaceView::setLook(const ReliefLook& look) {
  ReliefLook wanted = look;
  wanted.light = state_.look.light;
  if (wanted == state_.look) return;
  state_.look = wanted;
  scene_->setInterpolated(interpolatedMark(look));
  paintGrid();
}

void SurfaceView::setRange(const std::optional<std::array<double, 2>>& range) {
  if (range == range_) return;
  range_ = range;
  if (hasLegend(state_.look.kind)) paintGrid();
}

ReliefLook SurfaceView::paintedLook() const {
  ReliefLook look = state_.look;
  if (!look.range) look.range = range_;
  return look;
}

void SurfaceView::setLines(const std::vector<std::vector<ViewMm>>& lines,
                           const std::vector<std::vector<ViewMm>>& curves) {
  if (lines == state_.lines && curves == state_.curves) return;
  state_.lines = lines;
  state_.curves = curves;
  scene_->setLines(lines, curves);
  requestRender();
}

void SurfaceView::paintGrid() {
  painter_->cancel();
  if (!plain_ || !GridPainter::canPaint(*plain_, state_.look.kind)) {
    showPlain();
  } else if (!GridPainter::isSlow(state_.look.kind)) {
    showPainted(GridPainter::paintNow(*plain_, paintedLook()));
  } else {
    painter_->start(plain_, paintedLook());
    if (!state_.grid || state_.grid->colours.empty()) {
      showPlain();
    } else if (!patience_.isActive()) {
      patience_.start(kPatienceMs);
    }
  }
}

void SurfaceView::showPlain() {
  patience_.stop();
  bar_->leave();
  shown_range_.reset();
  showGrid(plain_);
}

void SurfaceView::showPainted(const PaintedGrid& painted) {
  patience_.stop();
  bar_->show(painted.values, state_.look);
  shown_range_.reset();
  if (hasLegend(state_.look.kind)) shown_range_ = {{painted.values.low, painted.values.high}};
  showGrid(painted.grid);
  Q_EMIT this->painted();
}

void SurfaceView::showGrid(std::shared_ptr<const HeldGrid> grid) {
  state_.grid = std::move(grid);
  if (state_.grid) {
    scene_->setSurface(state_.grid->drawn());
  } else {
    scene_->clearSurface();
  }
  scene_->setScaleBar(state_.grid != nullptr);
  showLegend();
  requestRender();
}

void SurfaceView::showLegend() {
  const bool halves = showsHalves(printed(state_.stereo.mode));
  labels_->setOff(halves);
  const bool cells = state_.look.unmeasured && state_.grid && !halves;
  const bool hand = state_.probe && state_.stereo.mode == StereoMode::anaglyph;
  legend_->show(cells ? &state_.grid->origins : nullptr, hand, printed(state_.stereo.mode));
}

SceneState SurfaceView::plainState() const {
  SceneState plain = state_;
  plain.grid = plain_;
  return plain;
}

void SurfaceView::setBackground(const QColor& colour) {
  state_.background = colour;
  scene_->setBackground(colour.redF(), colour.greenF(), colour.blueF());
  requestRender();
}

// Without an event: it would be spoken at every movement of the hand.
void SurfaceView::setWhereAmI(const QString& text) {
  where_am_i_ = text;
}

void SurfaceView::setGrid(std::shared_ptr<const HeldGrid> grid) {
  plain_ = std::move(grid);
  paintGrid();
}

void SurfaceView::setCamera(const ReliefCamera& camera) {
  state_.camera = camera;
  scene_->setCamera(camera);
  labels_->update();
  requestRender();
}

void SurfaceView::setPink(const std::optional<RectMm>& pink) {
  state_.pink = pink;
}

void SurfaceView::follow(std::function<void()> work) {
  if (following_) {
    newest_ = std::move(work);
    return;
  }
  QElapsedTimer since_asked;
  since_asked.start();
  work();
  following_ = true;
  scheduler_.schedule(this, [this, since_asked] {
    following_ = false;
    scheduler_.coarse().stepDrawn(since_asked.elapsed(), newest_ != nullptr);
    if (newest_) follow(std::exchange(newest_, nullptr));
  });
}

void SurfaceView::setProbeDrawn(const std::optional<Probe>& probe, double ball_radius_mm) {
  const bool comes_or_goes = state_.probe.has_value() != probe.has_value();
  state_.probe = probe;
  state_.ball_radius_mm = ball_radius_mm;
  scene_->setProbe(probe, ball_radius_mm);
  if (comes_or_goes) showLegend();
  requestRender();
}

namespace {

/// Where a point of either eye's half lies in the whole picture.
QPointF unpaired(const QPointF& p, const QSize& pixels, StereoPrint print) {
  const double half_w = pixels.width() / 2, half_h = pixels.height() / 2;  // Whole pixels.
  if (print == StereoPrint::side_by_side && half_w > 0) {
    const bool second = p.x() >= half_w;
    const double part = second ? pixels.width() - half_w : half_w;
    return {(p.x() - (second ? half_w : 0)) * pixels.width() / part, p.y()};
  }
  if (print == StereoPrint::over_under && half_h > 0) {
    const bool second = p.y() >= half_h;
    const double part = second ? pixels.height() - half_h : half_h;
    return {p.x(), (p.y() - (second ? half_h : 0)) * pixels.height() / part};
  }
  return p;
}

}  // namespace

ViewMm SurfaceView::at(const QPointF& point, double z_mm) const {
  const double ratio = canvas_->devicePixelRatioF();
  const QSize pixels = canvas_->size() * ratio;
  const QPointF p =
      unpaired((point - QPointF(canvas_->pos())) * ratio, pixels, printed(state_.stereo.mode));
  return scene_->viewFromPixel(p.x(), p.y(), std::max(1, pixels.width()),
                               std::max(1, pixels.height()), z_mm);
}

CoarsePictures& SurfaceView::coarsePictures() {
  return scheduler_.coarse();
}

// Sight lines are parallel: on a plane of one height places and points are the same but for scale,
// turn and slant, which three points tell.
QPointF SurfaceView::pointOver(const ViewMm& place) const {
  constexpr double kStep = 100;
  const ViewMm origin = at({0, 0}, place.z);
  const ViewMm right = at({kStep, 0}, place.z) - origin;
  const ViewMm down = at({0, kStep}, place.z) - origin;
  const double area = right.x * down.y - right.y * down.x;
  if (area == 0) return {};
  const ViewMm way = place - origin;
  return kStep / area * QPointF(way.x * down.y - way.y * down.x, right.x * way.y - right.y * way.x);
}

double SurfaceView::mmPerPixel() const {
  const double shorter_x = state_.camera.rect.width_mm / std::max(1, canvas_->width());
  const double shorter_y = state_.camera.rect.height_mm / std::max(1, canvas_->height());
  return std::max({shorter_x, shorter_y, 1e-12});
}

QImage SurfaceView::shot() {
  appear();
  return canvas_->wholeShot();
}

QSize SurfaceView::shotSize() const {
  return canvas_->size() * canvas_->devicePixelRatioF();
}

void SurfaceView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), hasFocus() ? palette().color(QPalette::Highlight) : state_.background);
}

void SurfaceView::resizeEvent(QResizeEvent* /*event*/) {
  canvas_->place(rect().adjusted(kFocusFramePx, kFocusFramePx, -kFocusFramePx, -kFocusFramePx));
  bar_->place();
  legend_->place();
  labels_->place();
  Q_EMIT sized();
}

void SurfaceView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::StyleChange) requestRender();  // The size of text, too.
}

void SurfaceView::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void SurfaceView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  letGo();
  update();
}

// Only windows are told that a dialog blocks them, or that another program has the mouse.
bool SurfaceView::eventFilter(QObject* watched, QEvent* event) {
  const bool is_away =
      event->type() == QEvent::WindowBlocked || event->type() == QEvent::WindowDeactivate;
  if (is_away && watched == window()) letGo();
  return QWidget::eventFilter(watched, event);
}

}  // namespace relievo
