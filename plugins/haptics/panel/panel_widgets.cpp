// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/panel_widgets.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>

namespace relievo {

void setNames(QWidget* widget, const char* object_name, const QString& accessible) {
  widget->setObjectName(QString::fromLatin1(object_name));
  widget->setAccessibleName(accessible);
}

QLabel* readout(const char* object_name, const QString& accessible) {
  auto* label = named(new QLabel(QStringLiteral("–")), object_name, accessible);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

QComboBox* choice(const char* object_name, const QString& accessible, const QStringList& items) {
  auto* box = named(new QComboBox, object_name, accessible);
  box->addItems(items);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  return box;
}

QDoubleSpinBox* numberBox(const NumberBox& what) {
  auto* box = named(new QDoubleSpinBox, what.object_name, what.accessible);
  box->setRange(what.least, what.most);
  box->setSingleStep(what.step);
  box->setDecimals(what.decimals);
  box->setSuffix(what.suffix);
  box->setToolTip(what.tip);
  return box;
}

void addLabelled(QFormLayout* form, const QString& text, QWidget* buddy, QWidget* field) {
  auto* label = new QLabel(text);
  label->setBuddy(buddy);
  form->addRow(label, field);
}

void setTextIfNew(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);
}

}  // namespace relievo
