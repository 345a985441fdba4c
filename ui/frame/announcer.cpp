// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/announcer.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QApplication>

namespace relievo {
namespace {

// What comes so close together is one thing for who uses the window; then the screen reader has
// read what it begins with.
constexpr int kAtOnceMs = 500, kCalmMs = 700;

class AccessibleAnnouncer : public QAccessibleWidget {
 public:
  explicit AccessibleAnnouncer(Announcer* announcer)
      : QAccessibleWidget(announcer, QAccessible::Notification) {}
  QString text(QAccessible::Text kind) const override {
    return kind == QAccessible::Name ? static_cast<Announcer*>(widget())->text() : QString();
  }
  /// Screen readers look away from what is not shown.
  QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    state.invisible = false;
    state.offscreen = false;
    return state;
  }
};

QAccessibleInterface* accessibleAnnouncer(const QString& /*name*/, QObject* object) {
  auto* announcer = qobject_cast<Announcer*>(object);
  return announcer == nullptr ? nullptr : new AccessibleAnnouncer(announcer);
}

}  // namespace

Announcer::Announcer(QWidget* parent) : QWidget(parent) {
  static const bool is_known = [] {
    QAccessible::installFactory(accessibleAnnouncer);
    return true;
  }();
  Q_UNUSED(is_known)
  setObjectName(QStringLiteral("announcer"));
  setFocusPolicy(Qt::NoFocus);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
  again_.setSingleShot(true);
  again_.setInterval(kCalmMs);
  connect(&again_, &QTimer::timeout, this, &Announcer::tell);
  connect(qApp, &QApplication::focusChanged, this, &Announcer::onFocus);
}

void Announcer::say(const QString& text) {
  text_ = text;
  again_.stop();
  said_.start();
  tell();
  if (came_back_.isValid() && came_back_.elapsed() < kAtOnceMs) again_.start();
}

/// A dialog that closes gives the keyboard back, and a screen reader begins to read the window
/// over what was said at that moment.
void Announcer::onFocus(const QWidget* before, const QWidget* now) {
  const auto is_here = [this](const QWidget* widget) {
    return widget != nullptr && widget->window() == window();
  };
  if (!is_here(now) || is_here(before)) return;
  came_back_.start();
  if (again_.isActive() || (said_.isValid() && said_.elapsed() < kAtOnceMs)) again_.start();
}

void Announcer::tell() {
  if (text_.isEmpty()) return;
  Q_EMIT told();
  if (!QAccessible::isActive()) return;
  QAccessibleEvent event(this, QAccessible::ObjectShow);
  QAccessible::updateAccessibility(&event);
}

void Announcer::sayAnywhere(const QString& text) {
  for (const QWidget* window : QApplication::topLevelWidgets()) {
    if (auto* announcer = window->findChild<Announcer*>()) return announcer->say(text);
  }
}

}  // namespace relievo
