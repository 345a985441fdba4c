// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/exhibit/exhibit_objects_page.h"

#include <algorithm>
#include <QBoxLayout>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTabWidget>

#include "ui/dialogs/named_fields.h"
#include "ui/dialogs/scan_choices.h"
#include "ui/language/language.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

QString wordsOf(const ExhibitTexts& texts, const std::string& tag) {
  const auto text = texts.find(tag);
  return text == texts.end() ? QString() : QString::fromStdString(text->second);
}

/// No entry stands for nothing.
void keep(ExhibitTexts& texts, const std::string& tag, const QString& words) {
  if (words.trimmed().isEmpty()) {
    texts.erase(tag);
  } else {
    texts[tag] = words.toStdString();
  }
}

}  // namespace

ExhibitObjectsPage::ExhibitObjectsPage(QWidget* parent)
    : QWidget(parent),
      list_(namedField(new QListWidget, "exhibit_objects", tr("Objects"),
                       tr("What visitors are offered, in this order"))),
      add_(namedButton(tr("&Add\u2026"), "exhibit_add",
                       tr("Take scans, height maps or projects into the list"))),
      remove_(namedButton(tr("&Remove"), "exhibit_remove", tr("Take the object out of the list"))),
      up_(namedButton(tr("U&p"), "exhibit_up", tr("Offer the object earlier"))),
      down_(namedButton(tr("Dow&n"), "exhibit_down", tr("Offer the object later"))),
      file_(namedField(new QLineEdit, "exhibit_file", tr("File"),
                       tr("A scan, a height map or a project"))),
      browse_(namedButton(tr("&Browse\u2026"), "exhibit_browse", tr("Choose another file"))),
      unit_(namedField(new QComboBox, "exhibit_unit", tr("Unit of the file"),
                       tr("Length unit of the file's coordinates"))),
      view_(namedField(new QComboBox, "exhibit_view", tr("View"),
                       tr("From which side the object is touched"))),
      texts_(namedField(new QTabWidget, "exhibit_texts", tr("Texts"),
                        tr("What is said and shown, in each language"))) {
  makeTexts();
  auto* all = new QHBoxLayout(this);
  all->addLayout(listColumn(), 2);
  form_ = objectForm();
  all->addWidget(form_, 5);
  showChosen();
}

void ExhibitObjectsPage::makeTexts() {
  constexpr int kLines = 4;
  for (const Language& language : languageList()) {
    const QByteArray tag = language.code.toLatin1();
    auto* page = new QWidget;
    auto* title = namedField(new QLineEdit, ("exhibit_title_" + tag).constData(),
                             tr("Title, %1").arg(language.name),
                             tr("At most %1 words, spoken and shown").arg(kMostTitleWords));
    auto* description =
        namedField(new QPlainTextEdit, ("exhibit_description_" + tag).constData(),
                   tr("Description, %1").arg(language.name),
                   tr("At most %1 words, spoken after the title; in every language or in none")
                       .arg(kMostDescriptionWords));
    description->setTabChangesFocus(true);
    description->setMinimumHeight(kLines * fontMetrics().lineSpacing());
    auto* form = new QFormLayout(page);
    form->addRow(tr("&Title"), title);
    form->addRow(tr("&Description"), description);
    texts_->addTab(page, language.name);
    languages_.push_back({language.code.toStdString(), title, description});
    connect(title, &QLineEdit::textChanged, this, &ExhibitObjectsPage::takeFields);
    connect(description, &QPlainTextEdit::textChanged, this, &ExhibitObjectsPage::takeFields);
  }
}

QBoxLayout* ExhibitObjectsPage::listColumn() {
  connect(list_, &QListWidget::currentRowChanged, this, &ExhibitObjectsPage::showChosen);
  connect(add_, &QPushButton::clicked, this,
          [this] { add(QFileDialog::getOpenFileNames(this, tr("Objects of the exhibit"))); });
  connect(remove_, &QPushButton::clicked, this, &ExhibitObjectsPage::remove);
  connect(up_, &QPushButton::clicked, this, [this] { move(-1); });
  connect(down_, &QPushButton::clicked, this, [this] { move(1); });
  auto* buttons = new QGridLayout;
  buttons->addWidget(add_, 0, 0);
  buttons->addWidget(remove_, 0, 1);
  buttons->addWidget(up_, 1, 0);
  buttons->addWidget(down_, 1, 1);
  auto* column = new QVBoxLayout;
  auto* heading = new QLabel(tr("&Objects"));
  heading->setBuddy(list_);
  column->addWidget(heading);
  column->addWidget(list_, 1);
  column->addLayout(buttons);
  return column;
}

QBoxLayout* ExhibitObjectsPage::fileRow() {
  connect(file_, &QLineEdit::textChanged, this, &ExhibitObjectsPage::takeFields);
  connect(browse_, &QPushButton::clicked, this, &ExhibitObjectsPage::browse);
  auto* row = new QHBoxLayout;
  row->addWidget(file_, 1);
  row->addWidget(browse_);
  return row;
}

QWidget* ExhibitObjectsPage::objectForm() {
  unit_->addItem(tr("From the file"), -1);
  addUnits(*unit_);
  view_->addItem(tr("From the file"), QString());
  addViews(*view_);
  for (QComboBox* choice : {unit_, view_}) {
    connect(choice, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            &ExhibitObjectsPage::takeFields);
  }
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  auto* file = new QLabel(tr("&File"));
  file->setBuddy(file_);  // A row of several fields has none of its own.
  form->addRow(file, fileRow());
  form->addRow(tr("&Unit of the file"), unit_);
  form->addRow(tr("Vie&w"), view_);
  form->addRow(texts_);
  return page;
}

