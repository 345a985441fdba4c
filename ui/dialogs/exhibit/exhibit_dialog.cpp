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
#include "ui/dialogs/exhibit/exhibit_objects_page.h"
#include "ui/dialogs/exhibit/exhibit_visit_page.h"
#include "ui/dialogs/exhibit/objects_check.h"
#include "ui/dialogs/named_fields.h"
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

// Places as the file names them: "objects", "objects[1].title.de", "speech.loudest_percent".
bool isOfObjects(const QString& place) {
  return place.startsWith(QLatin1String("objects"));
}
/// Which object, from 0; -1: none.
int objectOf(const QString& place) {
  bool is_number = false;
  const int number = place.section(u'[', 1, 1).section(u']', 0, 0).toInt(&is_number);
  return isOfObjects(place) && is_number ? number : -1;
}
/// "title.de" of "objects[1].title.de".
QString partOf(const QString& place) {
  return place.section(u'.', 1);
}

/// Where in the file a fault is: its sentence begins with it.
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
      looks_(new ObjectsCheck(this)),
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
  connect(looks_, &ObjectsCheck::looked, this, &ExhibitDialog::check);
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
  looks_->look(made.objects);
  showFaults(checkExhibitText(exhibitText(made), made.file, spokenTags()).faults);
  showRefusals(made.objects);
  showState();
  setWindowTitle(title());
  setWindowModified(is_unsaved_);
}

QString ExhibitDialog::title() const {
  return file_.isEmpty() ? tr("Exhibit[*]") : tr("Exhibit %1[*]").arg(shownName(file_));
}

void ExhibitDialog::showFaults(const std::vector<Message>& faults) {
  faults_->clear();
  for (const Message& fault : faults) {
    auto* item = new QListWidgetItem(messageText(inFields(fault)), faults_);
    item->setData(kPlaceRole, placeOf(fault));
  }
}

/// Behind the faults of the file itself.
void ExhibitDialog::showRefusals(const std::vector<ExhibitObject>& objects) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::optional<Message> refusal = looks_->refusalOf(objects[i].file);
    if (!refusal) continue;
    auto* item = new QListWidgetItem(messageText(*refusal), faults_);
    item->setData(kPlaceRole, QStringLiteral("objects[%1].file").arg(i));
  }
}

void ExhibitDialog::showState() {
  faults_->setEnabled(faults_->count() > 0);
  if (faults_->count() > 0) {
    state_->setText(tr("It cannot be shown yet; this is missing or wrong:"));
  } else if (looks_->busy()) {
    state_->setText(
        tr("Nothing is missing. The objects are being opened to see whether they can be."));
  } else if (is_unsaved_ || file_.isEmpty()) {
    state_->setText(tr("It is whole. Once it is saved, it can be shown."));
  } else {
    state_->setText(tr("It is whole. This shows it: %1")
                        .arg(QStringLiteral("relievo --exhibit '%1'").arg(file_)));
  }
}

QWidget* ExhibitDialog::fieldOf(const QString& place) const {
  return isOfObjects(place) ? objects_->fieldOf(partOf(place)) : visit_->fieldOf(place);
}

/// The sentence with the names of fields where it has places of the file.
Message ExhibitDialog::inFields(Message fault) const {
  for (MessageArgument& argument : fault.arguments) {
    auto* const name = std::get_if<NameArgument>(&argument);
    if (name == nullptr) continue;
    const QString place = QString::fromStdString(name->text);
    const QWidget* const field = fieldOf(place);
    if (field == nullptr) continue;
    const int object = objectOf(place);
    const QString words = field->accessibleName();
    name->text =
        (object < 0 ? words : tr("Object %1: %2").arg(object + 1).arg(words)).toStdString();
  }
  return fault;
}

void ExhibitDialog::goTo(const QString& place) {
  const bool is_object = isOfObjects(place);
  pages_->setCurrentWidget(is_object ? static_cast<QWidget*>(objects_) : visit_);
  if (const int object = objectOf(place); object >= 0) objects_->choose(object, partOf(place));
  if (QWidget* const field = fieldOf(place)) field->setFocus(Qt::OtherFocusReason);
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

void ExhibitDialog::done(int result) {
  looks_->worker().outliveJob(*this);
  QDialog::done(result);
}

}  // namespace relievo
