// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/preferences_dialog.h"

#include <algorithm>
#include <numeric>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStyle>
#include <QVBoxLayout>

#include "core/relief/eye_angle.h"
#include "core/relief/look.h"
#include "ui/dialogs/device_trust_box.h"
#include "ui/language/core_text.h"
#include "ui/language/language.h"
#include "ui/style/dialog_size.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/views/pointer_bindings.h"

namespace relievo {
namespace {

/// As wide as its entries, whatever the size of text.
class PageList : public QListWidget {
 public:
  PageList() { setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding); }
  QSize sizeHint() const override {
    const int inside = sizeHintForColumn(0) + fontMetrics().averageCharWidth();
    return {inside + 2 * frameWidth() + style()->pixelMetric(QStyle::PM_ScrollBarExtent),
            QListWidget::sizeHint().height()};
  }
  QSize minimumSizeHint() const override { return {sizeHint().width(), 0}; }
};

}  // namespace

PreferencesDialog::PreferencesDialog(Settings& settings, QWidget* parent)
    : QDialog(parent),
      settings_(settings),
      words_(new QLineEdit),
      pages_(new PageList),
      stack_(new QStackedWidget),
      nothing_(new QLabel(tr("No setting has these words."))) {
  setObjectName(QStringLiteral("preferences_dialog"));
  setWindowTitle(tr("Preferences"));
  words_->setObjectName(QStringLiteral("preferences_words"));
  words_->setAccessibleName(tr("Search settings"));
  words_->setToolTip(tr("Words of a setting's name or explanation"));
  words_->setPlaceholderText(tr("Search settings"));
  words_->setClearButtonEnabled(true);
  pages_->setObjectName(QStringLiteral("preferences_pages"));
  pages_->setAccessibleName(tr("Pages"));
  stack_->setObjectName(QStringLiteral("preferences_stack"));
  makeAppearance();
  makeUnits();
  makeStereo();
  makeMouse();
  makeDevice();
  makeRecording();
  auto* column = new QVBoxLayout(this);
  column->addWidget(words_);
  column->addWidget(nothing_);
  nothing_->hide();
  auto* row = new QHBoxLayout;
  row->addWidget(pages_);
  row->addWidget(stack_, 1);
  column->addLayout(row, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  nameButtons(*buttons);
  auto* reset = buttons->addButton(tr("&Defaults of this page"), QDialogButtonBox::ResetRole);
  reset->setObjectName(QStringLiteral("preferences_reset"));
  reset->setAccessibleName(tr("Defaults of this page"));
  reset->setToolTip(tr("Every setting of this page as it was at first"));
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(reset, &QPushButton::clicked, this, &PreferencesDialog::resetPage);
  connect(words_, &QLineEdit::textChanged, this, &PreferencesDialog::search);
  constexpr int kTypedMs = 600;
  tells_found_.setSingleShot(true);
  tells_found_.setInterval(kTypedMs);
  connect(&tells_found_, &QTimer::timeout, this, [this] { Q_EMIT said(found_words_); });
  connect(pages_, &QListWidget::currentRowChanged, stack_, &QStackedWidget::setCurrentIndex);
  pages_->setCurrentRow(0);
  resizeToText(*this, {90, 26});
}

QFormLayout* PreferencesDialog::addPage(const QString& title) {
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(page);
  scroll->setFocusPolicy(Qt::NoFocus);
  stack_->addWidget(scroll);
  pages_->addItem(title);
  return form;
}

void PreferencesDialog::add(const Field& about, QWidget* field) {
  field->setObjectName(QLatin1String("pref_") + QString::fromLatin1(about.key));
  field->setAccessibleName(about.title);
  field->setToolTip(about.tip);
  auto* label = new QLabel(about.title);
  label->setWordWrap(true);
  label->setToolTip(about.tip);
  label->setBuddy(field);
  const int page = stack_->count() - 1;
  auto* scroll = static_cast<QScrollArea*>(stack_->widget(page));
  static_cast<QFormLayout*>(scroll->widget()->layout())->addRow(label, field);
  rows_.push_back({page, label, field,
                   QStringList{about.title, about.tip, pages_->item(page)->text()}.join(' ')});
}

void PreferencesDialog::set(const char* key, const QVariant& value) {
  settings_.setChoice(QString::fromLatin1(key), value);
  Q_EMIT changed(QString::fromLatin1(key));
}

void PreferencesDialog::addChoice(const Field& about, const QVariant& fallback,
                                  const std::vector<std::pair<QString, QVariant>>& choices) {
  auto* box = new QComboBox;
  for (const auto& [text, value] : choices) box->addItem(text, value);
  const auto show_value = [box](const QVariant& value) {
    for (int i = 0; i < box->count(); ++i) {
      if (box->itemData(i).toString() == value.toString()) box->setCurrentIndex(i);
    }
  };
  show_value(settings_.choice(QString::fromLatin1(about.key), fallback));
  connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this, box, key = about.key] { set(key, box->currentData()); });
  add(about, box);
  resets_.emplace_back(stack_->count() - 1, [show_value, fallback] { show_value(fallback); });
}

