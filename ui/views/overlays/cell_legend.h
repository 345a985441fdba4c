// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <vector>

#include "core/base/origin.h"
#include "core/relief/stereo.h"

namespace relievo {

/// What the marks of cells that were not measured mean, and how many there are, in the upper right
/// corner of a view while such cells are shown in colour. Lets the pointer through. [GUI thread]
class CellLegend : public QWidget {
  Q_OBJECT
 public:
  explicit CellLegend(QWidget* parent);
  /// @param origins  of the cells in view @param print  how two eyes' pictures are mixed, which
  ///                 changes colours
  void show(const std::vector<CellStatus>& origins, StereoPrint print);
  void place();  ///< After the parent changed its size.

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Row {
    bool hatched = false;  ///< Else in the colour of interpolated cells.
    QString text;
  };
  std::vector<Row> rows_;
  StereoPrint print_ = StereoPrint::off;
};

}  // namespace relievo
