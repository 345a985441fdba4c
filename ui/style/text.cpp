// SPDX-License-Identifier: BSD-3-Clause
#include "ui/style/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace relievo {
namespace {

constexpr double kMetresFromMm = 10000;

std::optional<LengthUnit> size_unit;

int decimalsFor(double step) {
  if (!(step > 0)) return 2;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step))) + 1, 0, 4);
}

}  // namespace

QString numberText(double value, int decimals) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  // -0.0 would jump between "-0.0" and "0.0" under a resting hand.
  const bool zero = std::abs(value) < 0.5 * std::pow(10.0, -decimals);
  return locale.toString(zero ? 0.0 : value, 'f', decimals);
}

QString mmText(double mm, double step_mm) {
  return numberText(mm, decimalsFor(step_mm));
}

QString sizeText(std::initializer_list<double> mm) {
  double largest = 0;
  for (const double value : mm) largest = std::max(largest, std::abs(value));
  const LengthUnit unit =
      size_unit.value_or(largest >= kMetresFromMm ? LengthUnit::m : LengthUnit::mm);
  const double shown = largest / mmPer(unit);
  const int decimals = shown >= 100 ? 1 : shown >= 1 ? 2 : 3;
  QStringList numbers;
  for (const double value : mm) numbers << numberText(value / mmPer(unit), decimals);
  return QStringLiteral("%1 %2").arg(numbers.join(QStringLiteral(" \u00d7 ")),
                                     QString::fromUtf8(name(unit).data()));
}

QString lengthText(double mm) {
  return sizeText({mm});
}

void setSizeUnit(std::optional<LengthUnit> unit) {
  size_unit = unit;
}

QString unitText(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::mm:
      return QCoreApplication::translate("Text", "millimetres");
    case LengthUnit::cm:
      return QCoreApplication::translate("Text", "centimetres");
    case LengthUnit::m:
      return QCoreApplication::translate("Text", "metres");
    case LengthUnit::in:
      return QCoreApplication::translate("Text", "inches");
    case LengthUnit::ft:
      return QCoreApplication::translate("Text", "feet");
    case LengthUnit::us_ft:
      return QCoreApplication::translate("Text", "US survey feet");
  }
  return {};
}

QString viewText(const QString& name) {
  if (name == QLatin1String("auto")) return QCoreApplication::translate("Text", "Automatic");
  if (name == QLatin1String("free")) return QCoreApplication::translate("Text", "Free view");
  if (name == QLatin1String("fit")) return QCoreApplication::translate("Text", "Best-fit plane");
  if (name == QLatin1String("axes")) return QCoreApplication::translate("Text", "Principal axes");
  if (name == QLatin1String("front")) return QCoreApplication::translate("Text", "Front");
  if (name == QLatin1String("back")) return QCoreApplication::translate("Text", "Back");
  if (name == QLatin1String("left")) return QCoreApplication::translate("Text", "Left");
  if (name == QLatin1String("right")) return QCoreApplication::translate("Text", "Right");
  if (name == QLatin1String("top")) return QCoreApplication::translate("Text", "Top");
  if (name == QLatin1String("bottom")) return QCoreApplication::translate("Text", "Bottom");
  if (name.isEmpty()) return {};
  if (name == QLatin1String("face")) {
    return QCoreApplication::translate("Text", "Automatic, as in earlier versions");
  }
  // One of the six, turned about the line of sight.
  const int comma = name.indexOf(QLatin1String(", "));
  if (comma > 0) {
    const QString face = viewText(name.left(comma));
    const QString turn = name.mid(comma + 2);
    if (turn == QLatin1String("turned to the left")) {
      return QCoreApplication::translate("Text", "%1, turned to the left").arg(face);
    }
    if (turn == QLatin1String("turned to the right")) {
      return QCoreApplication::translate("Text", "%1, turned to the right").arg(face);
    }
    if (turn == QLatin1String("upside down")) {
      return QCoreApplication::translate("Text", "%1, upside down").arg(face);
    }
  }
  return capital(name);
}

QString capital(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace relievo
