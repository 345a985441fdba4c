// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/scheduling/coarse_pictures.h"

#include <algorithm>

namespace relievo {
namespace {
constexpr qint64 kSlowMs = 40;  // 25 pictures a second.
constexpr qint64 kSteps = 3;    // Without one for as long as so many took, nobody drags.
constexpr qint64 kRestMs = 250, kLongestRestMs = 3000;
}  // namespace

CoarsePictures::CoarsePictures(QObject* parent) : QObject(parent) {
  rest_.setSingleShot(true);
  connect(&rest_, &QTimer::timeout, this, &CoarsePictures::over);
}

// A pointer that is slower than the pictures is shown whole ones.
void CoarsePictures::stepDrawn(qint64 took_ms, bool more) {
  if (!more || (!on() && took_ms <= kSlowMs)) return;
  // Coarse pictures that take long themselves are followed by more of them.
  rest_.start(static_cast<int>(std::clamp<qint64>(kSteps * took_ms, kRestMs, kLongestRestMs)));
}

}  // namespace relievo
