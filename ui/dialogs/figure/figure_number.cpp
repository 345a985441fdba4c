// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/figure/figure_number.h"

#include <algorithm>
#include <cmath>
#include <QSignalBlocker>

namespace relievo {
namespace {

constexpr int kMostDecimals = 6;  // A nanometre.

}  // namespace

FigureNumber::FigureNumber(QWidget* parent) : QDoubleSpinBox(parent) {
  setKeyboardTracking(false);
}

void FigureNumber::setLimits(double low, double high, int decimals, const QString& suffix) {
  least_decimals_ = decimals;
  setDecimals(kMostDecimals);
  setRange(low, high);
  setSuffix(suffix);
}

double FigureNumber::shown(double value) const {
  if (!wrapping()) return std::clamp(value, minimum(), maximum());
  const double turn = maximum() - minimum();
  const double within = std::fmod(value - minimum(), turn);
  return within < 0 ? within + turn + minimum() : within + minimum();
}

void FigureNumber::show(double value) {
  const QSignalBlocker quiet(this);
  setValue(shown(value));
}

double FigureNumber::valueOr(double before) const {
  if (!wrapping() && (before < minimum() || before > maximum())) return value();
  const double half_step = 0.5 * std::pow(10, -decimals());
  return std::abs(shown(before) - value()) <= 1.01 * half_step ? before : value();
}

QString FigureNumber::textFromValue(double value) const {
  QString text = QDoubleSpinBox::textFromValue(value);
  const int point = text.lastIndexOf(locale().decimalPoint());
  if (point < 0) return text;
  const int least = least_decimals_ == 0 ? point : point + 1 + least_decimals_;
  int end = text.size();
  while (end > least && (text[end - 1] == locale().zeroDigit() || end - 1 == point)) --end;
  text.truncate(end);
  return text;
}

}  // namespace relievo
