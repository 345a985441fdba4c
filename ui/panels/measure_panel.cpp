// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/measure_panel.h"

#include <QAbstractButton>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTableWidget>
#include <QVBoxLayout>
#include <utility>

#include "core/base/error.h"
#include "core/measure/measure_text.h"
#include "ui/language/core_text.h"
#include "ui/language/error_text.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

QString word(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

QString kindText(MeasureKind kind) {
  switch (kind) {
    case MeasureKind::point:
      return MeasurePanel::tr("Point");
    case MeasureKind::distance:
      return MeasurePanel::tr("Distance");
    case MeasureKind::depth:
      return MeasurePanel::tr("Depth difference");
    case MeasureKind::angle:
      return MeasurePanel::tr("Angle");
    case MeasureKind::profile:
      return MeasurePanel::tr("Profile");
    case MeasureKind::area:
      return MeasurePanel::tr("Area and volume");
    case MeasureKind::section:
      return MeasurePanel::tr("Section");
  }
  return {};
}

QString quantityText(const Quantity& q) {
  const int decimals = decimalsFor(q.uncertainty);
  return MeasurePanel::tr("%1 %2 \u00b1 %3 %4")
      .arg(coreText(q.title), numberText(q.value, decimals), numberText(q.uncertainty, decimals),
           word(q.unit));
}

/// Where the plane of an area or a section lies.
QString planeWords(const Measurement& m) {
  const bool level = m.normal.x == 0 && m.normal.y == 0 && m.normal.z > 0;
  if (m.kind == MeasureKind::area || level) {
    return MeasurePanel::tr("Plane level at %1 mm").arg(numberText(m.plane_mm, 3));
  }
  return m.normal.z == 0 ? MeasurePanel::tr("Plane upright, %1 mm from the corner")
                               .arg(numberText(m.plane_mm, 3))
                         : MeasurePanel::tr("Plane oblique, %1 mm from the corner")
                               .arg(numberText(m.plane_mm, 3));
}

constexpr std::size_t kMostDrawnPoints = 20'000;

/// For a view, which draws all points in each picture: of very long ones only points far enough
/// apart, ends included.
std::vector<std::vector<ViewMm>> drawnCurves(const std::vector<SectionCurve>& curves) {
  std::size_t points = 0;
  double length_mm = 0;
  for (const SectionCurve& curve : curves) {
    points += curve.points.size();
    length_mm += curve.length_mm;
  }
  const double apart_mm =
      points > kMostDrawnPoints ? length_mm / static_cast<double>(kMostDrawnPoints) : 0;
  std::vector<std::vector<ViewMm>> drawn;
  for (const SectionCurve& curve : curves) {
    std::vector<ViewMm> line{curve.points.front()};
    for (const ViewMm& p : curve.points) {
      if (norm(p - line.back()) > apart_mm) line.push_back(p);
    }
    line.push_back(curve.closed ? curve.points.front() : curve.points.back());
    drawn.push_back(std::move(line));
  }
  return drawn;
}

}  // namespace

