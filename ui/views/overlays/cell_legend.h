// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <vector>

#include "core/base/origin.h"
#include "core/relief/stereo.h"

class QPainter;

namespace relievo {

/// What marks in a view mean, in its upper right corner: those of cells that were not measured, and
/// how many there are, while such cells are shown in colour; those of hand and proxy, while they
/// are told apart by shape. Lets the pointer through. [GUI thread]
class CellLegend : public QWidget {
  Q_OBJECT
 public:
  explicit CellLegend(QWidget* parent);
  /// @param origins  of the cells in view; null: their marks are not shown
  /// @param hand     hand and proxy are drawn by their shapes
  /// @param print    how two eyes' pictures are mixed, which changes colours
  void show(const std::vector<CellStatus>* origins, bool hand, StereoPrint print);
  void place();  ///< After the parent changed its size.

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  enum class Sign { none, interpolated, hole, proxy, hip };
  struct Row {
    Sign sign = Sign::none;
    QString text;
  };
  void addCells(const std::vector<CellStatus>& origins);
  void paintSign(QPainter& painter, Sign sign, const QRect& place) const;

  std::vector<Row> rows_;
  StereoPrint print_ = StereoPrint::off;
};

}  // namespace relievo
