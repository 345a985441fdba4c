// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/coarse_pictures.h"

namespace relievo {
namespace {
constexpr qint64 kSlowMs = 40;    // 25 pictures a second.
constexpr qint64 kPauseMs = 500;  // Between the steps of two drags.
constexpr int kRestMs = 250;
}  // namespace

CoarsePictures::CoarsePictures(QObject* parent) : QObject(parent) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, &CoarsePictures::over);
}

// A pointer that is slower than the pictures is shown whole ones, however long it waits between two
// places.
void CoarsePictures::stepDrawn(bool more) {
  const qint64 took_ms = since_step_.isValid() ? since_step_.elapsed() : 0;
  since_step_.start();
  const bool slow = took_ms > kSlowMs && took_ms < kPauseMs;
  if (more && (on() || slow)) rest_.start();
}

}  // namespace relievo
