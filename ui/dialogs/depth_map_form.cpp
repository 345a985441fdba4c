// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/depth_map_form.h"

#include <algorithm>
#include <cmath>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <utility>

#include "core/depth/rules/point_rule.h"
#include "ui/dialogs/scan_choices.h"
#include "ui/language/core_text.h"
#include "ui/style/mnemonic.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

enum class CellChoice { automatic, count, size };

/// "" stands for: from the data.
constexpr int kLeastCharacters = 16;  // That a field shows.
constexpr std::array<const char*, 8> kRules{"front", "second", "topmean",   "median",
                                            "mean",  "splat",  "quadratic", "min"};

}  // namespace

template <class Widget>
Widget* DepthMapForm::field(QFormLayout* layout, const QString& title, const char* name,
                            const QString& tip) {
  auto* widget = new Widget;
  widget->setObjectName(QString::fromLatin1(name));
  widget->setAccessibleName(withoutMnemonic(title));
  widget->setToolTip(tip);
  widget->setMinimumWidth(kLeastCharacters * widget->fontMetrics().averageCharWidth());
  layout->addRow(title, widget);
  if constexpr (std::is_base_of_v<QComboBox, Widget>) {
    widget->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(widget, QOverload<int>::of(&QComboBox::activated), this, [this] {
      limit();
      Q_EMIT changed();
    });
  } else if constexpr (std::is_base_of_v<QDoubleSpinBox, Widget>) {
    connect(widget, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &DepthMapForm::changed);
  } else if constexpr (std::is_base_of_v<QSpinBox, Widget>) {
    connect(widget, QOverload<int>::of(&QSpinBox::valueChanged), this, &DepthMapForm::changed);
  }
  return widget;
}

DepthMapForm::DepthMapForm(OpenedInput source, const Surface& present,
                           const SurfaceOptions& options, QWidget* parent)
    : QWidget(parent),
      source_(std::move(source)),
      first_(options),
      unit_before_(present.unit),
      spacing_mm_(present.map.frame.spacing_mm),
      cells_across_(std::max(present.map.frame.size.cols, present.map.frame.size.rows)) {
  auto* layout = new QFormLayout(this);
  layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
  addSource(layout);
  addGrid(layout);
  addHoles(layout);
  show(options);
  if (!options.unit) {
    unit_->setCurrentIndex(unit_->findData(static_cast<int>(present.unit)));
    showSize();
  }
}

void DepthMapForm::addSource(QFormLayout* layout) {
  unit_ = field<QComboBox>(layout, tr("&Unit of the file"), "depth_unit",
                           tr("Length unit of the file's coordinates"));
  addUnits(*unit_);
  size_ = new QLabel;
  size_->setObjectName(QStringLiteral("depth_size"));
  size_->setAccessibleName(tr("Size in millimetres"));
  size_->setWordWrap(true);
  layout->addRow(tr("Size"), size_);
  strays_ = field<QComboBox>(layout, tr("&Far-off points"), "depth_strays",
                             tr("Few points so far from all others that they stretch the map"));
  strays_->addItem(tr("Leave out"), static_cast<int>(StrayRule::drop));
  strays_->addItem(tr("Leave out, groups too"), static_cast<int>(StrayRule::drop_groups));
  strays_->addItem(tr("Keep"), static_cast<int>(StrayRule::keep));
  view_ =
      field<QComboBox>(layout, tr("&View"), "depth_view", tr("From which side the object is seen"));
  addViews(*view_);
  const bool is_other = first_.view && !first_.view->rotation &&
                        view_->findData(QString::fromStdString(first_.view->name)) < 0;
  if (is_other) {
    const QString word = QString::fromStdString(first_.view->name);
    view_->addItem(viewText(word), word);
  }
  if (first_.view && first_.view->rotation) {
    view_->addItem(tr("As turned in the detail view"), QStringLiteral("free"));
  }
  constexpr std::array<const char*, 3> kTurns{"depth_turn_x", "depth_turn_y", "depth_turn_z"};
  const std::array<QString, 3> axes{tr("Turn about &x"), tr("Turn about &y"), tr("Turn a&bout z")};
  for (std::size_t i = 0; i < turn_.size(); ++i) {
    turn_[i] = field<QDoubleSpinBox>(layout, axes[i], kTurns[i],
                                     tr("Right-handed, about the view's own axes, x first"));
    turn_[i]->setRange(-180, 180);
    turn_[i]->setDecimals(2);
    turn_[i]->setSuffix(QStringLiteral("\u00b0"));
    turn_[i]->setKeyboardTracking(false);
  }
  engine_ = field<QComboBox>(layout, tr("M&ethod"), "depth_engine",
                             tr("The processor, or the graphics card's depth buffer as in the "
                                "paper"));
  engine_->addItem(tr("CPU"), QStringLiteral("cpu"));
  engine_->addItem(tr("OpenGL"), QStringLiteral("depthbuffer"));
  rule_ = field<QComboBox>(layout, tr("Height pe&r cell"), "depth_rule",
                           tr("Which height a cell gets from the points in it"));
  rule_->addItem(tr("From the data"), QString());
  for (const char* name : kRules) {
    rule_->addItem(capital(coreText(describe(*pointRule(name)))), QString::fromLatin1(name));
  }
}

