// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/surface_panel.h"

#include <algorithm>
#include <cmath>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include "core/region/smoothing.h"
#include "core/session/map_facts.h"
#include "ui/message/message_text.h"
#include "ui/style/mnemonic.h"
#include "ui/style/text.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr int kLeastFieldWidth = 90;
constexpr double kMostGain = 20;
constexpr int kGainSteps = 100;  // Slider positions either side of gain 1.

int sliderOf(double gain) {
  return static_cast<int>(std::lround(kGainSteps * std::log(gain) / std::log(kMostGain)));
}
double gainOf(int slider) {
  return std::pow(kMostGain, static_cast<double>(slider) / kGainSteps);
}

/// "2/4 (level 2, \u03c3 0.56 mm)": what the level is smoothed by, if it is.
QString levelText(const DetailLadder& ladder, Level level) {
  const int detail = ladder.detailOf(level);
  if (level.value == 0) {
    return RegionPanel::tr("%1/%2 (level 0)").arg(detail).arg(ladder.levels());
  }
  return RegionPanel::tr("%1/%2 (level %3, \u03c3 %4)")
      .arg(QString::number(detail), QString::number(ladder.levels()), QString::number(level.value),
           lengthText(smoothingMm(ladder, level)));
}

QFormLayout* form(QWidget* panel) {
  auto* layout = new QFormLayout(panel);
  layout->setContentsMargins(3, 0, 0, 2);
  layout->setHorizontalSpacing(6);
  layout->setVerticalSpacing(1);
  layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  return layout;
}

QLabel* fact(QFormLayout* layout, const QString& title, const QString& name) {
  auto* label = new QLabel;
  label->setTextFormat(Qt::PlainText);
  label->setAccessibleName(title);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  layout->addRow(title, label);
  return label;
}

/// A field with its label as buddy, so that the mnemonic and the accessible name agree.
template <class Widget>
Widget* field(QFormLayout* layout, const QString& title, const QString& name, const QString& tip) {
  auto* widget = new Widget;
  widget->setObjectName(name);
  widget->setAccessibleName(withoutMnemonic(title));
  widget->setToolTip(tip);
  widget->setMinimumWidth(kLeastFieldWidth);  // Wide ranges must not widen the panel.
  layout->addRow(title, widget);
  return widget;
}

QDoubleSpinBox* mmField(QFormLayout* layout, const QString& title, const QString& name,
                        const QString& tip) {
  auto* box = field<QDoubleSpinBox>(layout, title, name, tip);
  box->setRange(-1e9, 1e9);
  box->setDecimals(2);
  box->setSuffix(QStringLiteral(" mm"));
  box->setKeyboardTracking(false);
  return box;
}

/// What became of the holes: "3, on the base plane"; "3: 1 on the base plane, 2 interpolated".
QString holesText(const std::vector<Hole>& holes, HoleRule rule) {
  if (holes.empty()) return SurfacePanel::tr("none");
  const auto count = [&](CellStatus origin) {
    return std::count_if(holes.begin(), holes.end(),
                         [&](const Hole& hole) { return originOfHole(hole, rule) == origin; });
  };
  QStringList kinds, parts;
  const auto name = [&](CellStatus origin, const QString& what) {
    const auto here = count(origin);
    if (here == 0) return;
    kinds << what;
    parts << QStringLiteral("%1 %2").arg(here).arg(what);
  };
  name(CellStatus::base_plane, SurfacePanel::tr("on the base plane"));
  name(CellStatus::interpolated, SurfacePanel::tr("interpolated"));
  name(CellStatus::outside, SurfacePanel::tr("left open"));
  return kinds.size() == 1
             ? QStringLiteral("%1, %2").arg(holes.size()).arg(kinds.front())
             : QStringLiteral("%1: %2").arg(holes.size()).arg(parts.join(QStringLiteral(", ")));
}

/// A map that is taken as it was stored knows its cells, not which of them make one hole.
QString holesText(const Surface& surface, HoleRule rule) {
  if (surface.engine != "as stored") return holesText(surface.holes, rule);
  const auto shares = mapFacts(surface).shares;
  const auto percent = [&](CellStatus origin) {
    return 100 * shares.at(static_cast<std::size_t>(origin));
  };
  const double on_base = percent(CellStatus::base_plane);
  const double filled = percent(CellStatus::interpolated);
  if (on_base + filled == 0) return SurfacePanel::tr("none");
  return SurfacePanel::tr("not counted; %1 % of the cells on the base plane, %2 % interpolated")
      .arg(numberText(on_base, 2), numberText(filled, 2));
}

}  // namespace

