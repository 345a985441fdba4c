// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/exhibit/exhibit_dialog.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QTabWidget>

#include "core/base/error.h"
#include "ui/dialogs/exhibit/exhibit_fields.h"
#include "ui/dialogs/exhibit/exhibit_objects_page.h"
#include "ui/dialogs/exhibit/exhibit_visit_page.h"
#include "ui/language/core_text.h"
#include "ui/language/error_text.h"
#include "ui/language/language.h"
#include "ui/message/message_text.h"
#include "ui/style/dialog_size.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr int kPlaceRole = Qt::UserRole;
constexpr int kShownFaults = 4;

std::vector<std::string> spokenTags() {
  std::vector<std::string> tags;
  for (const Language& language : languageList()) tags.push_back(language.code.toStdString());
  return tags;
}

/// Where in the file a fault is, "objects[1].title.de": its sentence begins with it.
QString placeOf(const Message& fault) {
  if (fault.arguments.empty()) return {};
  const auto* place = std::get_if<NameArgument>(&fault.arguments.front());
  return place == nullptr ? QString() : QString::fromStdString(place->text);
}

}  // namespace

ExhibitDialog::ExhibitDialog(const Exhibit& begun, QWidget* parent)
    : QDialog(parent),
      pages_(namedField(new QTabWidget, "exhibit_pages", tr("Pages"), QString())),
      objects_(new ExhibitObjectsPage),
      visit_(new ExhibitVisitPage),
      state_(namedField(new QLabel, "exhibit_state", tr("Is it whole?"), QString())),
      problem_(namedField(new QLabel, "exhibit_problem", tr("Problem"), QString())),
      faults_(namedField(new QListWidget, "exhibit_faults", tr("What is wrong"),
                         tr("Enter or a double click goes to the place"))),
      open_(namedButton(tr("Op&en\u2026"), "exhibit_open", tr("Change an exhibit that is there"))),
      save_(namedButton(tr("&Save"), "exhibit_save", tr("Keep the exhibit in its file"))),
      save_as_(namedButton(tr("Sa&ve as\u2026"), "exhibit_save_as",
                           tr("Keep the exhibit in another file"))) {
  setObjectName(QStringLiteral("exhibit_dialog"));
  pages_->addTab(objects_, tr("Obje&cts"));
  pages_->addTab(visit_, tr("V&isit"));
  auto* all = new QVBoxLayout(this);
  all->addWidget(pages_, 1);
  all->addLayout(faultColumn());
  all->addLayout(bottomRow());
  connect(objects_, &ExhibitObjectsPage::changed, this, &ExhibitDialog::noteChange);
  connect(visit_, &ExhibitVisitPage::changed, this, &ExhibitDialog::noteChange);
  setExhibit(begun, {});
  resizeToText(*this, {120, 34});
}

QBoxLayout* ExhibitDialog::faultColumn() {
  constexpr int kFrame = 6;
  state_->setWordWrap(true);
  state_->setTextFormat(Qt::PlainText);
  state_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  problem_->setWordWrap(true);
  problem_->setTextFormat(Qt::PlainText);
  problem_->hide();
  faults_->setWordWrap(true);
  faults_->setFixedHeight(kShownFaults * fontMetrics().lineSpacing() + kFrame);
  connect(faults_, &QListWidget::itemActivated, this,
          [this](const QListWidgetItem* item) { goTo(item->data(kPlaceRole).toString()); });
  auto* column = new QVBoxLayout;
  for (QWidget* one : std::initializer_list<QWidget*>{problem_, state_, faults_}) {
    column->addWidget(one);
  }
  return column;
}

QBoxLayout* ExhibitDialog::bottomRow() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  nameButtons(*buttons);
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  for (QPushButton* one : {open_, save_, save_as_}) {
    buttons->addButton(one, QDialogButtonBox::ActionRole);
  }
  connect(open_, &QPushButton::clicked, this,
          [this] { whenNothingIsUnsaved([this] { chooseFile(); }); });
  connect(save_, &QPushButton::clicked, this, [this] { saveAsked(false); });
  connect(save_as_, &QPushButton::clicked, this, [this] { saveAsked(true); });
  connect(buttons, &QDialogButtonBox::rejected, this, &ExhibitDialog::reject);
  auto* row = new QHBoxLayout;
  row->addWidget(buttons);
  return row;
}

void ExhibitDialog::setExhibit(const Exhibit& exhibit, const QString& file) {
  file_ = file;
  objects_->setLanguages(exhibit.languages);
  objects_->setObjects(exhibit.objects);
  visit_->setExhibit(exhibit);
  is_unsaved_ = false;
  showProblem({});
  check();
}

