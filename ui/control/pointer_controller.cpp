// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/pointer_controller.h"

#include <QAction>
#include <utility>

#include "ui/views/detail_view.h"
#include "ui/views/pointer_bindings.h"

namespace relievo {
namespace {

/// Other devices are held in the hand: with them the left button is free to turn the view.
bool isCarriedByPointer(const QString& device) {
  return device.isEmpty() || device == QLatin1String("mouse") ||
         device.startsWith(QLatin1String("virtual"));
}

}  // namespace

PointerController::PointerController(const ControllerParts& parts, DetailView& detail)
    : Controller(parts), detail_(detail), feel_(detail) {
  commands_.on(Command::pointer_feel, this, [this] { feel(!feel_.isOn()); });
  commands_.on(Command::pointer_look, this, [this] { choose(PointerMode::look); });
  commands_.on(Command::pointer_touch, this, [this] { choose(PointerMode::touch); });
  commands_.on(Command::pointer_switch, this, [this] {
    const bool looks = detail_.pointerMode() == PointerMode::look;
    choose(looks ? PointerMode::touch : PointerMode::look);
    announce(bindingsText(detail_.pointerMode(), bindings()));
  });
  connect(&document_, &Document::surfaceChanged, this, &PointerController::showBindings);
}

void PointerController::feel(bool on) {
  feel_.setOn(on);
  commands_[Command::pointer_feel].setChecked(on);
  announce(on ? tr("The mouse feels the surface; Escape ends it")
              : tr("The mouse no longer feels the surface"));
}

bool PointerController::stopFeeling() {
  if (!feel_.isOn()) return false;
  feel(false);
  return true;
}

void PointerController::showKeptMode() {
  const QString kept = settings_.choice(QStringLiteral("pointer_mode"), QString()).toString();
  looks_after_forces_ = false;
  show(kept == QLatin1String("touch") ? PointerMode::touch : PointerMode::look);
}

void PointerController::follow(const TouchReadout& readout) {
  device_ = readout.device;
  touchWhileForcesAreOn(readout.forces_on);
}

PointerBindings PointerController::bindings() const {
  const auto chosen = [this](const char* key, PointerAct fallback) {
    const QString kept = settings_.choice(QString::fromLatin1(key), QString()).toString();
    return pointerAct(kept, fallback);
  };
  PointerBindings made;
  made.look_left = chosen("look_left", made.look_left);
  made.look_middle = chosen("look_middle", made.look_middle);
  made.look_right = chosen("look_right", made.look_right);
  made.touch_middle = chosen("touch_middle", made.touch_middle);
  made.touch_right = chosen("touch_right", made.touch_right);
  made.forward_is_closer = settings_.choice(QStringLiteral("wheel_forward"), true).toBool();
  return made;
}

void PointerController::choose(PointerMode mode) {
  looks_after_forces_ = false;
  settings_.setChoice(QStringLiteral("pointer_mode"), mode == PointerMode::touch
                                                          ? QStringLiteral("touch")
                                                          : QStringLiteral("look"));
  show(mode);
}

void PointerController::show(PointerMode mode) {
  detail_.setPointerMode(mode);
  const bool touches = mode == PointerMode::touch;
  commands_[touches ? Command::pointer_touch : Command::pointer_look].setChecked(true);
  showBindings();
}

void PointerController::showBindings() {
  const PointerBindings now = bindings();
  detail_.setBindings(now);
  for (const auto& [command, mode] : {std::pair{Command::pointer_look, PointerMode::look},
                                      std::pair{Command::pointer_touch, PointerMode::touch}}) {
    const QString told = bindingsText(mode, now);
    commands_[command].setToolTip(told);
    commands_[command].setStatusTip(told);
    commands_[command].setWhatsThis(told);
  }
  messages_.set(StatusField::pointer,
                document_.isOpen() ? bindingsText(detail_.pointerMode(), now) : QString(),
                tr("What the mouse does in the detail view; F7 changes between look and touch, "
                   "Preferences choose the buttons"));
}

// Whoever switches forces on with the mouse as the hand wants to press; after that the left button
// does again what it did before.
void PointerController::touchWhileForcesAreOn(bool on) {
  if (std::exchange(forces_were_on_, on) == on) return;
  if (on) {
    if (detail_.pointerMode() == PointerMode::touch || !isCarriedByPointer(device_)) return;
    looks_after_forces_ = true;
    show(PointerMode::touch);
  } else if (std::exchange(looks_after_forces_, false)) {
    show(PointerMode::look);
  }
}

}  // namespace relievo
