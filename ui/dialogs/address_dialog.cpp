// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/address_dialog.h"

#include <QCompleter>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/language/core_text.h"
#include "ui/work/file_names.h"

namespace relievo {

AddressDialog::AddressDialog(const QString& begun, const QStringList& known, QWidget* parent)
    : QDialog(parent),
      line_(new QLineEdit(begun)),
      missing_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel)) {
  setObjectName(QStringLiteral("address_dialog"));
  setWindowTitle(tr("Open web address"));
  auto* title = new QLabel(tr("&Address of a published map"));
  title->setBuddy(line_);
  line_->setObjectName(QStringLiteral("address_line"));
  line_->setAccessibleName(tr("Address of a published map"));
  line_->setToolTip(tr("Of the folder that relievo publish made, or of its map.json"));
  line_->setPlaceholderText(QStringLiteral("https://"));
  line_->setMinimumWidth(42 * fontMetrics().averageCharWidth());
  line_->setCompleter(new QCompleter(known, line_));
  line_->selectAll();
  missing_->setObjectName(QStringLiteral("address_missing"));
  missing_->setWordWrap(true);
  nameButtons(*buttons_);
  auto* column = new QVBoxLayout(this);
  column->addWidget(title);
  column->addWidget(line_);
  column->addWidget(missing_);
  column->addWidget(buttons_);
  connect(line_, &QLineEdit::textChanged, this, &AddressDialog::showMissing);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons_, &QDialogButtonBox::accepted, this, [this] {
    accept();
    Q_EMIT chosen(address());
  });
  showMissing();
}

QString AddressDialog::address() const {
  return line_->text().trimmed();
}

void AddressDialog::showMissing() {
  const bool is_one = isAddress(address());
  missing_->setText(is_one ? tr("The server is asked when you open it.")
                           : tr("An address begins with https://, http:// or s3://."));
  line_->setAccessibleDescription(missing_->text());
  buttons_->button(QDialogButtonBox::Open)->setEnabled(is_one);
}

}  // namespace relievo
