// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/exhibit/exhibit_visit_page.h"

#include <algorithm>
#include <array>
#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpressionValidator>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <utility>

#include "ui/dialogs/named_fields.h"
#include "ui/language/language.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

QFormLayout* formIn(QWidget* box) {
  auto* form = new QFormLayout(box);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  return form;
}

// Below the least volume: nothing was said for the room.
constexpr int kLeastVolume = 10, kTheSame = kLeastVolume - 1;

QString percent() {
  return QStringLiteral(" %");
}

}  // namespace

ExhibitVisitPage::ExhibitVisitPage(QWidget* parent)
    : QWidget(parent),
      first_(namedField(new QComboBox, "exhibit_first_language", tr("Language of a new visitor"),
                        tr("The first that is offered, and in which all begins"))),
      still_there_(number("exhibit_still_there", tr("Ask whether somebody is there after"),
                          tr("Seconds without any input"), 10, 600, tr(" s"))),
      goodbye_(number("exhibit_goodbye", tr("Begin anew after"), tr("Seconds after the question"),
                      5, 120, tr(" s"))),
      chime_(number("exhibit_chime", tr("Chime every"),
                    tr("Seconds between chimes while nobody is there: 10 to 3600, or none"), 0,
                    3600, tr(" s"))),
      volume_(whole("exhibit_volume", tr("Volume of a new visitor"),
                    tr("Buttons change it until the visit ends"), 10, 100, percent())),
      loudest_(whole("exhibit_loudest", tr("Loudest"),
                     tr("No button goes above it; how loud it is depends on the loudspeaker"), 10,
                     100, percent())),
      room_loudest_(whole("exhibit_room_loudest", tr("Loudest in the room"),
                          tr("The same on a loudspeaker; the volume falls to it where headphones "
                             "are pulled out"),
                          kTheSame, 100, percent())),
      words_(whole("exhibit_words", tr("Words a minute"), tr("How fast the voice speaks"), 100, 449,
                   QString())),
      device_(namedField(new QComboBox, "exhibit_device", tr("Device"),
                         tr("falcon, mouse, or what the panel Touch calls the device"))),
      strength_(whole("exhibit_strength", tr("Strength"), tr("How much of every force is felt"), 1,
                      100, percent())),
      sounds_(whole("exhibit_sounds", tr("Sounds of touch"), tr("Their volume; 0: none"), 0, 100,
                    percent())),
      limit_(number("exhibit_limit", tr("Largest force"), tr("No force is larger"), 0.5, 6,
                    QStringLiteral(" N"))),
      introduction_(truth("exhibit_introduction", tr("Begin with the introduction"),
                          tr("Each visitor's first object begins with two shapes to feel"))),
      guide_(truth("exhibit_guide", tr("Offer to lead the hand"),
                   tr("Once round the outline, with a device that can"))),
      patterns_(truth("exhibit_patterns", tr("Taps say what sounds say"),
                      tr("For who hears neither sounds nor speech"))),
      one_button_(truth("exhibit_one_button", tr("One button does all"),
                        tr("For a foot switch or another single switch"))),
      digits_(namedField(new QLineEdit, "exhibit_pin", tr("New PIN of the staff"),
                         tr("4 to 12 digits. The file keeps a checksum of them, not the digits"))),
      records_(namedField(new QLineEdit, "exhibit_records", tr("Folder of counts and logs"),
                          tr("Empty: a folder of the account that shows the exhibit"))) {
  auto* inside = new QWidget;
  auto* columns = new QHBoxLayout(inside);
  auto* left = new QVBoxLayout;
  for (QGroupBox* box : {languageBox(), waitingBox(), voiceBox()}) left->addWidget(box);
  left->addStretch(1);
  auto* right = new QVBoxLayout;
  for (QGroupBox* box : {touchBox(), staffBox()}) right->addWidget(box);
  right->addStretch(1);
  columns->addLayout(left, 1);
  columns->addLayout(right, 1);
  auto* area = new QScrollArea;  // Large text on a small screen.
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidget(inside);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(area);
}

QSpinBox* ExhibitVisitPage::whole(const char* name, const QString& title, const QString& tip,
                                  int least, int most, const QString& unit) {
  auto* field = namedField(new QSpinBox, name, title, tip);
  field->setRange(least, most);
  field->setSuffix(unit);
  connect(field, QOverload<int>::of(&QSpinBox::valueChanged), this, &ExhibitVisitPage::changed);
  return field;
}

QDoubleSpinBox* ExhibitVisitPage::number(const char* name, const QString& title, const QString& tip,
                                         double least, double most, const QString& unit) {
  auto* field = namedField(new QDoubleSpinBox, name, title, tip);
  field->setDecimals(1);
  field->setRange(least, most);
  field->setSuffix(unit);
  connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          &ExhibitVisitPage::changed);
  return field;
}