SurfacePanel::SurfacePanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document) {
  setObjectName(QStringLiteral("surface_panel"));
  QFormLayout* layout = form(this);
  file_ = fact(layout, tr("File"), QStringLiteral("surface_file"));
  size_ = fact(layout, tr("Size"), QStringLiteral("surface_size"));
  cells_ = fact(layout, tr("Grid"), QStringLiteral("surface_cells"));
  holes_ = fact(layout, tr("Holes"), QStringLiteral("surface_holes"));
  unit_ = field<QComboBox>(layout, tr("&Unit"), QStringLiteral("unit"),
                           tr("Length unit of the file's coordinates"));
  for (const LengthUnitFact& u : kLengthUnits) {
    unit_->addItem(unitText(u.unit), static_cast<int>(u.unit));
  }
  connect(unit_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { Q_EMIT unitChosen(static_cast<LengthUnit>(unit_->currentData().toInt())); });
  connect(&document_, &Document::surfaceChanged, this, &SurfacePanel::showSurface);
  // A choice that was not carried out must not stay on show.
  connect(&document_.loader(), &SurfaceLoader::busyChanged, this, &SurfacePanel::showSurface);
  connect(&document_, &Document::failed, this, &SurfacePanel::showSurface);
  showSurface();
}

void SurfacePanel::showSurface() {
  setEnabled(document_.isOpen());
  if (!document_.isOpen() || document_.loader().busy()) return;
  const Surface& s = *document_.surface();
  const HeightRange z = mapFacts(s).heights;
  const GridFrame& grid = mapFrame(s);
  constexpr int kMostCharacters = 26;  // Of the panel's width; the tip has all.
  const QFontMetrics letters = file_->fontMetrics();
  file_->setText(letters.elidedText(shownName(document_.file()), Qt::ElideMiddle,
                                    kMostCharacters * letters.averageCharWidth()));
  file_->setToolTip(shownAsTip(document_.file()));
  size_->setText(sizeText({s.ladder.width_mm, s.ladder.height_mm, z.max_mm - z.min_mm}));
  cells_->setText(tr("%1 \u00d7 %2, %3 apart")
                      .arg(grid.size.cols)
                      .arg(grid.size.rows)
                      .arg(lengthText(grid.spacing_mm)));
  QStringList notes;
  for (const Message& message : s.messages) notes << messageText(message);
  cells_->setToolTip(notes.join('\n'));
  holes_->setText(holesText(s, document_.project().options.holes.rule));
  const QSignalBlocker quiet_unit(unit_);
  unit_->setCurrentIndex(unit_->findData(static_cast<int>(s.unit)));
  const std::string_view source = name(s.unit_source);
  unit_->setAccessibleDescription(
      QString::fromUtf8(source.data(), static_cast<int>(source.size())));
  unit_->setToolTip(
      tr("Length unit of the file's coordinates (%1)").arg(unit_->accessibleDescription()));
}

