// SPDX-License-Identifier: BSD-3-Clause
#include "ui/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QCoreApplication>
#include <QLocale>

namespace relievo {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Text", text);
}

int decimalsFor(double step) {
  if (!(step > 0)) return 2;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step))) + 1, 0, 4);
}

QString number(double value, int decimals) {
  QString text = QLocale().toString(value, 'f', decimals);
  // -0.0 would jump between "-0.0" and "0.0" under a resting hand.
  if (std::abs(value) < 0.5 * std::pow(10.0, -decimals)) {
    text = QLocale().toString(0.0, 'f', decimals);
  }
  return text;
}

}  // namespace

QString mmText(double mm, double step_mm) {
  return number(mm, decimalsFor(step_mm));
}

QString lengthText(double mm) {
  const double size = std::abs(mm);
  if (size >= 10000) return tr("%1 m").arg(number(mm / 1000, size >= 100000 ? 1 : 2));
  if (size >= 100) return tr("%1 mm").arg(number(mm, 1));
  if (size >= 1) return tr("%1 mm").arg(number(mm, 2));
  return tr("%1 mm").arg(number(mm, 3));
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
  if (name.isEmpty()) return {};
  return name.left(1).toUpper() + name.mid(1);
}

}  // namespace relievo
