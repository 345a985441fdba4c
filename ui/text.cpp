// SPDX-License-Identifier: BSD-3-Clause
#include "ui/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace relievo {
namespace {

constexpr double kMetresFromMm = 10000;

QString tr(const char* text) {
  return QCoreApplication::translate("Text", text);
}

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
  const bool metres = largest >= kMetresFromMm;
  const double shown = metres ? largest / 1000 : largest;
  const int decimals = shown >= 100 ? 1 : shown >= 1 ? 2 : 3;
  QStringList numbers;
  for (const double value : mm) numbers << numberText(metres ? value / 1000 : value, decimals);
  return (metres ? tr("%1 m") : tr("%1 mm")).arg(numbers.join(QStringLiteral(" \u00d7 ")));
}

QString lengthText(double mm) {
  return sizeText({mm});
}

QString unitText(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::mm:
      return tr("millimetres");
    case LengthUnit::cm:
      return tr("centimetres");
    case LengthUnit::m:
      return tr("metres");
    case LengthUnit::in:
      return tr("inches");
    case LengthUnit::ft:
      return tr("feet");
    case LengthUnit::us_ft:
      return tr("US survey feet");
  }
  return {};
}

QString viewText(const QString& name) {
  if (name == QLatin1String("auto")) return tr("Automatic");
  if (name == QLatin1String("free")) return tr("Free view");
  if (name == QLatin1String("fit")) return tr("Best-fit plane");
  if (name == QLatin1String("axes")) return tr("Principal axes");
  if (name.isEmpty()) return {};
  return name.left(1).toUpper() + name.mid(1);
}

}  // namespace relievo