void ExhibitObjectsPage::setObjects(std::vector<ExhibitObject> objects) {
  objects_ = std::move(objects);
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (std::size_t i = 0; i < objects_.size(); ++i) list_->addItem(QString());
    for (int row = 0; row < list_->count(); ++row) nameRow(row);
    list_->setCurrentRow(objects_.empty() ? -1 : 0);
  }
  showChosen();
}

void ExhibitObjectsPage::setLanguages(const std::vector<std::string>& languages) {
  for (std::size_t i = 0; i < languages_.size(); ++i) {
    const bool is_spoken =
        std::find(languages.begin(), languages.end(), languages_[i].tag) != languages.end();
    texts_->setTabEnabled(static_cast<int>(i), is_spoken);
  }
}

QWidget* ExhibitObjectsPage::fieldOf(const QString& part) const {
  if (part.isEmpty()) return list_;
  if (part == QLatin1String("file")) return file_;
  if (part == QLatin1String("unit")) return unit_;
  if (part == QLatin1String("view")) return view_;
  const QString name = part.section(u'.', 0, 0), tag = part.section(u'.', 1);
  for (const Texts& texts : languages_) {
    if (QString::fromStdString(texts.tag) != tag) continue;
    if (name == QLatin1String("title")) return texts.title;
    if (name == QLatin1String("description")) return texts.description;
  }
  return nullptr;
}

void ExhibitObjectsPage::choose(int object, const QString& part) {
  list_->setCurrentRow(object);
  for (std::size_t i = 0; i < languages_.size(); ++i) {
    if (QString::fromStdString(languages_[i].tag) == part.section(u'.', 1)) {
      texts_->setCurrentIndex(static_cast<int>(i));
    }
  }
}

void ExhibitObjectsPage::add(const QStringList& files) {
  if (files.isEmpty()) return;
  for (const QString& file : files) {
    ExhibitObject object;
    object.file = bytesOfPath(QFileInfo(file).absoluteFilePath());
    objects_.push_back(std::move(object));
    list_->addItem(QString());
    nameRow(list_->count() - 1);
  }
  list_->setCurrentRow(list_->count() - 1);
  Q_EMIT changed();
}

void ExhibitObjectsPage::remove() {
  const int row = list_->currentRow();
  if (chosen() == nullptr) return;
  objects_.erase(objects_.begin() + row);
  {
    const QSignalBlocker quiet(list_);
    delete list_->takeItem(row);
    list_->setCurrentRow(std::min(row, list_->count() - 1));
  }
  showChosen();
  Q_EMIT changed();
}

void ExhibitObjectsPage::move(int by) {
  const int row = list_->currentRow();
  const int other = row + by;
  if (chosen() == nullptr || other < 0 || other >= list_->count()) return;
  std::swap(objects_[static_cast<std::size_t>(row)], objects_[static_cast<std::size_t>(other)]);
  nameRow(row);
  nameRow(other);
  list_->setCurrentRow(other);
  Q_EMIT changed();
}

void ExhibitObjectsPage::browse() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Object of the exhibit"), folderFor(file_->text()));
  if (!file.isEmpty()) file_->setText(file);
}

void ExhibitObjectsPage::nameRow(int row) {
  const ExhibitObject& object = objects_[static_cast<std::size_t>(row)];
  const QString path = pathFromBytes(object.file.native());
  QListWidgetItem* item = list_->item(row);
  item->setText(path.isEmpty() ? tr("No file") : shownName(path));
  item->setToolTip(shownAsTip(path));
}

ExhibitObject* ExhibitObjectsPage::chosen() {
  const int row = list_->currentRow();
  return row < 0 || static_cast<std::size_t>(row) >= objects_.size()
             ? nullptr
             : &objects_[static_cast<std::size_t>(row)];
}

void ExhibitObjectsPage::showChosen() {
  const ExhibitObject* object = chosen();
  const int row = list_->currentRow();
  form_->setEnabled(object != nullptr);
  remove_->setEnabled(object != nullptr);
  up_->setEnabled(object != nullptr && row > 0);
  down_->setEnabled(object != nullptr && row + 1 < list_->count());
  const ExhibitObject shown = object == nullptr ? ExhibitObject{} : *object;
  is_showing_ = true;
  file_->setText(pathFromBytes(shown.file.native()));
  unit_->setCurrentIndex(shown.unit ? unit_->findData(static_cast<int>(*shown.unit)) : 0);
  view_->setCurrentIndex(shown.view ? view_->findData(QString::fromStdString(*shown.view)) : 0);
  for (const Texts& texts : languages_) {
    texts.title->setText(wordsOf(shown.title, texts.tag));
    texts.description->setPlainText(wordsOf(shown.description, texts.tag));
  }
  is_showing_ = false;
}

void ExhibitObjectsPage::takeFields() {
  ExhibitObject* object = chosen();
  if (is_showing_ || object == nullptr) return;
  object->file = bytesOfPath(file_->text());
  const int unit = unit_->currentData().toInt();
  object->unit = unit < 0 ? std::nullopt : std::optional(static_cast<LengthUnit>(unit));
  const QString view = view_->currentData().toString();
  object->view = view.isEmpty() ? std::nullopt : std::optional(view.toStdString());
  for (const Texts& texts : languages_) {
    keep(object->title, texts.tag, texts.title->text());
    keep(object->description, texts.tag, texts.description->toPlainText());
  }
  nameRow(list_->currentRow());
  Q_EMIT changed();
}

}  // namespace relievo