MeasurePanel::MeasurePanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      readings_(new MeasureReadings(document, this)),
      hint_(new QLabel),
      list_(new QTableWidget(0, 2)),
      remove_(new QPushButton(tr("Delete"))),
      save_(new QPushButton(tr("Save list\u2026"))),
      plane_row_(new QWidget),
      plane_label_(new QLabel),
      plane_(new QDoubleSpinBox) {
  setObjectName(QStringLiteral("measure_panel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 0, 0, 2);
  column->setSpacing(3);
  hint_->setObjectName(QStringLiteral("measure_hint"));
  hint_->setAccessibleName(tr("What to do next"));
  hint_->setWordWrap(true);
  column->addWidget(hint_);
  list_->setObjectName(QStringLiteral("measure_list"));
  list_->setAccessibleName(tr("Measurements"));
  list_->setToolTip(tr("Names can be changed by a double click or F2"));
  list_->setHorizontalHeaderLabels({tr("Name"), tr("Reads")});
  list_->verticalHeader()->hide();
  list_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  list_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  list_->setSelectionBehavior(QAbstractItemView::SelectRows);
  list_->setSelectionMode(QAbstractItemView::SingleSelection);
  list_->setTabKeyNavigation(false);
  // Qt's own button in the corner has no name of its own.
  for (auto* corner : list_->findChildren<QAbstractButton*>()) {
    corner->setAccessibleName(tr("Select all"));
  }
  list_->setWordWrap(true);
  list_->setMinimumHeight(120);
  column->addWidget(list_);
  makePlaneRow();
  column->addWidget(plane_row_);
  auto* row = new QHBoxLayout;
  for (const auto& [button, name, tip] :
       {std::tuple{remove_, "measure_delete", tr("Delete the selected measurement")},
        std::tuple{save_, "measure_save",
                   tr("Save the list as CSV, or the selected profile or section as CSV or SVG")}}) {
    button->setObjectName(QString::fromLatin1(name));
    button->setAccessibleName(button->text().remove(u'\u2026'));
    button->setToolTip(tip);
    row->addWidget(button);
  }
  column->addLayout(row);
  connect(remove_, &QPushButton::clicked, this, &MeasurePanel::removeSelected);
  connect(save_, &QPushButton::clicked, this, &MeasurePanel::saveAsked);
  connect(list_, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
    if (!showing_ && item->column() == 0) rename(item->row(), item->text());
  });
  connect(list_, &QTableWidget::currentCellChanged, this, [this] {
    if (showing_) return;
    showPlane();
    Q_EMIT changed();  // Another profile is the selected one.
  });
  connect(&document_, &Document::surfaceChanged, this, &MeasurePanel::showList);
  connect(&document_, &Document::measurementsChanged, this, &MeasurePanel::showOthers);
  connect(readings_, &MeasureReadings::changed, this, &MeasurePanel::showReadings);
  // Lines and labels lie on the surface as it is shown.
  connect(&document_, &Document::windowChanged, this, [this] {
    const double gain = document_.project().gain;
    if (std::exchange(shown_gain_, gain) != gain && !measurements().empty()) Q_EMIT changed();
  });
  tellNext();
  showList();
}

void MeasurePanel::makePlaneRow() {
  auto* form = new QFormLayout(plane_row_);
  form->setContentsMargins(0, 0, 0, 0);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  plane_->setObjectName(QStringLiteral("measure_plane"));
  plane_->setAccessibleName(tr("Height from which the volume counts"));
  plane_->setRange(-1e7, 1e7);
  plane_->setDecimals(3);
  plane_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  plane_->setSuffix(tr(" mm"));
  plane_->setKeyboardTracking(false);
  plane_label_->setBuddy(plane_);
  form->addRow(plane_label_, plane_);
  connect(plane_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double mm) {
    if (const auto row = selected()) setPlane(*row, mm);
  });
}

/// Of the selected measurement, if it has one.
void MeasurePanel::showPlane() {
  const auto row = selected();
  const Measurement* m = row ? &measurements()[static_cast<std::size_t>(*row)] : nullptr;
  const bool shown = m != nullptr && hasPlane(m->kind);
  plane_row_->setVisible(shown);
  if (!shown) return;
  const bool area = m->kind == MeasureKind::area;
  plane_label_->setText(area ? tr("Volume counts from:") : tr("Plane at:"));
  plane_->setAccessibleName(area ? tr("Height from which the volume counts")
                                 : tr("Place of the section's plane"));
  plane_->setToolTip(area ? tr("Height of the plane above which the volume of the selected area "
                               "counts")
                          : tr("Distance of the section's plane from the lower left corner at "
                               "height 0, along its normal; the height of a level plane"));
  const QSignalBlocker quiet(plane_);
  plane_->setValue(m->plane_mm);
}

void MeasurePanel::setPlane(int row, double plane_mm) {
  const auto at = static_cast<std::size_t>(row);
  if (!hasPlane(measurements()[at].kind)) return;
  change([&](Measurements& all) { all[at].plane_mm = plane_mm; });
}

void MeasurePanel::setMeasurements(std::vector<Measurement> measurements) {
  document_.edit(tr("Measurements"), [&](Project& p) { p.measurements = std::move(measurements); });
}

void MeasurePanel::change(const std::function<void(Measurements&)>& change) {
  const QScopedValueRollback<bool> ours(asking_, true);
  document_.edit(tr("Measurements"), [&](Project& p) { change(p.measurements); });
}

// Those of a step back or of another file end what is being made.
void MeasurePanel::showOthers() {
  if (renaming_) return Q_EMIT changed();
  if (!asking_) {
    making_.reset();
    by_touch_ = false;
    tellNext();
  }
  showList();
}

void MeasurePanel::begin(MeasureKind kind) {
  start(kind, false);
}

void MeasurePanel::beginByTouch() {
  start(MeasureKind::depth, true);
}

void MeasurePanel::start(MeasureKind kind, bool by_touch) {
  if (!document_.isOpen()) return;
  by_touch_ = by_touch;
  touched_.forget();
  making_ = Measurement{.kind = kind};
  tellNext();
  Q_EMIT changed();
}

void MeasurePanel::follow(const TouchSample& sample) {
  const bool section = making_ && making_->kind == MeasureKind::section;
  if (!by_touch_ && !section) return;
  const auto mark = touched_.follow(sample, document_.window()->spacingMm());
  if (!mark) return;
  if (!mark->stroke) {
    addPlace(mark->places.front().x, mark->places.front().y);
    return;
  }
  if (section) return;
  keep({.kind = MeasureKind::profile, .places = mark->places});
  Q_EMIT changed();
}

