// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QObject>

#include "core/relief/relief_image.h"
#include "ui/views/scene_state.h"
#include "ui/work/latest_worker.h"

namespace relievo {

/// A grid with the colours of a relief image, and what a bar says of them.
struct PaintedGrid {
  std::shared_ptr<const HeldGrid> grid;
  ReliefValues values;
};

/// Paints what a view shows. Most relief images take a few milliseconds; those that look around
/// each sample take from tens of milliseconds to seconds and are made in a worker. [GUI thread]
class GridPainter : public QObject {
  Q_OBJECT
 public:
  explicit GridPainter(QObject* parent = nullptr);

  /// Does this kind of picture look around each sample?
  static bool isSlow(ReliefKind kind);
  /// False: it has no colours to be painted with, and is shown as stone.
  static bool canPaint(const HeldGrid& plain, ReliefKind kind);
  /// @pre canPaint(plain, look.kind) @throw Cancelled [any thread]
  static PaintedGrid paintNow(const HeldGrid& plain, const ReliefLook& look, const Task& task = {});

  /// `painted` follows, unless another start or cancel comes before.
  void start(std::shared_ptr<const HeldGrid> plain, const ReliefLook& look);
  void cancel();
  bool busy() const { return worker_.busy(); }

 Q_SIGNALS:
  void painted(const PaintedGrid& painted);

 private:
  LatestWorker worker_;
};

}  // namespace relievo
