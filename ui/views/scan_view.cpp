// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/scan_view.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <utility>

#include "core/session/source/missing_height.h"
#include "core/session/strays.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/views/cloud_view.h"
#include "ui/work/document.h"
#include "ui/work/pictures/scan_points.h"
#include "ui/work/surface_work.h"

namespace relievo {
namespace {

constexpr int kRestMs = 400;
constexpr double kStraightDeg = 0.05;  // Nearer than this nobody turned it.
// A first look at a slant, so that what has depth shows it, and the arrow is seen from the side.
constexpr double kFirstTurnDeg = 35, kFirstTiltDeg = -25;
// Of the map's longer side.
constexpr double kArrowLength = 0.35, kArrowGap = 0.06;
constexpr std::array<double, 3> kWindowColour{1.0, 0.31, 0.64};  // As in the overview.

/// Buttons side by side, or one below the other where they would be wider than the view.
class ButtonRow : public QWidget {
 public:
  explicit ButtonRow(std::initializer_list<QPushButton*> buttons)
      : row_(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
    row_->setContentsMargins(6, 2, 6, 6);
    for (QPushButton* button : buttons) row_->addWidget(button);
  }
  QSize minimumSizeHint() const override {
    int widest = 0;
    for (int i = 0; i < row_->count(); ++i) {
      widest = std::max(widest, row_->itemAt(i)->sizeHint().width());
    }
    const QMargins around = row_->contentsMargins();
    return {widest + around.left() + around.right(), row_->minimumSize().height()};
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QWidget::resizeEvent(event);
    const QMargins around = row_->contentsMargins();
    int needed = around.left() + around.right() + row_->spacing() * (row_->count() - 1);
    for (int i = 0; i < row_->count(); ++i) needed += row_->itemAt(i)->sizeHint().width();
    row_->setDirection(needed > width() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  }

 private:
  QBoxLayout* row_;
};

/// What the relief's view makes of the file's axes.
struct ReliefAxes {
  Rotation rotation{};
  double mm_per_unit = 1;
  std::array<double, 3> shift_mm{};
};

ReliefAxes axesOf(const Surface& surface) {
  const auto& m = surface.view_from_file.m;
  ReliefAxes axes;
  axes.mm_per_unit = std::hypot(m[0], m[4], m[8]);
  for (std::size_t i = 0; i < 3; ++i) {
    axes.shift_mm[i] = m[4 * i + 3];
    for (std::size_t j = 0; j < 3; ++j) axes.rotation[3 * i + j] = m[4 * i + j] / axes.mm_per_unit;
  }
  return axes;
}

/// Along the rotation's rows, file units: where a box of any direction has its corners.
FilePoint alongAxes(const ReliefAxes& axes, const ViewMm& p) {
  return {(p.x - axes.shift_mm[0]) / axes.mm_per_unit, (p.y - axes.shift_mm[1]) / axes.mm_per_unit,
          (p.z - axes.shift_mm[2]) / axes.mm_per_unit};
}

FilePoint inFile(const ReliefAxes& axes, const ViewMm& p) {
  const FilePoint q = alongAxes(axes, p);
  const Rotation& r = axes.rotation;
  return {r[0] * q.x + r[3] * q.y + r[6] * q.z, r[1] * q.x + r[4] * q.y + r[7] * q.z,
          r[2] * q.x + r[5] * q.y + r[8] * q.z};
}

/// The window on the map, as high as the map is.
CloudBox windowBox(const Surface& surface, const HeightRange& heights, const Region& region) {
  const ReliefAxes axes = axesOf(surface);
  return {.min = alongAxes(axes, {region.x_mm, region.y_mm, heights.min_mm}),
          .max = alongAxes(
              axes, {region.x_mm + region.side_mm, region.y_mm + region.side_mm, heights.max_mm}),
          .axes = axes.rotation,
          .colour = kWindowColour};
}

/// Down onto the middle of the map, along which every height is seen.
CloudArrow projection(const Surface& surface, const HeightRange& heights) {
  const ReliefAxes axes = axesOf(surface);
  const DetailLadder& map = surface.ladder;
  const double longer = std::max(map.width_mm, map.height_mm);
  const double tip = heights.max_mm + kArrowGap * longer;
  const double x = 0.5 * map.width_mm, y = 0.5 * map.height_mm;
  return {.from = inFile(axes, {x, y, tip + kArrowLength * longer}),
          .to = inFile(axes, {x, y, tip})};
}

/// The angle of the one turn that makes one of the other, degrees.
double angleBetween(const Rotation& a, const Rotation& b) {
  double trace = 0;
  for (std::size_t i = 0; i < a.size(); ++i) trace += a[i] * b[i];
  return std::acos(std::clamp(0.5 * (trace - 1), -1.0, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace

ScanView::ScanView(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      text_(new QLabel),
      make_(new QPushButton(tr("Make relief from here"))),
      straighten_(new QPushButton(tr("As the relief"))) {
  setObjectName(QStringLiteral("scan_view"));
  text_->setObjectName(QStringLiteral("scan_text"));
  text_->setWordWrap(true);
  text_->setContentsMargins(10, 2, 10, 2);
  make_->setObjectName(QStringLiteral("scan_make_relief"));
  make_->setToolTip(tr("Make the relief anew as the scan is looked at now (Enter)"));
  straighten_->setObjectName(QStringLiteral("scan_as_relief"));
  for (QPushButton* button : {make_, straighten_}) button->setAccessibleName(button->text());
  straighten_->setToolTip(tr("Look at the scan from where the relief is seen"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(text_);
  column->addWidget(new ButtonRow({make_, straighten_}));
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, [this] {
    if (cloud_->hasFocus()) Q_EMIT said(turnedText());
  });
  connect(make_, &QPushButton::clicked, this, &ScanView::reliefAsked);
  connect(straighten_, &QPushButton::clicked, this, &ScanView::lookAsRelief);
  connect(&document_, &Document::surfaceChanged, this, &ScanView::refresh);
  connect(&document_, &Document::windowChanged, this, &ScanView::showRelief);
}

ScanView::~ScanView() {
  worker_.disconnect();
}

/// Late: a window that never shows the scan needs no second picture of OpenGL.
void ScanView::makeCloud() {
  cloud_ = new CloudView(tr("Scan in 3-D"));
  cloud_->setObjectName(QStringLiteral("scan_cloud"));
  cloud_->setWhatsThis(
      tr("The scan behind the relief. Drag with the left button or use the arrows to turn it, the "
         "right button moves it, the wheel or + and - bring it nearer, Home shows all of it. Enter "
         "makes the relief from here. The box is the window, the arrow shows along which direction "
         "the relief is seen."));
  cloud_->setTool(CloudView::Tool::turn);
  static_cast<QVBoxLayout*>(layout())->insertWidget(0, cloud_, 1);
  setFocusProxy(cloud_);
  connect(cloud_, &CloudView::cameraChanged, this, [this] {
    showTurned();
    rest_.start();
    Q_EMIT turnedChanged();
  });
}

void ScanView::showEvent(QShowEvent* event) {
  if (cloud_ == nullptr) makeCloud();
  QWidget::showEvent(event);
  refresh();
}

std::optional<ScanView::Drawn> ScanView::wanted() const {
  if (!document_.isOpen() || !document_.source().scan) return std::nullopt;
  const SurfaceOptions& options = document_.project().options;
  return Drawn{document_.source().scan, options.strays,
               missingHeight(options.nodata, document_.surface()->suspect_height)};
}

bool ScanView::isReady() const {
  return drawn_.has_value() && drawn_ == wanted();
}

void ScanView::refresh() {
  if (!isVisible()) return;
  const std::optional<Drawn> now = wanted();
  if (now && now != drawn_ && now != in_work_) {
    if (!drawn_ || drawn_->scan != now->scan) looked_ = false;
    in_work_ = now;
    text_->setText(tr("The scan is being prepared for the view\u2026"));
    const auto cloud = std::make_shared<CloudPoints>();
    const auto outcome = std::make_shared<SurfaceOutcome>();
    const auto all = std::make_shared<std::size_t>(0);
    worker_.start(
        [of = *now, seen = axesOf(*document_.surface()).rotation, cloud, outcome,
         all](const Task& task) {
          *outcome = outcomeOf([&] {
            ScanInUse in_use(*of.scan, of.strays, of.missing_height, task);
            in_use.dropAlong(seen, task);
            *all = in_use.scan().points.size();
            *cloud = drawnScan(in_use.scan(), kMostShownPoints, task);
            return std::shared_ptr<const Surface>();
          });
        },
        [this, of = *now, cloud, outcome, all] {
          in_work_.reset();
          if (!outcome->error.isEmpty()) {
            text_->setText(outcome->error);
            return;
          }
          drawn_ = of;
          count_text_ = cloud->triangles.empty()
                            ? tr("Points: %1 of %2").arg(cloud->points.size()).arg(*all)
                            : tr("Triangles: %1").arg(cloud->triangles.size());
          cloud_->setCloud(cloud);
          showRelief();
          if (!std::exchange(looked_, true)) {
            cloud_->look(
                turned(axesOf(*document_.surface()).rotation, {-kFirstTiltDeg, kFirstTurnDeg, 0}));
          }
          showTurned();
          Q_EMIT turnedChanged();
        });
  }
  showRelief();
}

void ScanView::showRelief() {
  if (!isReady() || !isVisible()) return;
  const std::shared_ptr<const Surface> surface = document_.surface();
  if (std::exchange(heights_of_, surface) != surface) heights_ = mapFacts(*surface).heights;
  cloud_->setBox(windowBox(*surface, heights_, document_.project().region));
  cloud_->setArrow(projection(*surface, heights_));
  showTurned();
  Q_EMIT turnedChanged();
}

Rotation ScanView::rotation() const {
  return cloud_ != nullptr ? cloud_->camera().view : *standardRotation("front");
}

double ScanView::turnedDeg() const {
  if (!isReady()) return 0;
  const double angle = angleBetween(rotation(), axesOf(*document_.surface()).rotation);
  return angle < kStraightDeg ? 0 : angle;
}

QString ScanView::turnedText() const {
  const double angle = turnedDeg();
  return angle == 0 ? tr("Seen as the relief is")
                    : tr("Turned by %1\u00b0 from where the relief is seen")
                          .arg(numberText(angle, angle < 10 ? 1 : 0));
}

void ScanView::showTurned() {
  const bool is_turned = turnedDeg() > 0;
  make_->setEnabled(is_turned);
  straighten_->setEnabled(is_turned);
  if (!isReady()) return;
  const QString text = QStringLiteral("%1. %2").arg(count_text_, turnedText());
  text_->setText(text);
  cloud_->setAccessibleDescription(text);
}

void ScanView::lookAsRelief() {
  if (!isReady()) return;
  cloud_->look(axesOf(*document_.surface()).rotation);
  cloud_->setFocus();
}

void ScanView::takeColours() {
  if (cloud_ != nullptr) cloud_->takeColours();
}

void ScanView::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && event->modifiers() == Qt::NoModifier && make_->isEnabled()) {
    Q_EMIT reliefAsked();
  } else if (event->key() == Qt::Key_Escape) {
    Q_EMIT left();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace relievo