void MeasurePanel::keep(Measurement done) {
  done.name = tr("%1").arg(measurements().size() + 1).toStdString();
  change([&](Measurements& all) { all.push_back(std::move(done)); });
  tell_last_ = true;
  showReadings();
  list_->setCurrentCell(list_->rowCount() - 1, 0);
}

/// All that a measurement reads, one line each; or why it reads nothing.
QString MeasurePanel::readingText(const Measurement& m) const {
  const auto entry = readings_->of(m);
  if (!entry) return tr("Being read\u2026");
  if (!entry->reading) return entry->problem;
  QStringList lines;
  for (const Quantity& q : entry->reading->quantities) lines << quantityText(q);
  if (entry->reading->not_measured > 0) {
    lines
        << tr("%1 % of it is not measured").arg(numberText(100 * entry->reading->not_measured, 0));
  }
  if (!entry->reading->curves.empty()) {
    lines << tr("%n curve(s)", "", static_cast<int>(entry->reading->curves.size()));
  }
  if (hasPlane(m.kind)) lines << planeWords(m);
  return lines.join('\n');
}

void MeasurePanel::showReadings() {
  showList();
  if (!tell_last_ || measurements().empty() || !readings_->of(measurements().back())) return;
  tell_last_ = false;
  Q_EMIT said(readingText(measurements().back()).section('\n', 0, 0));
}

void MeasurePanel::addPlace(double x_mm, double y_mm) {
  if (!making_) return;
  try {
    if (!readings_->isHere({x_mm, y_mm})) {
      readings_->fetch({x_mm, y_mm});
      return Q_EMIT said(
          tr("The finest resolution of this place is on its way. Choose the place again in a "
             "moment."));
    }
    if (!readings_->pointAt({x_mm, y_mm})) return Q_EMIT said(tr("There is no surface here"));
  } catch (const FileError& error) {
    return Q_EMIT said(spokenError(error));
  }
  making_->places.push_back({x_mm, y_mm});
  if (making_->kind == MeasureKind::area && lastSideCrosses(making_->places)) {
    return takeBack(tr("The outline would cross itself here. Choose another place."));
  }
  const int placed = static_cast<int>(making_->places.size());
  if (making_->kind == MeasureKind::section && placed == placesAtMost(MeasureKind::section)) {
    return keepSection();
  }
  if (placed == placesNeeded(making_->kind) && !takesMore(making_->kind)) {
    keep(*std::exchange(making_, std::nullopt));
    if (by_touch_) making_ = Measurement{.kind = MeasureKind::depth};
    if (by_touch_) return Q_EMIT changed();  // What was read stays said.
  }
  tellNext();
  Q_EMIT changed();
}

void MeasurePanel::finish() {
  if (!making_ || !takesMore(making_->kind)) return;
  if (static_cast<int>(making_->places.size()) < placesNeeded(making_->kind)) return;
  if (making_->kind == MeasureKind::area) return keepArea();
  if (making_->kind == MeasureKind::section) return keepSection();
  keep(*std::exchange(making_, std::nullopt));
  tellNext();
  Q_EMIT changed();
}

void MeasurePanel::keepArea() {
  if (!outlineProblem(making_->places).empty()) {
    return takeBack(
        tr("The outline crosses itself or has no area. Its last corner was taken back."));
  }
  Measurement done = *making_;
  // The volume counts from the lowest of the corners, which a change of the list can move.
  try {
    for (std::size_t i = 0; i < done.places.size(); ++i) {
      const auto point = readings_->pointAt(done.places[i]);
      if (point) done.plane_mm = i == 0 ? point->at.z : std::min(done.plane_mm, point->at.z);
    }
  } catch (const FileError& error) {
    return Q_EMIT said(spokenError(error));
  }
  making_.reset();
  keep(std::move(done));
  tellNext();
  Q_EMIT changed();
}

void MeasurePanel::keepSection() {
  std::vector<ViewMm> points;
  try {
    for (const PlaceMm& place : making_->places) {
      if (const auto point = readings_->pointAt(place)) points.push_back(point->at);
    }
    const PlaneMm plane = planeThrough(points);
    making_.reset();
    keep({.kind = MeasureKind::section, .plane_mm = plane.offset_mm, .normal = plane.normal});
  } catch (const FileError& error) {
    return Q_EMIT said(spokenError(error));
  } catch (const ArgumentError& error) {
    return takeBack(spokenError(error));
  }
  tellNext();
  Q_EMIT changed();
}

void MeasurePanel::takeBack(const QString& why) {
  making_->places.pop_back();
  tellNext();
  hint_->setText(why + ' ' + hint_->text());
  Q_EMIT said(why);
  Q_EMIT changed();
}