void PreferencesDialog::addNumber(const Field& about, double fallback, double low, double high,
                                  double step, const QString& suffix) {
  auto* box = new QDoubleSpinBox;
  box->setDecimals(low < 0.1 && low > 0 ? 2 : step < 1 ? 1 : 0);  // Else the least would be 0.
  box->setRange(low, high);
  box->setSingleStep(step);
  box->setSuffix(suffix);
  box->setKeyboardTracking(false);  // A size typed halfway would change the window under it.
  box->setValue(settings_.choice(QString::fromLatin1(about.key), fallback).toDouble());
  connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this, key = about.key](double value) { set(key, value); });
  add(about, box);
  resets_.emplace_back(stack_->count() - 1, [box, fallback] { box->setValue(fallback); });
}

void PreferencesDialog::addSwitch(const Field& about, bool fallback) {
  auto* box = new QCheckBox;
  box->setChecked(settings_.choice(QString::fromLatin1(about.key), fallback).toBool());
  connect(box, &QCheckBox::toggled, this, [this, key = about.key](bool on) { set(key, on); });
  add(about, box);
  resets_.emplace_back(stack_->count() - 1, [box, fallback] { box->setChecked(fallback); });
}

void PreferencesDialog::addPath(const Field& about, PathKind kind, const QString& shown) {
  auto* field = new QWidget;
  auto* row = new QHBoxLayout(field);
  row->setContentsMargins(0, 0, 0, 0);
  auto* path =
      new QLineEdit(settings_.choice(QString::fromLatin1(about.key), QString()).toString());
  auto* browse = new QPushButton(tr("&Browse\u2026"));
  browse->setAccessibleName(tr("Browse for %1").arg(about.title));
  browse->setToolTip(about.tip);
  row->addWidget(path, 1);
  row->addWidget(browse);
  field->setFocusProxy(path);
  add(about, field);
  path->setObjectName(QLatin1String("pref_") + QString::fromLatin1(about.key) +
                      QLatin1String("_path"));
  path->setAccessibleName(about.title);
  path->setToolTip(about.tip);
  path->setPlaceholderText(shown);
  connect(path, &QLineEdit::editingFinished, this, [this, path, key = about.key] {
    if (path->text() != settings_.choice(QString::fromLatin1(key), QString()).toString()) {
      set(key, path->text());
    }
  });
  connect(browse, &QPushButton::clicked, this, [this, path, about, kind] {
    auto* dialog = new QFileDialog(this, about.title);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(kind == PathKind::file ? QFileDialog::ExistingFile
                                               : QFileDialog::Directory);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, path, key = about.key](const QString& file) {
              path->setText(file);
              set(key, file);
            });
    dialog->open();
  });
  resets_.emplace_back(stack_->count() - 1, [this, path, key = about.key] {
    path->clear();
    set(key, QString());
  });
}

