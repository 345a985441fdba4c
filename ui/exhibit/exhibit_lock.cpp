// SPDX-License-Identifier: BSD-3-Clause
#include "ui/exhibit/exhibit_lock.h"

#include <algorithm>
#include <array>
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QStatusBar>
#include <QToolBar>

#include "ui/frame/message_strip.h"
#include "ui/frame/side_panels.h"
#include "ui/frame/start_page.h"
#include "ui/views/detail_view.h"
#include "ui/window/main_window.h"

namespace relievo {
namespace {

constexpr std::array kAllowed{
    "finer",     "coarser",    "whole",        "move_left",    "move_right",     "move_up",
    "move_down", "forces",     "forcesOff",    "whereAmI",     "whereAmILong",   "sayDetail",
    "moveMode",  "moveBack",   "guide",        "next_place",   "previous_place", "beacon",
    "nextShape", "buttonHelp", "repeatSpeech", "louderSpeech", "softerSpeech",   "takeForcesBack"};

/// A hand is moved by them where there is no device.
bool movesTheHand(int key) {
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down ||
         key == Qt::Key_PageUp || key == Qt::Key_PageDown;
}

bool asksToClose(const QKeyEvent& key) {
  return (key.key() == Qt::Key_Q && key.modifiers().testFlag(Qt::ControlModifier)) ||
         (key.key() == Qt::Key_F4 && key.modifiers().testFlag(Qt::AltModifier));
}

}  // namespace

bool ExhibitLock::isAllowed(const QString& command) {
  return std::any_of(kAllowed.begin(), kAllowed.end(),
                     [&](const char* name) { return command == QLatin1String(name); });
}

ExhibitLock::ExhibitLock(MainWindow& window) : window_(window) {
  for (const char* part : {"show_reference", "show_panels", "show_plots", "show_profile"}) {
    if (QAction* shown = window_.commands().named(QString::fromLatin1(part))) {
      shown->setChecked(false);
    }
  }
  hidden_ = {window_.menuBar(), window_.statusBar()};
  for (QToolBar* bar : window_.findChildren<QToolBar*>()) hidden_.emplace_back(bar);
  if (auto* panels = window_.findChild<SidePanels*>()) hidden_.emplace_back(panels);
  if (auto* strip = window_.findChild<MessageStrip*>()) {
    hidden_.emplace_back(strip);
    strip->blockSignals(true);  // Questions and offers are not for visitors, nor for their ears.
  }
  if (auto* start = window_.findChild<StartPage*>()) hidden_.emplace_back(start);
  for (const QPointer<QWidget>& part : hidden_) part->hide();
  window_.setAcceptDrops(false);
  lockActions();
  qApp->installEventFilter(this);
  window_.showFullScreen();
}

ExhibitLock::~ExhibitLock() {
  qApp->removeEventFilter(this);
}

// What cannot be seen cannot be enabled either, whoever enables commands later.
void ExhibitLock::lockActions() {
  QList<QAction*> all = window_.findChildren<QAction*>();
  for (const QMenu* menu : window_.findChildren<QMenu*>()) all << menu->actions();
  for (QAction* action : all) {
    if (!isAllowed(action->objectName())) action->setVisible(false);
  }
}

bool ExhibitLock::isOfDetail(const QObject* watched) const {
  const QWidget& detail = window_.detailView();
  return watched == &detail ||
         (watched->isWidgetType() && detail.isAncestorOf(static_cast<const QWidget*>(watched)));
}

bool ExhibitLock::filterKey(QKeyEvent& key, bool is_override) {
  if (is_override) {
    key.accept();  // No shortcut; it comes back as a key.
    return true;
  }
  if (asksToClose(key)) {
    Q_EMIT closeAsked();
    return true;
  }
  if (key.isAutoRepeat() && !movesTheHand(key.key())) return true;
  const bool goes_on = keys_ && keys_(key);
  return !goes_on || !movesTheHand(key.key());
}

bool ExhibitLock::eventFilter(QObject* watched, QEvent* event) {
  if (lets_close_) return QObject::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::Close:
      if (watched != &window_) break;
      event->ignore();
      Q_EMIT closeAsked();
      return true;
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
      // A window of the screen hands a key on to a widget, which comes here again.
      if (!watched->isWidgetType()) break;
      return filterKey(static_cast<QKeyEvent&>(*event), event->type() == QEvent::ShortcutOverride);
    case QEvent::Shortcut:
    case QEvent::ContextMenu:
    case QEvent::DragEnter:
    case QEvent::Drop:
    case QEvent::WhatsThis:
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::Wheel:
      if (!watched->isWidgetType()) break;
      Q_EMIT stirred();
      if (!isOfDetail(watched)) return true;
      break;
    case QEvent::MouseMove: {
      constexpr int kTremblePixels = 3;
      const QPoint at = static_cast<QMouseEvent&>(*event).globalPos();
      if ((at - pointer_).manhattanLength() > kTremblePixels) {
        pointer_ = at;
        Q_EMIT stirred();
      }
      break;
    }
    case QEvent::Show:
      if (std::find(hidden_.begin(), hidden_.end(), watched) != hidden_.end()) {
        QMetaObject::invokeMethod(watched, "hide", Qt::QueuedConnection);
      }
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace relievo