void MeasurePanel::cancel() {
  making_.reset();
  by_touch_ = false;
  tellNext();
  Q_EMIT changed();
}

void MeasurePanel::tellNext() {
  if (!making_) {
    hint_->setText(tr("Choose in the Measure menu."));
    return;
  }
  if (by_touch_) {
    hint_->setText(
        tr("By touch: with forces on (F5), tap two places for their depth difference, or "
           "draw a stroke for a profile. Escape ends."));
    Q_EMIT said(hint_->text());
    return;
  }
  const int placed = static_cast<int>(making_->places.size());
  const int needed = placesNeeded(making_->kind);
  QString text = tr("%1: place %2 of %3. Click on the detail view, or move the hand there and "
                    "press Enter.")
                     .arg(kindText(making_->kind))
                     .arg(placed + 1)
                     .arg(std::max(needed, placed + 1));
  if (making_->kind == MeasureKind::section) {
    text += ' ' + tr("F after one place: the contour at its height; after two: an upright cut "
                     "through both. Three places: the plane through them.");
  } else if (takesMore(making_->kind) && placed >= needed)
    text += ' ' + tr("A double click or F ends.");
  hint_->setText(text);
  Q_EMIT said(text);
}

void MeasurePanel::showList() {
  showing_ = true;
  readings_->keepOnly(measurements());
  const int selected_row = list_->currentRow();
  list_->setRowCount(static_cast<int>(measurements().size()));
  for (int row = 0; row < list_->rowCount(); ++row) {
    const Measurement& m = measurements()[static_cast<std::size_t>(row)];
    list_->setItem(row, 0, new QTableWidgetItem(QString::fromStdString(m.name)));
    const QString text = document_.isOpen() ? readingText(m) : QString();
    auto* reads = new QTableWidgetItem(text);
    reads->setFlags(reads->flags() & ~Qt::ItemIsEditable);
    reads->setToolTip(kindText(m.kind));
    list_->setItem(row, 1, reads);
  }
  list_->resizeRowsToContents();
  list_->setCurrentCell(std::min(selected_row, list_->rowCount() - 1), 0);
  showPlane();
  // Without any, the room is for what is next.
  for (QWidget* of_some : {static_cast<QWidget*>(list_), static_cast<QWidget*>(remove_),
                           static_cast<QWidget*>(save_)}) {
    of_some->setVisible(!measurements().empty());
  }
  showing_ = false;
  Q_EMIT changed();
}

void MeasurePanel::rename(int row, const QString& name) {
  const QScopedValueRollback<bool> has_it(renaming_, true);  // The list; it must not be made anew.
  change([&](Measurements& all) { all[static_cast<std::size_t>(row)].name = name.toStdString(); });
}

std::optional<int> MeasurePanel::selected() const {
  const int row = list_->currentRow();
  return row >= 0 && row < list_->rowCount() ? std::optional(row) : std::nullopt;
}

void MeasurePanel::removeSelected() {
  const int row = selected().value_or(list_->rowCount() - 1);
  if (row < 0) return;
  change([&](Measurements& all) { all.erase(all.begin() + row); });
}

std::vector<std::vector<ViewMm>> MeasurePanel::lines() const {
  std::vector<std::vector<ViewMm>> lines;
  if (!document_.isOpen()) return lines;
  // What cannot be read from a map by tiles is said in the list.
  const auto point_at = [&](const PlaceMm& place) -> std::optional<SurfacePoint> {
    try {
      return readings_->pointAt(place);
    } catch (const FileError&) {
      return std::nullopt;
    }
  };
  const auto add = [&](const Measurement& m) {
    std::vector<ViewMm> line;
    for (const PlaceMm& place : m.places) {
      const auto point = point_at(place);
      const double gain = document_.project().gain;
      line.push_back({place.x, place.y, point ? gain * point->at.z : 0});
    }
    if (m.kind == MeasureKind::area && line.size() > 2) line.push_back(line.front());
    lines.push_back(line);
  };
  for (const Measurement& m : measurements()) {
    if (m.kind != MeasureKind::section) add(m);
  }
  if (making_) add(*making_);
  return lines;
}

std::vector<std::vector<ViewMm>> MeasurePanel::curves() const {
  std::vector<std::vector<ViewMm>> curves;
  if (!document_.isOpen()) return curves;
  for (const Measurement& m : measurements()) {
    if (m.kind != MeasureKind::section) continue;
    const auto entry = readings_->of(m);
    if (!entry || !entry->reading) continue;
    for (std::vector<ViewMm>& curve : drawnCurves(entry->reading->curves)) {
      for (ViewMm& p : curve) p.z *= document_.project().gain;
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

}  // namespace relievo
