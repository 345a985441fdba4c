// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/study_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>

#include "ui/language/core_text.h"
#include "ui/style/dialog_size.h"

namespace relievo {
namespace {

QLineEdit* lineOf(const QString& name, const QString& title, const QString& tip) {
  auto* line = new QLineEdit;
  line->setObjectName(name);
  line->setAccessibleName(title);
  line->setToolTip(tip);
  return line;
}

}  // namespace

StudyDialog::StudyDialog(const QStringList& places, const QString& folder, QWidget* parent)
    : QDialog(parent),
      participant_(lineOf(QStringLiteral("study_participant"), tr("Participant code"),
                          tr("Letters, digits, - and _; no name. Who has which code is kept "
                             "elsewhere"))),
      consent_(lineOf(QStringLiteral("study_consent"), tr("Note on the consent"),
                      tr("What was agreed to, when and how, as: form 3, signed 24 November"))),
      folder_(lineOf(QStringLiteral("study_folder"), tr("Folder of the study"),
                     tr("Each participant gets a folder in it, and each sitting one in that"))),
      agreed_(new QCheckBox(tr("The participant has a&greed"))),
      places_(new QListWidget),
      repetitions_(new QSpinBox),
      missing_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  setObjectName(QStringLiteral("study_dialog"));
  setWindowTitle(tr("Sitting of a study"));
  agreed_->setObjectName(QStringLiteral("study_agreed"));
  agreed_->setToolTip(tr("To be asked before every sitting"));
  places_->setObjectName(QStringLiteral("study_conditions"));
  places_->setAccessibleName(tr("Conditions"));
  places_->setToolTip(
      tr("Bookmarks, each with its resolution and exaggeration. They are shown "
         "in random order, under letters"));
  for (const QString& place : places) {
    auto* item = new QListWidgetItem(place, places_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
  }
  repetitions_->setObjectName(QStringLiteral("study_repetitions"));
  repetitions_->setAccessibleName(tr("How often each condition is shown"));
  repetitions_->setToolTip(tr("All once in random order, then all again in another one"));
  repetitions_->setRange(1, 100);
  folder_->setText(folder);
  missing_->setObjectName(QStringLiteral("study_missing"));
  missing_->setWordWrap(true);
  nameButtons(*buttons_);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("&Begin"));
  auto* browse = new QPushButton(tr("B&rowse\u2026"));
  browse->setAccessibleName(tr("Browse"));
  browse->setToolTip(tr("Choose another place"));
  connect(browse, &QPushButton::clicked, this, [this] {
    const QString other =
        QFileDialog::getExistingDirectory(this, tr("Folder of the study"), folder_->text());
    if (!other.isEmpty()) folder_->setText(other);
  });
  auto* place = new QHBoxLayout;
  place->addWidget(folder_, 1);
  place->addWidget(browse);
  auto* layout = new QFormLayout(this);
  layout->addRow(tr("&Participant code"), participant_);
  layout->addRow(QString(), agreed_);
  layout->addRow(tr("&Note on the consent"), consent_);
  layout->addRow(tr("&Conditions"), places_);
  layout->addRow(tr("&Each shown"), repetitions_);
  auto* folder_label = new QLabel(tr("&Folder of the study"));
  folder_label->setBuddy(folder_);
  layout->addRow(folder_label, place);
  layout->addRow(missing_);
  layout->addRow(buttons_);
  for (QLineEdit* line : {participant_, consent_, folder_}) {
    connect(line, &QLineEdit::textChanged, this, &StudyDialog::showMissing);
  }
  connect(agreed_, &QCheckBox::toggled, this, &StudyDialog::showMissing);
  connect(places_, &QListWidget::itemChanged, this, &StudyDialog::showMissing);
  connect(buttons_, &QDialogButtonBox::accepted, this, [this] {
    accept();
    Q_EMIT chosen(study(), this->folder());
  });
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  showMissing();
  resizeToText(*this, {60, 26});
}

QStringList StudyDialog::conditions() const {
  QStringList names;
  for (int i = 0; i < places_->count(); ++i) {
    if (places_->item(i)->checkState() == Qt::Checked) names << places_->item(i)->text();
  }
  return names;
}

QString StudyDialog::missing() const {
  if (places_->count() < 2) {
    return tr("A study needs at least two bookmarks: Surface > Add bookmark.");
  }
  if (!isParticipantCode(participant_->text().toStdString())) {
    return tr("The code has 1 to 32 letters, digits, - and _.");
  }
  if (!agreed_->isChecked()) return tr("Nothing begins before the participant has agreed.");
  if (consent_->text().trimmed().isEmpty()) return tr("Note what was agreed to.");
  if (conditions().size() < 2) return tr("Choose at least two conditions.");
  if (conditions().size() > 26) return tr("Choose at most 26 conditions: they have letters.");
  if (folder_->text().isEmpty()) return tr("Choose a folder.");
  return {};
}

void StudyDialog::showMissing() {
  const QString words = missing();
  missing_->setText(words);
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(words.isEmpty());
}

Study StudyDialog::study() const {
  Study made{.participant = participant_->text().toStdString(),
             .consent = consent_->text().trimmed().toStdString(),
             .conditions = {},
             .repetitions = repetitions_->value()};
  for (const QString& name : conditions()) made.conditions.push_back(name.toStdString());
  return made;
}

QString StudyDialog::folder() const {
  return folder_->text();
}

}  // namespace relievo
