// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDoubleSpinBox>

namespace relievo {

/// A number of a figure, with no more decimals shown than it has. [GUI thread]
class FigureNumber : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit FigureNumber(QWidget* parent = nullptr);

  /// @param decimals  that are shown at least
  void setLimits(double low, double high, int decimals, const QString& suffix);
  /// Shows a value without telling anybody.
  void show(double value);
  /// The value; `before` as it is where this field shows it, for a record may hold more decimals.
  double valueOr(double before) const;

 protected:
  QString textFromValue(double value) const override;

 private:
  double shown(double value) const;

  int least_decimals_ = 0;
};

}  // namespace relievo