void PreferencesDialog::makeAppearance() {
  addPage(tr("Appearance"));
  addChoice({"theme", tr("Colours"), tr("Light, dark or high contrast window; or as the desktop")},
            0,
            {{tr("As the system"), static_cast<int>(Theme::system)},
             {tr("Light"), static_cast<int>(Theme::light)},
             {tr("Dark"), static_cast<int>(Theme::dark)},
             {tr("High contrast"), static_cast<int>(Theme::contrast)}});
  addNumber(
      {"text_percent", tr("Text size"), tr("Of the system's text size; everything grows with it")},
      100, kLeastTextPercent, kMostTextPercent, 10, tr(" %"));
  std::vector<std::pair<QString, QVariant>> languages{{tr("As the system"), QString()}};
  for (const Language& language : languageList())
    languages.emplace_back(language.name, language.code);
  addChoice({"language", tr("Language"), tr("Of the window; holds from the next start")}, QString(),
            languages);
  auto* now = new QPushButton(tr("Restart no&w"));
  now->setAutoDefault(false);
  add({"restart", tr("For another language"),
       tr("End and start again with the same file; asks first if something is not saved")},
      now);
  now->setAccessibleName(tr("Restart now"));
  connect(now, &QPushButton::clicked, this, &PreferencesDialog::restartAsked);
}

void PreferencesDialog::makeUnits() {
  addPage(tr("Units"));
  std::vector<std::pair<QString, QVariant>> units{{tr("Ask"), QString()}};
  for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::cm, LengthUnit::m, LengthUnit::in,
                                LengthUnit::ft, LengthUnit::us_ft}) {
    units.emplace_back(unitText(unit), QString::fromUtf8(name(unit).data()));
  }
  addChoice({"unit_without", tr("Files without a unit"),
             tr("Which unit is taken where neither the file nor its folder says one")},
            QString(), units);
  addChoice({"size_unit", tr("Sizes are shown in"),
             tr("Millimetres, and metres for what is larger than 10 m; or always one unit")},
            QString(),
            {{tr("Fitting unit"), QString()},
             {tr("Millimetres"), QStringLiteral("mm")},
             {tr("Centimetres"), QStringLiteral("cm")},
             {tr("Metres"), QStringLiteral("m")},
             {tr("Inches"), QStringLiteral("in")}});
}

void PreferencesDialog::makeStereo() {
  addPage(tr("Stereo"));
  addChoice({"stereo_kind", tr("Kind of stereo"),
             tr("What stereo starts with: an anaglyph for red and cyan glasses, or pictures for a "
                "screen that shows each eye its own")},
            QStringLiteral("anaglyph"),
            {{tr("Grey"), QStringLiteral("anaglyph")},
             {tr("Half colour"), QStringLiteral("half")},
             {tr("Dubois"), QStringLiteral("dubois")},
             {tr("Side by side"), QStringLiteral("sidebyside")},
             {tr("Over and under"), QStringLiteral("overunder")},
             {tr("Interlaced"), QStringLiteral("interlaced")}});
  addSwitch({"stereo_automatic", tr("Automatic depth"),
             tr("Eye separation by the heights that are shown, at the start")},
            true);
  addNumber({"stereo_angle", tr("Eye separation"),
             tr("Angle between the two eyes' directions at the start, without automatic depth")},
            StereoOptions{}.eye_angle_deg, kLeastEyeAngleDeg, kMostEyeAngleDeg, 0.5,
            QStringLiteral("\u00b0"));
  addSwitch({"stereo_comfort", tr("Keep comfortable"),
             tr("Less eye separation where it would pass 1 degree of parallax")},
            true);
  addSwitch(
      {"stereo_swap", tr("Swap eyes"), tr("For glasses whose red filter is at the right eye")},
      false);
}

void PreferencesDialog::makeMouse() {
  addPage(tr("Mouse"));
  addChoice({"pointer_mode", tr("Left button"),
             tr("What it does in the detail view: look turns it, touch presses the hand in (F7)")},
            QStringLiteral("look"),
            {{tr("Look"), QStringLiteral("look")}, {tr("Touch"), QStringLiteral("touch")}});
  const std::vector<std::pair<QString, QVariant>> acts{
      {tr("turns the view"), keptName(PointerAct::turn)},
      {tr("moves the window"), keptName(PointerAct::move)},
      {tr("zooms"), keptName(PointerAct::zoom)},
      {tr("does nothing"), keptName(PointerAct::none)}};
  struct Button {
    Field about;
    PointerAct fallback;
  };
  const PointerBindings first;
  const QString tip = tr("What dragging with this button does in the detail view");
  for (const Button& b : {Button{{"look_left", tr("To look: left"), tip}, first.look_left},
                          Button{{"look_middle", tr("To look: middle"), tip}, first.look_middle},
                          Button{{"look_right", tr("To look: right"), tip}, first.look_right},
                          Button{{"touch_middle", tr("To touch: middle"), tip}, first.touch_middle},
                          Button{{"touch_right", tr("To touch: right"), tip}, first.touch_right}}) {
    addChoice(b.about, keptName(b.fallback), acts);
  }
  addChoice({"wheel_forward", tr("Wheel away from you"),
             tr("Which way the wheel zooms in the detail view")},
            true, {{tr("zooms in"), true}, {tr("zooms out"), false}});
}

