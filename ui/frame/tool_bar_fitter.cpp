// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/tool_bar_fitter.h"

#include <QAction>
#include <QEvent>
#include <QLayout>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <vector>

#include "ui/style/mnemonic.h"

namespace relievo {
namespace {

constexpr const char* kWordless = "wordless";  ///< Property of a button that had words.

}  // namespace

ToolBarFitter::ToolBarFitter(QToolBar& bar) : QObject(&bar), bar_(bar) {
  bar.installEventFilter(this);
}

bool ToolBarFitter::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Resize:
    case QEvent::FontChange:
    case QEvent::StyleChange:
    case QEvent::ActionAdded:
    case QEvent::ActionChanged:
      if (waiting_) break;
      waiting_ = true;
      // Once for many changes, and after the buttons have taken them.
      QTimer::singleShot(0, this, [this] {
        waiting_ = false;
        fit();
      });
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

void ToolBarFitter::fit() {
  std::vector<QToolButton*> worded;
  const QMargins margins = bar_.layout()->contentsMargins();
  int needed = margins.left() + margins.right();
  for (QAction* action : bar_.actions()) {
    QWidget* widget = bar_.widgetForAction(action);
    if (!action->isVisible() || widget == nullptr) continue;
    auto* button = qobject_cast<QToolButton*>(widget);
    const QAction* shown = button != nullptr ? button->defaultAction() : nullptr;
    // Unless it has a short text of its own. Qt takes the & away, and leaves the letter behind.
    if (shown != nullptr && shown->iconText() == QString(shown->text()).remove('&')) {
      button->setText(withoutMnemonic(shown->text()));
    }
    if (button != nullptr && (button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon ||
                              button->property(kWordless).toBool())) {
      button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
      if (!button->icon().isNull()) worded.push_back(button);
    }
    needed += widget->sizeHint().width() + bar_.layout()->spacing();
  }
  const bool wordless = needed > bar_.width();
  for (QToolButton* button : worded) {
    button->setProperty(kWordless, wordless);
    if (wordless) button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  }
}

}  // namespace relievo