RegionPanel::RegionPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document) {
  setObjectName(QStringLiteral("region_panel"));
  QFormLayout* layout = form(this);
  x_ = mmField(layout, QStringLiteral("&x"), QStringLiteral("region_x"),
               tr("Left edge of the pink window"));
  x_->setAccessibleName(tr("Left edge of the window"));
  y_ = mmField(layout, QStringLiteral("&y"), QStringLiteral("region_y"),
               tr("Lower edge of the pink window"));
  y_->setAccessibleName(tr("Lower edge of the window"));
  side_ = mmField(layout, tr("Si&de"), QStringLiteral("region_side"),
                  tr("Width and height of the pink window"));
  side_->setMinimum(0.01);
  level_ = field<QComboBox>(layout, tr("Reso&lution"), QStringLiteral("region_level"),
                            tr("Which level of the pyramid feeds the window"));
  gain_ = new QDoubleSpinBox;
  gain_->setObjectName(QStringLiteral("gain"));
  gain_->setToolTip(tr("Heights are multiplied by this; 1 is true to scale"));
  gain_->setAccessibleName(tr("Vertical exaggeration"));
  gain_->setRange(1 / kMostGain, kMostGain);
  gain_->setDecimals(2);
  gain_->setSingleStep(0.1);
  gain_->setPrefix(QStringLiteral("\u00d7 "));
  gain_->setKeyboardTracking(false);
  gain_slider_ = new QSlider(Qt::Horizontal);
  gain_slider_->setObjectName(QStringLiteral("gain_slider"));
  gain_slider_->setAccessibleName(tr("Vertical exaggeration"));
  gain_slider_->setToolTip(tr("Heights are multiplied by this; the middle is true to scale"));
  gain_slider_->setRange(-kGainSteps, kGainSteps);
  // Its steps are no numbers that somebody knows; keys and ears have the field beside it.
  gain_slider_->setFocusPolicy(Qt::NoFocus);
  auto* gain_label = new QLabel(tr("Exaggeratio&n"));
  gain_label->setBuddy(gain_);
  auto* gain_row = new QHBoxLayout;  // Of its own: its long name would leave the fields no room.
  gain_row->setSpacing(layout->horizontalSpacing());
  gain_row->addWidget(gain_label);
  gain_row->addWidget(gain_);
  gain_row->addWidget(gain_slider_, 1);
  layout->addRow(gain_row);
  hand_scale_ = new QLabel;
  hand_scale_->setObjectName(QStringLiteral("hand_scale"));
  hand_scale_->setAccessibleName(tr("Hand scale"));
  hand_scale_->setWordWrap(true);
  layout->addRow(hand_scale_);

  for (QDoubleSpinBox* box : {x_, y_, side_}) {
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &RegionPanel::typed);
  }
  connect(level_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { document_.region().setLevel({level_->currentData().toInt()}); });
  connect(gain_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double gain) {
    if (!showing_) document_.region().setGain(gain);
  });
  connect(gain_slider_, &QSlider::valueChanged, this, [this](int value) {
    if (showing_) return;
    if (gain_slider_->isSliderDown()) {
      document_.region().previewGain(gainOf(value));
    } else {
      document_.region().setGain(gainOf(value));
    }
  });
  connect(gain_slider_, &QSlider::sliderReleased, this,
          [this] { document_.region().commit(tr("Vertical exaggeration")); });
  connect(&document_, &Document::windowChanged, this, &RegionPanel::showWindow);
  showWindow();
}

void RegionPanel::typed() {
  if (showing_ || !document_.isOpen()) return;
  // A number that was only shown rounded keeps its digits.
  const auto meant = [](const QDoubleSpinBox* box, double exact) {
    const double half = 0.5 * std::pow(10.0, -box->decimals());
    return std::abs(box->value() - exact) <= 1.001 * half ? exact : box->value();
  };
  const Region& r = document_.project().region;
  const double side = meant(side_, r.side_mm);
  if (!document_.region().setRect({meant(x_, r.x_mm), meant(y_, r.y_mm), side, side})) showWindow();
}

void RegionPanel::showWindow() {
  setEnabled(document_.isOpen());
  const auto window = document_.window();
  if (!window) return;
  showing_ = true;
  const Surface& s = *document_.surface();
  const double step = window->region.side_mm / 10;
  for (QDoubleSpinBox* box : {x_, y_, side_}) {
    box->setDecimals(mapFrame(s).spacing_mm < 0.05 ? 4 : 2);
    box->setSingleStep(step);
  }
  x_->setValue(window->region.x_mm);
  y_->setValue(window->region.y_mm);
  side_->setValue(window->region.side_mm);
  const int levels = document_.details();
  QStringList names;
  for (int level = levels - 1; level >= 0; --level) names << levelText(s.ladder, {level});
  if (names != level_names_) {  // Of another map, or in another unit.
    level_names_ = names;
    level_->clear();
    for (int i = 0; i < levels; ++i) {
      level_->addItem(names[i], levels - 1 - i);
      level_->setItemData(i, names[i], Qt::ToolTipRole);
    }
  }
  level_->setCurrentIndex(level_->findData(window->region.level.value));
  gain_->setValue(window->gain);
  if (!gain_slider_->isSliderDown()) gain_slider_->setValue(sliderOf(window->gain));
  const double scale = handMapping(*window).objectMmPerHandMm();
  hand_scale_->setText(tr("Hand scale 1 : %1").arg(mmText(scale, scale / 10)));
  showing_ = false;
}

}  // namespace relievo
