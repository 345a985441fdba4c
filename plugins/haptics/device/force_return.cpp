// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/device/force_return.h"

#include <QCoreApplication>
#include <utility>

namespace relievo {

namespace {
QString text(const char* source) {
  return QCoreApplication::translate("relievo::ForceReturn", source);
}
}  // namespace

void ForceReturn::follow(const HapticSample& sample) {
  const bool asked = std::exchange(asked_, parts_.forces_asked);
  const DeviceFault before = std::exchange(fault_, sample.fault);
  if (fault_ == DeviceFault::none && sample.time_ns != 0) was_ready_ = true;
  if (asked && fault_ != DeviceFault::none) is_taken_ = true;
  if (parts_.forces_asked) is_taken_ = false;
  const bool can_push = device_.session()->device().max_force_n > 0;
  if (can_push && is_taken_ && before != DeviceFault::none && fault_ == DeviceFault::none) {
    is_taken_ = false;
    parts_.host.messages.announce(
        text(QT_TRANSLATE_NOOP("relievo::ForceReturn",
                               "The device can push again. Lift the hand and press F5, or hold its "
                               "button Centre: the forces rise from zero.")),
        SaidBecause::noticed);
  }
  const QString now = remedy();
  if (std::exchange(told_, now) == now || now.isEmpty()) return;
  if (device_.isReplaced() && parts_.requested.starts_with("falcon")) return;  // Its plug tells.
  parts_.host.messages.announce(now, SaidBecause::noticed);
}

void ForceReturn::forget() {
  fault_ = DeviceFault::not_ready;
  was_ready_ = asked_ = is_taken_ = false;
  told_.clear();
}

bool ForceReturn::mustOpenAnew() const {
  const LoopSession* const session = device_.session();
  if (session == nullptr || session->foreign() == nullptr) return false;
  if (session->foreign()->isLost() || fault_ == DeviceFault::disconnected) return true;
  return was_ready_ && fault_ != DeviceFault::none && fault_ != DeviceFault::overheated;
}

QString ForceReturn::remedy() const {
  if (mustOpenAnew()) {
    return text(QT_TRANSLATE_NOOP("relievo::ForceReturn",
                                  "Lift the hand and press F5: the device is opened anew, and its "
                                  "forces rise from zero."));
  }
  if (!device_.isReplaced()) return {};
  return text(QT_TRANSLATE_NOOP(
      "relievo::ForceReturn", "Shift+F5 opens the chosen device again and takes its forces back."));
}

}  // namespace relievo