void ExhibitDialog::openFile(const QString& file) {
  try {
    const ExhibitCheck found = checkExhibit(bytesOfPath(file), spokenTags());
    setExhibit(found.exhibit, file);
    if (found.faults.empty()) return;
    // Saved, it would no longer say what it says now.
    is_unsaved_ = true;
    showProblem(tr("%1 has faults. What they stand at is as it would be if nothing were said: %2")
                    .arg(shownName(file), messageText(found.faults)));
    check();
  } catch (const Error& error) {
    showProblem(shownError(error));
  }
}

bool ExhibitDialog::save(const QString& file) {
  Exhibit made = exhibit();
  made.file = bytesOfPath(file);
  try {
    writeExhibit(made);
  } catch (const Error& error) {
    showProblem(shownError(error));
    return false;
  }
  file_ = file;
  is_unsaved_ = false;
  showProblem({});
  check();
  return true;
}

Exhibit ExhibitDialog::exhibit() const {
  Exhibit made;
  made.file = file_.isEmpty() ? "exhibit.json" : bytesOfPath(file_);
  visit_->fill(made);
  made.objects = objects_->objects();
  return made;
}

void ExhibitDialog::noteChange() {
  is_unsaved_ = true;
  objects_->setLanguages(visit_->languages());
  check();
}

void ExhibitDialog::check() {
  const Exhibit made = exhibit();
  showFaults(checkExhibitText(exhibitText(made), made.file, spokenTags()).faults);
  setWindowTitle(title());
  setWindowModified(is_unsaved_);
}

QString ExhibitDialog::title() const {
  return file_.isEmpty() ? tr("Exhibit[*]") : tr("Exhibit %1[*]").arg(shownName(file_));
}

void ExhibitDialog::showFaults(const std::vector<Message>& faults) {
  faults_->clear();
  for (const Message& fault : faults) {
    auto* item = new QListWidgetItem(messageText(fault), faults_);
    item->setData(kPlaceRole, placeOf(fault));
  }
  faults_->setEnabled(!faults.empty());
  if (!faults.empty()) {
    state_->setText(tr("It cannot be shown yet; this is missing or wrong:"));
  } else if (is_unsaved_ || file_.isEmpty()) {
    state_->setText(tr("It is whole. Once it is saved, it can be shown."));
  } else {
    state_->setText(tr("It is whole. This shows it: %1")
                        .arg(QStringLiteral("relievo --exhibit '%1'").arg(file_)));
  }
}

// "objects[1].title.de", "speech.loudest_percent", as the file names its places.
void ExhibitDialog::goTo(const QString& place) {
  const bool is_object = place.startsWith(QLatin1String("objects"));
  pages_->setCurrentWidget(is_object ? static_cast<QWidget*>(objects_) : visit_);
  if (!is_object) return;
  const QString number = place.section(u'[', 1, 1).section(u']', 0, 0);
  if (!number.isEmpty()) objects_->choose(number.toInt(), place.section(u'.', -1));
}

void ExhibitDialog::chooseFile() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Exhibit"), folderFor(file_), tr("Exhibits (*.json)"));
  if (!file.isEmpty()) openFile(file);
}

void ExhibitDialog::saveAsked(bool elsewhere) {
  QString file = file_;
  if (elsewhere || file.isEmpty()) {
    const QString proposed = file.isEmpty() ? QStringLiteral("exhibit.json") : file;
    file =
        QFileDialog::getSaveFileName(this, tr("Save exhibit"), proposed, tr("Exhibits (*.json)"));
    if (file.isEmpty()) return;
    if (!file.endsWith(QLatin1String(".json"), Qt::CaseInsensitive)) file += QLatin1String(".json");
  }
  save(file);
}

void ExhibitDialog::showProblem(const QString& text) {
  problem_->setText(text);
  problem_->setVisible(!text.isEmpty());
}

void ExhibitDialog::whenNothingIsUnsaved(const std::function<void()>& then) {
  if (!is_unsaved_) {
    then();
    return;
  }
  auto* box = new QMessageBox(QMessageBox::Warning, tr("Unsaved exhibit"),
                              tr("What was changed in the exhibit is in no file yet."),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box->setObjectName(QStringLiteral("exhibit_unsaved"));
  box->setAccessibleName(tr("Unsaved exhibit"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setDefaultButton(QMessageBox::Save);
  box->setEscapeButton(QMessageBox::Cancel);
  nameButtons(*box->findChild<QDialogButtonBox*>());
  connect(box, &QDialog::finished, this, [this, then](int answer) {
    if (answer == QMessageBox::Save) saveAsked(false);
    if (answer == QMessageBox::Discard || (answer == QMessageBox::Save && !is_unsaved_)) then();
  });
  box->open();
}

void ExhibitDialog::reject() {
  whenNothingIsUnsaved([this] { QDialog::reject(); });
}

}  // namespace relievo