void DepthMapForm::addGrid(QFormLayout* layout) {
  cell_choice_ =
      field<QComboBox>(layout, tr("&Grid"), "depth_cell_choice", tr("How fine the grid is"));
  cell_choice_->addItem(tr("From the data"), static_cast<int>(CellChoice::automatic));
  cell_choice_->addItem(tr("Number of cells"), static_cast<int>(CellChoice::count));
  cell_choice_->addItem(tr("Size of a cell"), static_cast<int>(CellChoice::size));
  cells_ = field<QSpinBox>(layout, tr("&Cells"), "depth_cells", tr("Cells across the longer side"));
  cells_->setRange(2, 16384);
  cells_->setKeyboardTracking(false);
  cells_->setValue(cells_across_);
  spacing_ = field<QDoubleSpinBox>(layout, tr("Cell si&ze"), "depth_spacing",
                                   tr("Distance of neighbouring cells"));
  spacing_->setDecimals(4);
  spacing_->setRange(0.0001, 1e6);
  spacing_->setSuffix(QStringLiteral(" mm"));
  spacing_->setKeyboardTracking(false);
  spacing_->setValue(spacing_mm_);
  factor_ = field<QDoubleSpinBox>(layout, tr("Pyra&mid factor"), "depth_factor",
                                  tr("How much coarser each level of the pyramid is; 2 in the "
                                     "paper"));
  factor_->setDecimals(3);
  factor_->setRange(kLeastFactor, kMostFactor);
  factor_->setSingleStep(0.5);
  factor_->setKeyboardTracking(false);
}

void DepthMapForm::addHoles(QFormLayout* layout) {
  holes_ = field<QComboBox>(layout, tr("&Holes"), "depth_holes",
                            tr("What becomes of enclosed places where nothing was measured"));
  holes_->addItem(tr("On the base plane"), static_cast<int>(HoleRule::base));
  holes_->addItem(tr("Interpolate up to"), static_cast<int>(HoleRule::interpolate));
  holes_->addItem(tr("Smooth membrane up to"), static_cast<int>(HoleRule::membrane));
  holes_->addItem(tr("Leave open"), static_cast<int>(HoleRule::none));
  hole_area_ = field<QDoubleSpinBox>(layout, tr("&Largest hole"), "depth_hole_area",
                                     tr("Larger holes rest on the base plane"));
  hole_area_->setDecimals(1);
  hole_area_->setRange(0, 1e9);
  hole_area_->setSuffix(QStringLiteral(" mm\u00b2"));
  hole_area_->setKeyboardTracking(false);
  hole_area_->setValue(100);
  base_ = new QLabel(source_.raster ? tr("The lowest cell of the raster")
                                    : tr("0.1 % of the measured cells lie below it"));
  base_->setObjectName(QStringLiteral("depth_base"));
  base_->setAccessibleName(tr("Base plane"));
  base_->setWordWrap(true);
  layout->addRow(tr("Base plane"), base_);
}

