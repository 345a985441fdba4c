// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/figure/figure_form_rows.h"

#include <algorithm>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <utility>

#include "ui/dialogs/figure/figure_form.h"
#include "ui/style/mnemonic.h"

namespace relievo {
namespace {

constexpr int kLeastCharacters = 16;  // That a field shows ...
constexpr int kMostCharacters = 34;   // ... or more, where the screen is wide.

/// Room for the longest layout's name and the end of a path, unless that took it from the preview.
int fieldWidth(const QWidget& of) {
  const int character = of.fontMetrics().averageCharWidth();
  const int quarter = of.screen()->availableSize().width() / 4 / character;
  return std::clamp(quarter, kLeastCharacters, kMostCharacters) * character;
}

/// A letter that is underlined stands farther from its neighbours than a label reckons.
class FieldLabel : public QLabel {
 public:
  FieldLabel(const QString& title, QWidget* field) : QLabel(title) { setBuddy(field); }
  QSize sizeHint() const override { return wider(QLabel::sizeHint()); }
  QSize minimumSizeHint() const override { return wider(QLabel::minimumSizeHint()); }

 private:
  QSize wider(QSize size) const {
    return {size.width() + fontMetrics().averageCharWidth(), size.height()};
  }
};

void describe(QWidget* widget, const QString& name, const char* object_name, const QString& tip) {
  widget->setObjectName(QString::fromLatin1(object_name));
  widget->setAccessibleName(withoutMnemonic(name));
  widget->setToolTip(tip);
}

/// Looks for another file. @param elsewhere  where, while the field is empty
void browse(QLineEdit* field, const FigurePlace& chosen_in, QWidget* parent,
            const QString& elsewhere, const std::function<void()>& changed) {
  const QString near = field->text().isEmpty() ? elsewhere : field->text();
  auto* dialog = new QFileDialog(parent, chosen_in.title, QFileInfo(near).path(), chosen_in.filter);
  dialog->setObjectName(field->objectName() + QLatin1String("_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  if (chosen_in.new_file) {
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setOption(QFileDialog::DontConfirmOverwrite);  // Asked for when it is written.
  } else {
    dialog->setFileMode(QFileDialog::ExistingFile);
  }
  if (!field->text().isEmpty()) dialog->selectFile(field->text());
  QObject::connect(dialog, &QFileDialog::fileSelected, field,
                   [field, changed](const QString& file) {
                     field->setText(file);
                     field->setModified(true);
                     changed();
                   });
  dialog->open();
}

}  // namespace

FigureFormRows::FigureFormRows(QFormLayout* layout, QWidget* dialog, QString near,
                               std::function<void()> changed)
    : layout_(layout), dialog_(dialog), near_(std::move(near)), changed_(std::move(changed)) {}

void FigureFormRows::addBox(QCheckBox* box, const QString& title, const char* name,
                            const QString& tip) {
  describe(box, title, name, tip);
  layout_->addRow(box);
  QObject::connect(box, &QCheckBox::toggled, box, changed_);
}

void FigureFormRows::addRow(QWidget* field, const QString& title, const char* name,
                            const QString& tip) {
  describe(field, title, name, tip);
  field->setMinimumWidth(fieldWidth(*dialog_));
  layout_->addRow(new FieldLabel(title, field), field);
}

QLineEdit* FigureFormRows::place(const QString& title, const char* name, const QString& tip,
                                 const FigurePlace& chosen_in) {
  auto* path = new QLineEdit;
  describe(path, title, name, tip);
  auto* choose = new QPushButton(QStringLiteral("\u2026"));
  describe(choose, FigureForm::tr("Browse: %1").arg(withoutMnemonic(title)),
           (QByteArray(name) + "_browse").constData(), FigureForm::tr("Choose another place"));
  if (!chosen_in.new_file) choose->setToolTip(tip);
  choose->setAutoDefault(false);
  // No wider than its text, which leaves the room to the path.
  choose->setMaximumWidth(6 * dialog_->fontMetrics().averageCharWidth() + 8);
  auto* both = new QWidget;
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(path, 1);
  row->addWidget(choose);
  both->setMinimumWidth(fieldWidth(*dialog_));
  layout_->addRow(new FieldLabel(title, path), both);
  QObject::connect(path, &QLineEdit::editingFinished, path, changed_);
  QObject::connect(choose, &QPushButton::clicked, path,
                   [path, chosen_in, dialog = dialog_, near = near_, changed = changed_] {
                     browse(path, chosen_in, dialog, near, changed);
                   });
  return path;
}

/// Enables a field, or says in its tooltip what keeps it from being of use.
void setUsable(QWidget* widget, bool usable, const QString& why_not) {
  constexpr const char* kTip = "figure_tip";
  if (!widget->property(kTip).isValid()) widget->setProperty(kTip, widget->toolTip());
  const QString tip = widget->property(kTip).toString();
  widget->setEnabled(usable);
  widget->setToolTip(usable ? tip : QStringLiteral("%1. (%2)").arg(tip, why_not));
}

void setPlaceUsable(QLineEdit* path, bool usable, const QString& why_not) {
  setUsable(path, usable, why_not);
  setUsable(path->parentWidget()->findChild<QPushButton*>(), usable, why_not);
}

}  // namespace relievo
