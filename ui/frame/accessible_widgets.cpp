// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/accessible_widgets.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QAccessibleWidget>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QTextDocument>
#include <QTextDocumentFragment>
#include <QToolButton>

#include "ui/frame/announcer.h"
#include "ui/frame/message_strip.h"
#include "ui/style/mnemonic.h"

namespace relievo {
namespace {

/// "Size: 300 x 200 mm"; either alone where the other is empty or says the same.
QString named(const QString& name, const QString& content) {
  if (content.isEmpty() || content == name) return name;
  return name.isEmpty() ? content : name + QLatin1String(": ") + content;
}

/// A label that was given a name: Qt tells the name alone.
class AccessibleLabel : public QAccessibleWidget {
 public:
  explicit AccessibleLabel(QLabel* label)
      : QAccessibleWidget(label, label->pixmap(Qt::ReturnByValue).isNull() ? QAccessible::StaticText
                                                                           : QAccessible::Graphic) {
  }
  QString text(QAccessible::Text kind) const override {
    if (kind == QAccessible::Name) return named(widget()->accessibleName(), shown());
    const QString more = QAccessibleWidget::text(kind);
    return kind == QAccessible::Description && more == shown() ? QString() : more;
  }
  QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    state.readOnly = true;
    return state;
  }

 private:
  QString shown() const {
    const auto* label = static_cast<QLabel*>(widget());
    const QString text = label->text();
    const bool is_rich = label->textFormat() == Qt::RichText ||
                         (label->textFormat() == Qt::AutoText && Qt::mightBeRichText(text));
    if (is_rich) return QTextDocumentFragment::fromHtml(text).toPlainText();
    return label->buddy() == nullptr ? text : withoutMnemonic(text);
  }
};

/// A list to choose from that cannot be typed into. Qt's has no name but the choice, and readers
/// say the label beside it in its place.
class AccessibleChoice : public QAccessibleWidget {
 public:
  explicit AccessibleChoice(QComboBox* box) : QAccessibleWidget(box, QAccessible::ComboBox) {
    // Readers do not say what is chosen while the list stays closed.
    QObject::connect(box, QOverload<int>::of(&QComboBox::activated), box, [box] {
      if (box->hasFocus()) Announcer::sayAnywhere(box->currentText());
    });
  }
  QString text(QAccessible::Text kind) const override {
    if (kind == QAccessible::Value) return box()->currentText();
    if (kind != QAccessible::Name) return QAccessibleWidget::text(kind);
    return named(ownName(), box()->currentText());
  }
  QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    state.hasPopup = true;
    state.expandable = true;
    return state;
  }
  /// Without a label beside it, which would be said for all of it; the name has its text.
  QVector<QPair<QAccessibleInterface*, QAccessible::Relation>> relations(
      QAccessible::Relation /*match*/) const override {
    return {};
  }
  int childCount() const override { return 0; }
  QAccessibleInterface* child(int /*index*/) const override { return nullptr; }
  int indexOfChild(const QAccessibleInterface* /*child*/) const override { return -1; }
  QStringList actionNames() const override { return {showMenuAction(), setFocusAction()}; }
  void doAction(const QString& action) override {
    if (action == showMenuAction()) {
      box()->showPopup();
    } else {
      QAccessibleWidget::doAction(action);
    }
  }

 private:
  QComboBox* box() const { return static_cast<QComboBox*>(widget()); }
  QString ownName() const {
    if (!box()->accessibleName().isEmpty()) return box()->accessibleName();
    for (const auto& [label, relation] : QAccessibleWidget::relations(QAccessible::Label)) {
      const auto* beside = qobject_cast<QLabel*>(label->object());
      if (beside != nullptr) return withoutMnemonic(beside->text());
    }
    return {};
  }
};

