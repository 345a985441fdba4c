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
  auto* modes = new QActionGroup(this);
  QAction* look = make({"pointer_look",
                        tr("Loo&k with the left button"),
                        {},
                        tr("Dragging with the left button turns the detail view"),
                        [this] { choosePointerMode(PointerMode::look); },
                        Icon::look,
                        true});
  QAction* touch = make({"pointer_touch",
                         tr("&Touch with the left button"),
                         {},
                         tr("The left button presses the hand into the surface"),
                         [this] { choosePointerMode(PointerMode::touch); },
                         Icon::touch,
                         true});
  for (QAction* mode : {look, touch}) modes->addAction(mode);
  look->setIconText(tr("Look"));
  touch->setIconText(tr("Touch"));
  make({"pointer_switch",
        tr("&Switch between look and touch"),
        {QKeySequence("F7")},
        tr("What the left button does in the detail view: turn it, or press the hand in"),
        [this] {
          const bool looks = detail_->pointerMode() == PointerMode::look;
          choosePointerMode(looks ? PointerMode::touch : PointerMode::look);
          announce(bindingsText(detail_->pointerMode(), pointerBindings()));
        },
        {}});
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
  command(mode == PointerMode::touch ? "pointer_touch" : "pointer_look")->setChecked(true);
  showBindings();
}

void MainWindow::showBindings() {
  const PointerBindings bindings = pointerBindings();
  detail_->setBindings(bindings);
  for (const auto& [name, mode] : {std::pair("pointer_look", PointerMode::look),
                                   std::pair("pointer_touch", PointerMode::touch)}) {
    const QString told = bindingsText(mode, bindings);
    command(name)->setToolTip(told);
    command(name)->setStatusTip(told);
    command(name)->setWhatsThis(told);
  }
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
