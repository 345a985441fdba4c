// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <QWidget>

#include "core/relief/relief_image.h"
#include "core/relief/stereo.h"

namespace relievo {

/// The bar that explains a relief image's colours, in the lower right corner of a view. Lets the
/// pointer through. [GUI thread]
class ColourBar : public QWidget {
  Q_OBJECT
 public:
  explicit ColourBar(QWidget* parent);
  /// Hides for relief images that need no explanation.
  void show(const ReliefValues& values, const ReliefLook& look);
  void leave();  ///< There is nothing to explain.
  /// How two eyes' pictures are mixed: a grey anaglyph has grey colours, and so has its bar.
  void setPrint(StereoPrint print);
  /// The colour that stands for a share of the way from the low end to the high one.
  std::array<std::uint8_t, 3> colourAt(double share) const;
  void place();  ///< After the parent changed its size.

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString endText(double value) const;

  ReliefLook look_;
  StereoPrint print_ = StereoPrint::off;
  double low_ = 0, high_ = 1;
  bool wanted_ = false;
  QString title_;
};

}  // namespace relievo