/// The head of a section that folds. Its state says whether it is open, not a description.
class AccessibleSection : public QAccessibleWidget {
 public:
  explicit AccessibleSection(QToolButton* head) : QAccessibleWidget(head, QAccessible::Button) {}
  QString text(QAccessible::Text kind) const override {
    return kind == QAccessible::Description ? QString() : QAccessibleWidget::text(kind);
  }
  QAccessible::State state() const override {
    const bool open = widget()->property(kUnfolded).toBool();
    QAccessible::State state = QAccessibleWidget::state();
    state.expandable = true;
    state.expanded = open;
    state.collapsed = !open;
    return state;
  }
  QStringList actionNames() const override { return {pressAction(), setFocusAction()}; }
  void doAction(const QString& action) override {
    if (action == pressAction()) {
      static_cast<QToolButton*>(widget())->click();
    } else {
      QAccessibleWidget::doAction(action);
    }
  }
};

/// The strip above the views. Its sentence is also announced when it appears.
class AccessibleStrip : public QAccessibleWidget {
 public:
  explicit AccessibleStrip(MessageStrip* strip) : QAccessibleWidget(strip, QAccessible::Grouping) {}
  QString text(QAccessible::Text kind) const override {
    if (kind == QAccessible::Description) return {};
    if (kind != QAccessible::Name) return QAccessibleWidget::text(kind);
    return named(widget()->accessibleName(), widget()->accessibleDescription());
  }
};

/// A widget whose parts are of no use by themselves.
class AccessibleWhole : public QAccessibleWidget {
 public:
  AccessibleWhole(QWidget* widget, QAccessible::Role role) : QAccessibleWidget(widget, role) {}
  int childCount() const override { return 0; }
  QAccessibleInterface* child(int /*index*/) const override { return nullptr; }
  int indexOfChild(const QAccessibleInterface* /*child*/) const override { return -1; }
};

/// A button that Qt makes by itself and gives no name.
class AccessibleButton : public QAccessibleWidget {
 public:
  AccessibleButton(QAbstractButton* button, const QString& name)
      : QAccessibleWidget(button, QAccessible::Button, name) {}
  QStringList actionNames() const override { return {pressAction()}; }
  void doAction(const QString& action) override {
    if (action == pressAction()) static_cast<QAbstractButton*>(widget())->click();
  }
};

/// The name of a button that Qt makes by itself; empty: it is none of these.
QString nameOfQtsOwn(const QString& type, const QObject& button) {
  if (type == QLatin1String("QLineEditIconButton")) {
    return QCoreApplication::translate("AccessibleWidgets", "Clear");
  }
  if (button.objectName() == QLatin1String("qt_toolbar_ext_button")) {
    return QCoreApplication::translate("AccessibleWidgets", "More tools");
  }
  return {};
}

QAccessibleInterface* accessibleWidget(const QString& type, QObject* object) {
  if (auto* head = qobject_cast<QToolButton*>(object);
      head != nullptr && head->property(kUnfolded).isValid()) {
    return new AccessibleSection(head);
  }
  if (auto* button = qobject_cast<QAbstractButton*>(object)) {
    const QString name = nameOfQtsOwn(type, *button);
    return name.isEmpty() ? nullptr : new AccessibleButton(button, name);
  }
  if (auto* box = qobject_cast<QComboBox*>(object); box != nullptr && !box->isEditable()) {
    return new AccessibleChoice(box);
  }
  if (auto* label = qobject_cast<QLabel*>(object);
      label != nullptr && !label->accessibleName().isEmpty()) {
    return new AccessibleLabel(label);
  }
  if (auto* strip = qobject_cast<MessageStrip*>(object)) return new AccessibleStrip(strip);
  auto* const widget = qobject_cast<QWidget*>(object);
  if (widget == nullptr) return nullptr;
  if (type == QLatin1String("QwtPlot")) return new AccessibleWhole(widget, QAccessible::Chart);
  // AT-SPI knows no grips.
  if (type == QLatin1String("QSplitterHandle") || type == QLatin1String("QSizeGrip")) {
    return new AccessibleWhole(widget, QAccessible::Separator);
  }
  return nullptr;
}

}  // namespace

void installAccessibleWidgets() {
  QAccessible::installFactory(accessibleWidget);
}

}  // namespace relievo
