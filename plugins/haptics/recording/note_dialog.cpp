// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/recording/note_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace relievo {

namespace {
constexpr int kMostBytes = 200;  // What an event of an HDF5 file can hold, whatever the tick.

QPushButton* button(QDialogButtonBox& box, QDialogButtonBox::ButtonRole role, const QString& text,
                    const QString& name, const QString& tip) {
  auto* made = box.addButton(text, role);
  made->setAccessibleName(name);
  made->setToolTip(tip);
  return made;
}
}  // namespace

NoteDialog::NoteDialog(std::uint64_t tick, double time_s, QWidget* parent)
    : QDialog(parent), tick_(tick), time_s_(time_s), text_(new QLineEdit) {
  setObjectName(QStringLiteral("note_dialog"));
  setWindowTitle(tr("Note"));
  auto* label =
      new QLabel(tr("&Note at %1 s of the recording").arg(QLocale().toString(time_s, 'f', 2)));
  label->setBuddy(text_);
  text_->setObjectName(QStringLiteral("note_text"));
  text_->setAccessibleName(tr("Note"));
  text_->setAccessibleDescription(
      tr("At %1 s of the recording").arg(QLocale().toString(time_s, 'f', 2)));
  text_->setToolTip(tr("What was seen or felt, in a few words"));
  constexpr int kCharactersSeen = 40;
  text_->setMinimumWidth(kCharactersSeen * text_->fontMetrics().averageCharWidth());
  connect(text_, &QLineEdit::textChanged, this, [this](QString text) {
    if (text.toUtf8().size() <= kMostBytes) return;
    while (text.toUtf8().size() > kMostBytes) text.chop(1);
    text_->setText(text);
  });
  auto* buttons = new QDialogButtonBox;
  auto* add = button(*buttons, QDialogButtonBox::AcceptRole, tr("&Add"), tr("Add"),
                     tr("Write the note into the recording"));
  add->setObjectName(QStringLiteral("note_add"));
  add->setDefault(true);
  button(*buttons, QDialogButtonBox::RejectRole, tr("&Cancel"), tr("Cancel"),
         tr("Close without a note"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(label);
  column->addWidget(text_);
  column->addWidget(buttons);
}

QString NoteDialog::text() const {
  return text_->text().simplified();
}

}  // namespace relievo
