// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/overlays/grid_painter.h"

#include <tuple>
#include <utility>

#include "core/base/error.h"

namespace relievo {

GridPainter::GridPainter(QObject* parent) : QObject(parent) {}

bool GridPainter::isSlow(ReliefKind kind) {
  return hasRadius(kind);
}

bool GridPainter::canPaint(const HeldGrid& plain, ReliefKind kind) {
  if (kind == ReliefKind::natural) return !plain.own.colours.empty();
  if (kind == ReliefKind::intensity) return !plain.own.intensities.empty();
  return kind != ReliefKind::lit;
}

PaintedGrid GridPainter::paintNow(const HeldGrid& plain, const ReliefLook& look, const Task& task) {
  auto grid = std::make_shared<HeldGrid>(plain);
  const DepthMap map{plain.frame, plain.heights_mm, plain.origins};
  ReliefValues values = reliefValues(map, look, task);
  if (!look.range && hasLegend(look.kind)) {
    std::tie(values.low, values.high) = roundEnds(values.low, values.high);
  }
  grid->colours = reliefColours(values, look, plain.own);
  grid->lit = isLit(look.kind);
  return {std::move(grid), std::move(values)};
}

void GridPainter::start(std::shared_ptr<const HeldGrid> plain, const ReliefLook& look) {
  const auto made = std::make_shared<PaintedGrid>();
  worker_.start(
      [plain = std::move(plain), look, made](const Task& task) {
        try {
          *made = paintNow(*plain, look, task);
        } catch (const Cancelled&) {  // Somebody wants another one; this one's end is not told.
        }
      },
      [this, made] { Q_EMIT painted(*made); });
}

void GridPainter::cancel() {
  worker_.cancel();
}

}  // namespace relievo