void PreferencesDialog::makeDevice() {
  addPage(tr("Device"));
  addPath({"falcon_firmware", tr("Falcon firmware"),
           tr("File with the Falcon's firmware, or its folder; empty: the usual places. Holds when "
              "a Falcon is started next")},
          PathKind::file);
  addPath({"force_dimension_library", tr("Force Dimension's library"),
           tr("File libdhd.so.3 or libdrd.so.3 of the maker of omega, delta, sigma and lambda; "
              "empty: the usual places. Holds when such a device is looked for next")},
          PathKind::file);
  makeDevicePlugins();
  addSwitch({"keep_work", tr("Keep work for a crash"),
             tr("A copy of unsaved work every two seconds, offered after a crash")},
            true);
}

void PreferencesDialog::makeDevicePlugins() {
  if (!settings_.deviceTrust().list) return;
  auto* box = new DeviceTrustBox(settings_.deviceTrust());
  add({"device_plugins", tr("Plug-ins for devices"),
       tr("Which plug-ins for haptic devices may run. A plug-in can do all that you can do: allow "
          "one only if you know where it is from. A file that changes must be allowed again")},
      box);
  connect(box, &DeviceTrustBox::said, this, &PreferencesDialog::said);
  resets_.emplace_back(stack_->count() - 1, [box] { box->allowNone(); });
}

void PreferencesDialog::makeRecording() {
  addPage(tr("Recording"));
  addChoice({"recording_kind", tr("Recordings are"),
             tr("Kind of file of the next recording: a table as text, or HDF5, smaller and with "
                "units and surface")},
            QStringLiteral("csv"),
            {{tr("CSV: every program opens it"), QStringLiteral("csv")},
             {tr("HDF5: for Python and MATLAB"), QStringLiteral("h5")}});
  addPath({"recording_folder", tr("Folder of recordings"),
           tr("Where recordings go that are made from now on; empty: relievo in the documents "
              "folder")},
          PathKind::folder);
}

void PreferencesDialog::search(const QString& words) {
  const QStringList wanted = words.split(' ', Qt::SkipEmptyParts);
  std::vector<int> found(static_cast<std::size_t>(stack_->count()), 0);
  for (const Row& row : rows_) {
    const bool fits = std::all_of(wanted.begin(), wanted.end(), [&](const QString& word) {
      return row.words.contains(word, Qt::CaseInsensitive);
    });
    row.label->setVisible(fits);
    row.field->setVisible(fits);
    if (fits) ++found[static_cast<std::size_t>(row.page)];
  }
  int first = -1;
  for (int page = 0; page < stack_->count(); ++page) {
    const bool any = found[static_cast<std::size_t>(page)] > 0;
    pages_->item(page)->setHidden(!any);
    if (any && first < 0) first = page;
  }
  nothing_->setVisible(first < 0);
  const int now = pages_->currentRow();
  if (first >= 0 && (now < 0 || found[static_cast<std::size_t>(now)] == 0)) {
    pages_->setCurrentRow(first);
  }
  if (wanted.isEmpty()) {
    tells_found_.stop();
    return;
  }
  const int all = std::accumulate(found.begin(), found.end(), 0);
  found_words_ = all == 0 ? nothing_->text() : tr("Settings found: %1").arg(all);
  tells_found_.start();  // Not of every letter that is typed.
}

void PreferencesDialog::resetPage() {
  const int page = stack_->currentIndex();
  for (const auto& [of, reset] : resets_) {
    if (of == page) reset();
  }
}

}  // namespace relievo
