// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/path_preview.h"

namespace relievo {

PathPreview::PathPreview(QObject* parent) : QObject(parent) {
  constexpr int kFrameMs = 33;
  timer_.setInterval(kFrameMs);
  connect(&timer_, &QTimer::timeout, this, [this] {
    const double t = path_.startS() + 1e-9 * static_cast<double>(clock_.nsecsElapsed());
    Q_EMIT viewChanged(viewAt(path_, ladder_, t));
    if (t >= path_.endS()) stop();
  });
}

void PathPreview::play(const CameraPath& path, const DetailLadder& ladder) {
  check(path);
  stop();
  path_ = path;
  ladder_ = ladder;
  clock_.start();
  timer_.start();
  Q_EMIT viewChanged(viewAt(path_, ladder_, path_.startS()));
}

void PathPreview::stop() {
  if (!playing()) return;
  timer_.stop();
  Q_EMIT ended();
}

}  // namespace relievo
