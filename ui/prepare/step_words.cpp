// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/step_words.h"

#include <cmath>
#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "ui/style/text.h"

namespace relievo {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("relievo", text);
}

QString number(double value) {
  return QLocale().toString(value, 'g', 6);
}

// What follows the name.
QString detailsOf(const CropBox& s) {
  return s.keep_inside ? QString() : tr("what is outside stays");
}
QString detailsOf(const CropOutline& s) {
  const QString corners = tr("%1 corners").arg(s.outline.size());
  return s.keep_inside ? corners : tr("%1, what is outside stays").arg(corners);
}
QString detailsOf(const Classes& s) {
  QStringList kept;
  for (const int c : s.keep) kept << QString::number(c);
  return kept.isEmpty() ? tr("all but noise") : kept.join(QStringLiteral(", "));
}
QString detailsOf(const Returns& s) {
  switch (s.keep) {
    case ReturnChoice::first:
      return tr("first");
    case ReturnChoice::last:
      return tr("last");
    case ReturnChoice::single:
      return tr("single");
  }
  return {};
}
QString detailsOf(const Intensities& s) {
  return tr("%1 to %2").arg(number(s.low), number(s.high));
}
QString detailsOf(const Duplicates&) {
  return {};
}
QString detailsOf(const Outliers& s) {
  return tr("%1 neighbours, %2 deviations").arg(s.neighbours).arg(number(s.deviations));
}
QString detailsOf(const Lonely& s) {
  const QString radius = s.radius_mm ? tr("%1 mm").arg(number(*s.radius_mm))
                                     : tr("%1 spacings").arg(number(s.spacings));
  return tr("fewer than %1 within %2").arg(s.neighbours).arg(radius);
}
QString detailsOf(const Sparse& s) {
  const QString sparse = tr("%1 neighbours, %2 times").arg(s.neighbours).arg(number(s.factor));
  return s.off_surface > 0 ? tr("%1, off the surface %2 times").arg(sparse, number(s.off_surface))
                           : sparse;
}
QString detailsOf(const Thin& s) {
  return tr("one in %1 mm").arg(number(s.spacing_mm));
}
QString detailsOf(const Base& s) {
  return s.lay ? tr("laid level") : tr("left out");
}
QString detailsOf(const Normals& s) {
  return tr("%1 neighbours").arg(s.neighbours);
}
QString detailsOf(const Align& s) {
  switch (s.method) {
    case AlignMethod::stored:
      return tr("as stored");
    case AlignMethod::points:
      return tr("by picked pairs");
    case AlignMethod::automatic:
      return tr("automatic");
  }
  return {};
}

// What it is called.
QString calledOf(const CropBox&) {
  return tr("Crop to a box");
}
QString calledOf(const CropOutline&) {
  return tr("Crop to an outline");
}
QString calledOf(const Classes&) {
  return tr("Classes of points");
}
QString calledOf(const Returns&) {
  return tr("Returns of a pulse");
}
QString calledOf(const Intensities&) {
  return tr("Intensities");
}
QString calledOf(const Duplicates&) {
  return tr("Equal points");
}
QString calledOf(const Outliers&) {
  return tr("Outliers, statistical");
}
QString calledOf(const Lonely&) {
  return tr("Outliers, within a radius");
}
QString calledOf(const Sparse&) {
  return tr("Thin beside dense");
}
QString calledOf(const Thin&) {
  return tr("Thin out");
}
QString calledOf(const Base&) {
  return tr("Plane under the object");
}
QString calledOf(const Normals&) {
  return tr("Normals");
}
QString calledOf(const Align&) {
  return tr("Align and join");
}

/// Two digits, so that a field does not begin with noise.
double rounded(double value) {
  if (!(value > 0)) return 1;
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::round(value / unit) * unit;
}

}  // namespace

QString nameOfStep(const Step& step) {
  return std::visit([](const auto& s) { return calledOf(s); }, step);
}

QString wordsOfStep(const Step& step) {
  const QString details = std::visit([](const auto& s) { return detailsOf(s); }, step);
  return details.isEmpty() ? nameOfStep(step)
                           : QStringLiteral("%1: %2").arg(nameOfStep(step), details);
}

std::vector<OfferedStep> offeredSteps(const FileBounds& box, LengthUnit unit, double spacing) {
  return {{tr("&Crop to a box"), {CropBox{.min = box.min, .max = box.max}}},
          {tr("Crop to an outline on the &view"), {CropOutline{}}},
          {tr("&Stray points, as for most scans"), cleaningSteps()},
          {tr("&Outliers, statistical"), {Outliers{}}},
          {tr("Outliers, within a &radius"), {Lonely{}}},
          {tr("Thin &beside dense"), {Sparse{}}},
          {tr("&Equal points"), {Duplicates{}}},
          {tr("C&lasses of points"), {Classes{}}},
          {tr("Returns of a p&ulse"), {Returns{}}},
          {tr("&Intensities"), {Intensities{.low = 0, .high = 65535}}},
          {tr("&Thin out"), {Thin{.spacing_mm = rounded(2 * spacing * mmPer(unit))}}},
          {tr("Leave out the &plane under the object"), {Base{}}},
          {tr("Lay the plane under the object le&vel"), {Base{.lay = true}}},
          {tr("&Normals"), {Normals{}}}};
}

}  // namespace relievo