void DepthMapForm::show(const SurfaceOptions& o) {
  const QSignalBlocker quiet(this);
  if (o.unit) unit_->setCurrentIndex(unit_->findData(static_cast<int>(*o.unit)));
  const std::string view = o.view ? o.view->name : source_.raster ? "top" : "auto";
  view_->setCurrentIndex(std::max(0, view_->findData(QString::fromStdString(view))));
  for (std::size_t i = 0; o.view && i < turn_.size(); ++i) turn_[i]->setValue(o.view->turn_deg[i]);
  engine_->setCurrentIndex(engine_->findData(QString::fromStdString(o.engine)));
  strays_->setCurrentIndex(strays_->findData(static_cast<int>(o.strays)));
  for (int i = 1; o.rule && i < rule_->count(); ++i) {
    if (pointRule(rule_->itemData(i).toString().toStdString()) == o.rule) rule_->setCurrentIndex(i);
  }
  if (o.cells) {
    cell_choice_->setCurrentIndex(static_cast<int>(CellChoice::count));
    cells_->setValue(*o.cells);
  }
  if (o.spacing_mm) {
    cell_choice_->setCurrentIndex(static_cast<int>(CellChoice::size));
    spacing_->setValue(*o.spacing_mm);
  }
  factor_->setValue(o.pyramid.factor);
  holes_->setCurrentIndex(holes_->findData(static_cast<int>(o.holes.rule)));
  if (o.holes.max_area_mm2 > 0) hole_area_->setValue(o.holes.max_area_mm2);
  limit();
}

/// What cannot be chosen is grey, and its tooltip says why.
void DepthMapForm::limit() {
  const bool raster = source_.raster != nullptr;
  const bool own_map = raster && source_.raster->is_own_map;
  const bool mesh = source_.scan && !source_.scan->triangles.empty();
  const auto set = [](QWidget* widget, bool on, const QString& why) {
    widget->setEnabled(on);
    widget->setStatusTip(on ? QString() : why);
    widget->setAccessibleDescription(on ? QString() : why);
  };
  const QString stored = tr("A height map keeps its cells and its view.");
  set(unit_, !own_map, tr("A map of this program is in millimetres."));
  set(view_, !raster, stored);
  for (QDoubleSpinBox* box : turn_) set(box, !raster, stored);
  set(engine_, !raster, stored);
  set(strays_, !raster, tr("A height map has none."));
  set(cell_choice_, !raster, stored);
  set(holes_, !own_map, tr("A map of this program has its holes treated already."));
  const bool cpu = engine_->currentData().toString() == QLatin1String("cpu");
  set(rule_, !raster && !mesh && cpu,
      mesh ? tr("Triangles need no rule.") : tr("The depth buffer keeps the front-most point."));
  const auto choice = static_cast<CellChoice>(cell_choice_->currentData().toInt());
  cells_->setEnabled(!raster && choice == CellChoice::count);
  spacing_->setEnabled(!raster && choice == CellChoice::size);
  const auto rule = static_cast<HoleRule>(holes_->currentData().toInt());
  hole_area_->setEnabled(!own_map && (rule == HoleRule::interpolate || rule == HoleRule::membrane));
  showSize();
}

void DepthMapForm::showSize() {
  const ScanInfo& info = source_.info();
  if (!info.bounds) {
    size_->setText(tr("unknown"));
    return;
  }
  const FilePoint size = sizeMm(source_, options());
  size_->setText(sizeText({size.x, size.y, size.z}));
}

SurfaceOptions DepthMapForm::options() const {
  SurfaceOptions o = first_;
  const auto unit = static_cast<LengthUnit>(unit_->currentData().toInt());
  if (unit != unit_before_) {
    o.unit = unit;
    o.unit_source = UnitSource::given;
  }
  const std::string view = view_->currentData().toString().toStdString();
  if (!source_.raster) {
    ViewChoice chosen = view == "free" && first_.view ? *first_.view : ViewChoice{view, {}};
    for (std::size_t i = 0; i < turn_.size(); ++i) chosen.turn_deg[i] = turn_[i]->value();
    o.view = chosen;
  }
  o.engine = engine_->currentData().toString().toStdString();
  o.strays = static_cast<StrayRule>(strays_->currentData().toInt());
  o.rule =
      rule_->isEnabled() ? pointRule(rule_->currentData().toString().toStdString()) : std::nullopt;
  const auto choice = static_cast<CellChoice>(cell_choice_->currentData().toInt());
  o.cells = choice == CellChoice::count ? std::optional(cells_->value()) : std::nullopt;
  o.spacing_mm = choice == CellChoice::size ? std::optional(spacing_->value()) : std::nullopt;
  o.pyramid.factor = factor_->value();
  o.holes.rule = static_cast<HoleRule>(holes_->currentData().toInt());
  o.holes.max_area_mm2 = hole_area_->isEnabled() ? hole_area_->value() : 0;
  return o;
}

}  // namespace relievo
