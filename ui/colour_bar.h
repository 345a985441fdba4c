// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "core/relief/relief_image.h"

namespace relievo {

/// The bar that explains a relief image's colours, in the lower right corner of a view. Lets the
/// pointer through. [GUI thread]
class ColourBar : public QWidget {
  Q_OBJECT
 public:
  explicit ColourBar(QWidget* parent);
  /// Hides for relief images that need no explanation.
  void show(const ReliefValues& values, const ReliefLook& look);
  void place();  ///< After the parent changed its size.

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ReliefLook look_;
  double low_ = 0, high_ = 1;
  QString title_;
};

}  // namespace relievo