QCheckBox* ExhibitVisitPage::truth(const char* name, const QString& title, const QString& tip) {
  auto* box = namedField(new QCheckBox(title), name, title, tip);
  connect(box, &QCheckBox::toggled, this, &ExhibitVisitPage::changed);
  return box;
}

QGroupBox* ExhibitVisitPage::languageBox() {
  auto* box = namedField(new QGroupBox(tr("Languages")), "exhibit_languages", tr("Languages"), {});
  auto* form = formIn(box);
  for (const Language& language : languageList()) {
    auto* spoken = namedField(new QCheckBox(language.name),
                              ("exhibit_language_" + language.code.toLatin1()).constData(),
                              language.name, tr("Offered to visitors"));
    spoken->setProperty("tag", language.code);
    spoken_.push_back(spoken);
    form->addRow(spoken);
    connect(spoken, &QCheckBox::toggled, this, &ExhibitVisitPage::takeLanguages);
  }
  box->setFocusProxy(spoken_.front());
  form->addRow(tr("Language of a new visitor"), first_);
  connect(first_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &ExhibitVisitPage::takeLanguages);
  return box;
}

QGroupBox* ExhibitVisitPage::waitingBox() {
  auto* box = new QGroupBox(tr("Waiting"));
  auto* form = formIn(box);
  chime_->setSpecialValueText(tr("None"));
  form->addRow(tr("Ask whether somebody is there after"), still_there_);
  form->addRow(tr("Begin anew after"), goodbye_);
  form->addRow(tr("Chime every"), chime_);
  return box;
}

QGroupBox* ExhibitVisitPage::voiceBox() {
  auto* box = new QGroupBox(tr("Voice"));
  auto* form = formIn(box);
  form->addRow(tr("Volume of a new visitor"), volume_);
  form->addRow(tr("Loudest"), loudest_);
  room_loudest_->setSpecialValueText(tr("The same"));
  form->addRow(tr("Loudest in the room"), room_loudest_);
  form->addRow(tr("Words a minute"), words_);
  return box;
}

QGroupBox* ExhibitVisitPage::touchBox() {
  auto* box = new QGroupBox(tr("Touch"));
  auto* form = formIn(box);
  device_->setEditable(true);
  device_->addItems({QStringLiteral("falcon"), QStringLiteral("mouse")});
  connect(device_, &QComboBox::currentTextChanged, this, &ExhibitVisitPage::changed);
  form->addRow(tr("Device"), device_);
  form->addRow(tr("Strength"), strength_);
  form->addRow(tr("Largest force"), limit_);
  form->addRow(tr("Sounds of touch"), sounds_);
  for (QCheckBox* one : {introduction_, guide_, patterns_, one_button_}) form->addRow(one);
  return box;
}

