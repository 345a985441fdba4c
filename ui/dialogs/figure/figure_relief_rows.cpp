// SPDX-License-Identifier: BSD-3-Clause
// How heights are painted.
#include <cmath>
#include <QSignalBlocker>
#include <QStandardItemModel>

#include "core/relief/relief_image.h"
#include "core/session/colours/surface_colours.h"
#include "ui/dialogs/figure/far_limit.h"
#include "ui/dialogs/figure/figure_form.h"
#include "ui/dialogs/figure/figure_form_parts.h"
#include "ui/dialogs/figure/figure_form_rows.h"
#include "ui/language/core_text.h"

namespace relievo {
namespace {

constexpr double kSteps = 1000;  // That an automatic value is rounded to, of what it spans.
constexpr std::array<const char*, kReliefKindNames.size()> kReliefs{
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Shaded relief"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Height in colour"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Hillshade"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Hillshade, four lights"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Slope"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Local relief"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Sky-view factor"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Openness"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Deviation, several scales"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Curvature, several scales"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Shaded, with ambient occlusion"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Natural colours"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Intensity")};

double rounded(double value, double step) {
  return step > 0 ? std::round(value / step) * step : value;
}

}  // namespace

FigureReliefRows::FigureReliefRows(FigureFormRows& rows, const Surface& surface) {
  relief_ = rows.field<QComboBox>(FigureForm::tr("Rel&ief"), "figure_relief",
                                  FigureForm::tr("How heights are painted"));
  for (const char* name : kReliefs) relief_->addItem(FigureForm::tr(name));
  for (std::size_t i = 0; i < kReliefs.size(); ++i) {
    if (canShow(surface, static_cast<ReliefKind>(i))) continue;
    auto* items = qobject_cast<QStandardItemModel*>(relief_->model());
    QStandardItem* item = items->item(static_cast<int>(i));
    item->setEnabled(false);
    item->setToolTip(FigureForm::tr("This scan has none"));
  }
  colours_ = rows.field<QComboBox>(
      FigureForm::tr("Colours"), "figure_colours",
      FigureForm::tr("Even steps of lightness, also for colour-blind readers"));
  for (const std::string_view name : kColourMapNames) {
    colours_->addItem(coreText(name));
  }
  azimuth_ =
      rows.field<FigureNumber>(FigureForm::tr("Light from"), "figure_azimuth",
                               FigureForm::tr("0 is above, clockwise; 315 is the upper left"));
  azimuth_->setLimits(0, 360, 0, QStringLiteral("\u00b0"));
  azimuth_->setWrapping(true);
  elevation_ = rows.field<FigureNumber>(FigureForm::tr("Light's height"), "figure_elevation",
                                        FigureForm::tr("Low light brings out worn detail"));
  elevation_->setLimits(0, 90, 0, QStringLiteral("\u00b0"));
  radius_ = rows.field<FigureNumber>(
      FigureForm::tr("Radius"), "figure_radius",
      FigureForm::tr("Of the neighbourhood that this relief image looks at"));
  radius_->setLimits(0, kFarMm, 2, QStringLiteral(" mm"));
  radius_->setSpecialValueText(FigureForm::tr("10 samples"));
  shading_ = rows.field<FigureNumber>(
      FigureForm::tr("Shading"), "figure_shading",
      FigureForm::tr("How much relief shading natural colours and intensity get"));
  shading_->setLimits(0, 100, 0, QStringLiteral(" %"));
  addRange(rows);
}

void FigureReliefRows::addRange(FigureFormRows& rows) {
  own_range_ = rows.field<QCheckBox>(
      FigureForm::tr("O&wn ends of the colours"), "figure_range_on",
      FigureForm::tr("The same colours for the same values in several figures; "
                     "otherwise they follow from what is shown"));
  range_low_ = rows.field<FigureNumber>(FigureForm::tr("Colours from"), "figure_range_low",
                                        FigureForm::tr("Value at the colours' lower end"));
  range_high_ = rows.field<FigureNumber>(FigureForm::tr("Colours to"), "figure_range_high",
                                         FigureForm::tr("Value at the colours' upper end"));
  for (FigureNumber* end : {range_low_, range_high_}) {
    end->setLimits(-kFarMm, kFarMm, 1, {});
    end->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  }
  // The ends of one quantity say nothing about another.
  QObject::connect(relief_, QOverload<int>::of(&QComboBox::activated), relief_, [this](int kind) {
    if (kind != shown_relief_) own_range_->setChecked(false);
    shown_relief_ = kind;
  });
}

void FigureReliefRows::show(const FigureRequest& f) {
  relief_->setCurrentIndex(static_cast<int>(f.look.kind));
  shown_relief_ = relief_->currentIndex();
  colours_->setCurrentIndex(static_cast<int>(f.look.colours));
  azimuth_->show(f.look.light.azimuth_deg);
  elevation_->show(f.look.light.elevation_deg);
  radius_->show(f.look.radius_mm);
  shading_->show(100 * f.look.shading);
  own_range_->setChecked(f.look.range.has_value());
  if (f.look.range) {
    range_low_->show((*f.look.range)[0]);
    range_high_->show((*f.look.range)[1]);
  }
}

void FigureReliefRows::writeTo(FigureRequest& f) const {
  f.look.kind = static_cast<ReliefKind>(relief_->currentIndex());
  f.look.colours = static_cast<ColourMap>(colours_->currentIndex());
  f.look.light = {azimuth_->valueOr(f.look.light.azimuth_deg),
                  elevation_->valueOr(f.look.light.elevation_deg)};
  f.look.radius_mm = radius_->valueOr(f.look.radius_mm);
  f.look.shading = shading_->valueOr(100 * f.look.shading) / 100;
  if (own_range_->isChecked()) {
    const auto before =
        f.look.range.value_or(std::array{range_low_->value(), range_high_->value()});
    f.look.range = {{range_low_->valueOr(before[0]), range_high_->valueOr(before[1])}};
  } else {
    f.look.range.reset();
  }
}

void FigureReliefRows::limit() {
  const auto kind = static_cast<ReliefKind>(relief_->currentIndex());
  const bool own_colours = showsOwnColours(kind);
  const QString stone = own_colours
                            ? FigureForm::tr("Its colours are the scan's own")
                            : FigureForm::tr("Shaded reliefs and hillshades have no colours");
  setUsable(colours_, hasLegend(kind), stone);
  setUsable(own_range_, hasLegend(kind), stone);
  const bool own = own_range_->isChecked();
  for (QWidget* end : {range_low_, range_high_}) {
    setUsable(
        end, hasLegend(kind) && own,
        hasLegend(kind) ? FigureForm::tr("Turn on \"Own ends of the colours\" first") : stone);
  }
  const bool lamps = isLit(kind) || kind == ReliefKind::hillshade || own_colours;
  const bool four = kind == ReliefKind::multi_hillshade;
  const QString unlit = FigureForm::tr("No lamp shines on this relief");
  setUsable(azimuth_, lamps, four ? FigureForm::tr("The four lights come from all sides") : unlit);
  setUsable(elevation_, lamps || four, unlit);
  setUsable(radius_, hasRadius(kind), FigureForm::tr("This relief does not depend on one"));
  setUsable(shading_, own_colours,
            FigureForm::tr("Only natural colours and intensity are mixed with it"));
}

void FigureReliefRows::showAutomatic(const FigureFacts& facts) {
  const QString unit =
      QString::fromUtf8(facts.range_unit.data(), static_cast<int>(facts.range_unit.size()));
  for (FigureNumber* end : {range_low_, range_high_}) {
    const QSignalBlocker quiet(end);
    end->setSuffix(unit == QLatin1String("mm") ? QLatin1Char(' ') + unit : unit);
  }
  if (facts.range && !own_range_->isChecked()) {
    const auto [low, high] = *facts.range;
    const double step = std::pow(10, std::floor(std::log10((high - low) / kSteps)));
    range_low_->show(rounded(low, step));
    range_high_->show(rounded(high, step));
  }
}

}  // namespace relievo
