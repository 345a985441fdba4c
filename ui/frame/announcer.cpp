// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/announcer.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QApplication>

namespace relievo {
namespace {

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
}

void Announcer::say(const QString& text) {
  text_ = text;
  if (text.isEmpty() || !QAccessible::isActive()) return;
  QAccessibleEvent event(this, QAccessible::ObjectShow);
  QAccessible::updateAccessibility(&event);
}

void Announcer::sayAnywhere(const QString& text) {
  for (const QWidget* window : QApplication::topLevelWidgets()) {
    if (auto* announcer = window->findChild<Announcer*>()) return announcer->say(text);
  }
}

}  // namespace relievo