QGroupBox* ExhibitVisitPage::staffBox() {
  auto* box = new QGroupBox(tr("Staff"));
  auto* form = formIn(box);
  digits_->setMaxLength(static_cast<int>(kMostPinDigits));
  digits_->setValidator(
      new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[0-9]*")), digits_));
  connect(digits_, &QLineEdit::textChanged, this, &ExhibitVisitPage::changePin);
  connect(records_, &QLineEdit::textChanged, this, &ExhibitVisitPage::changed);
  auto* browse = namedButton(tr("C&hoose\u2026"), "exhibit_records_browse",
                             tr("Choose the folder of counts and logs"));
  connect(browse, &QPushButton::clicked, this, &ExhibitVisitPage::browse);
  auto* place = new QHBoxLayout;
  place->addWidget(records_, 1);
  place->addWidget(browse);
  form->addRow(tr("New PIN of the staff"), digits_);
  form->addRow(tr("Folder of counts and logs"), place);
  return box;
}

void ExhibitVisitPage::setExhibit(const Exhibit& exhibit) {
  is_showing_ = true;
  languages_ = exhibit.languages;
  for (QCheckBox* spoken : spoken_) {
    const auto tag = spoken->property("tag").toString().toStdString();
    spoken->setChecked(std::count(languages_.begin(), languages_.end(), tag) > 0);
  }
  listLanguages();
  still_there_->setValue(exhibit.times.still_there_s);
  goodbye_->setValue(exhibit.times.goodbye_s);
  chime_->setValue(exhibit.times.chime_s);
  volume_->setValue(exhibit.speech.volume_percent);
  loudest_->setValue(exhibit.speech.loudest_percent);
  room_loudest_->setValue(exhibit.speech.room_loudest_percent.value_or(kTheSame));
  words_->setValue(exhibit.speech.words_per_minute);
  device_->setCurrentText(QString::fromStdString(exhibit.touch.device));
  strength_->setValue(exhibit.touch.strength_percent);
  sounds_->setValue(exhibit.touch.sounds_percent);
  limit_->setValue(exhibit.touch.limit_n);
  introduction_->setChecked(exhibit.touch.introduction);
  guide_->setChecked(exhibit.touch.guide);
  patterns_->setChecked(exhibit.touch.felt_patterns);
  one_button_->setChecked(exhibit.touch.one_button);
  pin_ = exhibit.pin;
  digits_->clear();
  showPin();
  records_->setText(pathFromBytes(exhibit.records.native()));
  is_showing_ = false;
}

void ExhibitVisitPage::fill(Exhibit& exhibit) const {
  exhibit.languages = languages_;
  exhibit.times = {still_there_->value(), goodbye_->value(), chime_->value()};
  exhibit.speech = {.volume_percent = volume_->value(),
                    .loudest_percent = loudest_->value(),
                    .words_per_minute = words_->value()};
  if (room_loudest_->value() > kTheSame) {
    exhibit.speech.room_loudest_percent = room_loudest_->value();
  }
  exhibit.touch = {.device = device_->currentText().trimmed().toStdString(),
                   .strength_percent = strength_->value(),
                   .limit_n = limit_->value(),
                   .introduction = introduction_->isChecked(),
                   .guide = guide_->isChecked(),
                   .sounds_percent = sounds_->value(),
                   .felt_patterns = patterns_->isChecked(),
                   .one_button = one_button_->isChecked()};
  exhibit.pin = pin_;
  exhibit.records = bytesOfPath(records_->text());
}

QWidget* ExhibitVisitPage::fieldOf(const QString& place) const {
  const std::array<std::pair<const char*, QWidget*>, 18> fields{
      {{"languages", findChild<QWidget*>(QStringLiteral("exhibit_languages"))},
       {"idle.still_there_s", still_there_},
       {"idle.goodbye_s", goodbye_},
       {"idle.chime_s", chime_},
       {"speech.volume_percent", volume_},
       {"speech.loudest_percent", loudest_},
       {"speech.room_loudest_percent", room_loudest_},
       {"speech.words_per_minute", words_},
       {"touch.device", device_},
       {"touch.strength_percent", strength_},
       {"touch.limit_n", limit_},
       {"touch.sounds_percent", sounds_},
       {"touch.introduction", introduction_},
       {"touch.guide", guide_},
       {"touch.felt_patterns", patterns_},
       {"touch.one_button", one_button_},
       {"staff_pin", digits_},
       {"records", records_}}};
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const auto& field) {
    return place == QLatin1String(field.first);
  });
  return found == fields.end() ? nullptr : found->second;
}

// Those that stay keep their order, the others come behind; the first is the one that was chosen.
void ExhibitVisitPage::takeLanguages() {
  if (is_showing_) return;
  for (const QCheckBox* spoken : spoken_) {
    const auto tag = spoken->property("tag").toString().toStdString();
    const auto found = std::find(languages_.begin(), languages_.end(), tag);
    if (spoken->isChecked() && found == languages_.end()) languages_.push_back(tag);
    if (!spoken->isChecked() && found != languages_.end()) languages_.erase(found);
  }
  const auto first = std::find(languages_.begin(), languages_.end(),
                               first_->currentData().toString().toStdString());
  if (first != languages_.end()) std::rotate(languages_.begin(), first, first + 1);
  listLanguages();
  Q_EMIT changed();
}

void ExhibitVisitPage::listLanguages() {
  const QSignalBlocker quiet(first_);
  first_->clear();
  for (const Language& language : languageList()) {
    if (std::count(languages_.begin(), languages_.end(), language.code.toStdString()) > 0) {
      first_->addItem(language.name, language.code);
    }
  }
  if (languages_.empty()) return;
  first_->setCurrentIndex(first_->findData(QString::fromStdString(languages_.front())));
}

void ExhibitVisitPage::browse() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Folder of counts and logs"), records_->text());
  if (!folder.isEmpty()) records_->setText(folder);
}

void ExhibitVisitPage::showPin() {
  digits_->setPlaceholderText(pin_.salt.empty() ? tr("None yet") : tr("Stays as it is"));
}

// A number that is not whole yet leaves no old one in its place: nobody would know which holds.
void ExhibitVisitPage::changePin() {
  if (is_showing_) return;
  const std::string digits = digits_->text().toStdString();
  pin_ = isPin(digits) ? newStaffPin(digits) : StaffPin{};
  showPin();
  Q_EMIT changed();
}

}  // namespace relievo
