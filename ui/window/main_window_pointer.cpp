// SPDX-License-Identifier: BSD-3-Clause
// Look or touch: what the buttons of the mouse do in the detail view.
#include <QAction>
#include <QActionGroup>
#include <utility>

#include "ui/frame/status_fields.h"
#include "ui/views/detail_view.h"
#include "ui/views/pointer_bindings.h"
#include "ui/window/main_window.h"

namespace relievo {
namespace {

/// Other devices are held in the hand: with them the left button is free to turn the view.
bool isCarriedByPointer(const QString& device) {
  return device.isEmpty() || device == QLatin1String("mouse") ||
         device.startsWith(QLatin1String("virtual"));
}

}  // namespace

void MainWindow::makePointerCommands() {
  commands_.on(Command::pointer_look, this, [this] { choosePointerMode(PointerMode::look); });
  commands_.on(Command::pointer_touch, this, [this] { choosePointerMode(PointerMode::touch); });
  commands_.on(Command::pointer_switch, this, [this] {
    const bool looks = detail_->pointerMode() == PointerMode::look;
    choosePointerMode(looks ? PointerMode::touch : PointerMode::look);
    announce(bindingsText(detail_->pointerMode(), pointerBindings()));
  });
}

PointerBindings MainWindow::pointerBindings() const {
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

void MainWindow::choosePointerMode(PointerMode mode) {
  looks_after_forces_ = false;
  settings_.setChoice(QStringLiteral("pointer_mode"), mode == PointerMode::touch
                                                          ? QStringLiteral("touch")
                                                          : QStringLiteral("look"));
  showPointerMode(mode);
}

void MainWindow::showPointerMode(PointerMode mode) {
  detail_->setPointerMode(mode);
  const bool touches = mode == PointerMode::touch;
  commands_[touches ? Command::pointer_touch : Command::pointer_look].setChecked(true);
  showBindings();
}

void MainWindow::showBindings() {
  const PointerBindings bindings = pointerBindings();
  detail_->setBindings(bindings);
  status_->set(StatusField::pointer,
               document_.isOpen() ? bindingsText(detail_->pointerMode(), bindings) : QString(),
               tr("What the mouse does in the detail view; F7 changes between look and touch, "
                  "Preferences choose the buttons"));
}

// Whoever switches forces on with the mouse as the hand wants to press; after that the left button
// does again what it did before.
void MainWindow::touchWhileForcesAreOn(bool on) {
  if (std::exchange(forces_were_on_, on) == on) return;
  if (on) {
    if (detail_->pointerMode() == PointerMode::touch || !isCarriedByPointer(touch_.device)) return;
    looks_after_forces_ = true;
    showPointerMode(PointerMode::touch);
  } else if (std::exchange(looks_after_forces_, false)) {
    showPointerMode(PointerMode::look);
  }
}

}  // namespace relievo
