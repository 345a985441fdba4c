// SPDX-License-Identifier: BSD-3-Clause
#include "ui/style/input_event_filter.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QScrollBar>
#include <QWidget>

namespace relievo {
namespace {

/// A field whose value the wheel would change; scroll bars are for the wheel.
QWidget* turnable(QObject* watched) {
  if (qobject_cast<QScrollBar*>(watched) != nullptr) return nullptr;
  const bool is = qobject_cast<QComboBox*>(watched) != nullptr ||
                  qobject_cast<QAbstractSpinBox*>(watched) != nullptr ||
                  qobject_cast<QAbstractSlider*>(watched) != nullptr;
  return is ? static_cast<QWidget*>(watched) : nullptr;
}

bool isCtrlE(const QEvent& event) {
  const auto& key = static_cast<const QKeyEvent&>(event);
  return key.key() == Qt::Key_E && key.modifiers() == Qt::ControlModifier;
}

}  // namespace

InputEventFilter::InputEventFilter(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool InputEventFilter::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Polish:
      // With Qt's own policy the wheel would bring the keyboard along, and then turn.
      if (QWidget* const field = turnable(watched)) {
        if (field->focusPolicy() == Qt::WheelFocus) field->setFocusPolicy(Qt::StrongFocus);
      }
      break;
    case QEvent::Wheel:
      if (QWidget* const field = turnable(watched)) {
        if (field->hasFocus()) break;
        event->ignore();  // Whatever scrolls around it takes it.
        return true;
      }
      break;
    case QEvent::ShortcutOverride:
      if (watched->isWidgetType() && isCtrlE(*event)) {
        event->ignore();
        return true;
      }
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace relievo
