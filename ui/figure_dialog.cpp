// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure_dialog.h"

#include <algorithm>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include "core/base/error.h"
#include "core/relief/relief_image.h"
#include "ui/core_words.h"
#include "ui/dialog_size.h"
#include "ui/mnemonic.h"
#include "ui/spoken_error.h"
#include "ui/text.h"

namespace relievo {
namespace {

constexpr int kLeastCharacters = 16;  // That a field shows ...
constexpr int kMostCharacters = 30;   // ... or more, where the screen is wide.
constexpr int kDelayMs = 300;
constexpr int kPreviewPx = 900;

struct Words {
  const char* text;
};
constexpr std::array<Words, 5> kLayouts{
    {{QT_TRANSLATE_NOOP("relievo::FigureDialog", "Detail alone")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Whole object and detail")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "As measured and filled")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Several levels")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "With force plots of a recording")}}};
constexpr std::array<Words, 8> kReliefs{
    {{QT_TRANSLATE_NOOP("relievo::FigureDialog", "Lit stone")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Height in colour")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Hillshade")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Hillshade, four lights")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Slope")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Local relief")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Sky-view factor")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Openness")}}};
constexpr std::array<Words, 6> kStereos{
    {{QT_TRANSLATE_NOOP("relievo::FigureDialog", "None")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Anaglyph, grey")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Anaglyph, half colour")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Anaglyph, Dubois")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Side by side")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "One over the other")}}};
constexpr std::array<Words, 8> kMarks{
    {{QT_TRANSLATE_NOOP("relievo::FigureDialog", "Scale &bar")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "&Height bar")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "&Up mark")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Window's &outline")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Hat&ch")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Le&gend")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Letters a, b")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "&Measurements")}}};

template <std::size_t N>
void fill(QComboBox* box, const std::array<Words, N>& words) {
  for (const Words& w : words) box->addItem(FigureDialog::tr(w.text));
}

void range(QDoubleSpinBox* box, double low, double high, int decimals, const QString& suffix) {
  box->setDecimals(decimals);
  box->setRange(low, high);
  box->setSuffix(suffix);
  box->setKeyboardTracking(false);
}

/// Room for the longest layout's name and the end of a path, unless that took it from the preview.
int fieldWidth(const QWidget& of) {
  const int character = of.fontMetrics().averageCharWidth();
  const int quarter = of.screen()->availableSize().width() / 4 / character;
  return std::clamp(quarter, kLeastCharacters, kMostCharacters) * character;
}

struct Drawn {
  Figure figure;
  FigureFacts facts;
  QString error;
};

/// Runs `work` and turns what it throws into words; nothing if it was stopped. [worker]
template <class Work>
QString errorOf(const Work& work) {
  try {
    work();
  } catch (const Cancelled&) {
    return {};
  } catch (const Error& error) {
    return shownError(error);
  } catch (const std::bad_alloc&) {
    return FigureDialog::tr("There is not enough memory for this figure. Nothing was written.");
  }
  return {};
}

}  // namespace

template <class Widget>
Widget* FigureDialog::field(QFormLayout* layout, const QString& title, const char* name,
                            const QString& tip) {
  auto* widget = new Widget;
  widget->setObjectName(QString::fromLatin1(name));
  widget->setAccessibleName(withoutMnemonic(title));
  widget->setToolTip(tip);
  if constexpr (std::is_base_of_v<QCheckBox, Widget>) {
    widget->setText(title);
    layout->addRow(widget);
    connect(widget, &QCheckBox::toggled, this, &FigureDialog::changed);
  } else {
    widget->setMinimumWidth(fieldWidth(*this));
    auto* label = new QLabel(title);
    label->setBuddy(widget);
    // A letter that is underlined stands farther from its neighbours than the label reckons.
    label->setContentsMargins(0, 0, label->fontMetrics().averageCharWidth(), 0);
    layout->addRow(label, widget);
  }
  if constexpr (std::is_base_of_v<QComboBox, Widget>) {
    widget->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(widget, QOverload<int>::of(&QComboBox::activated), this, &FigureDialog::changed);
  } else if constexpr (std::is_base_of_v<QDoubleSpinBox, Widget>) {
    connect(widget, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &FigureDialog::changed);
  } else if constexpr (std::is_base_of_v<QLineEdit, Widget>) {
    connect(widget, &QLineEdit::editingFinished, this, &FigureDialog::changed);
  }
  return widget;
}

FigureDialog::FigureDialog(std::shared_ptr<const Surface> surface, Project project,
                           const QString& file, QWidget* parent)
    : QDialog(parent),
      surface_(std::move(surface)),
      project_(std::move(project)),
      own_folder_(QFileInfo(file).absolutePath()),
      picture_(new QLabel),
      facts_(new QLabel),
      problem_(new QLabel),
      caption_(new QPlainTextEdit),
      bar_(new QProgressBar),
      stop_(new QPushButton(tr("Sto&p"))),
      delay_(new QTimer(this)) {
  setObjectName(QStringLiteral("figure_dialog"));
  setWindowTitle(tr("Figure"));
  QWidget* form = makeForm();
  file_->setText(file);
  showRequest(project_.figure);
  complete_ = true;
  picture_->setObjectName(QStringLiteral("figure_preview"));
  picture_->setAccessibleName(tr("Preview of the figure"));
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setMinimumSize(240, 160);
  picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  for (QLabel* label : {facts_, problem_}) label->setWordWrap(true);
  facts_->setObjectName(QStringLiteral("figure_facts"));
  facts_->setAccessibleName(tr("Size"));
  problem_->setObjectName(QStringLiteral("figure_problem"));
  problem_->setAccessibleName(tr("Problem"));
  problem_->hide();
  caption_->setObjectName(QStringLiteral("figure_caption"));
  caption_->setAccessibleName(tr("Caption"));
  caption_->setToolTip(tr("The text that belongs under this figure"));
  caption_->setReadOnly(true);
  caption_->setTabChangesFocus(true);
  caption_->setMaximumHeight(6 * fontMetrics().height());
  auto* copy = new QPushButton(tr("Cop&y caption"));
  copy->setObjectName(QStringLiteral("figure_copy"));
  copy->setAccessibleName(tr("Copy caption"));
  copy->setToolTip(tr("Put the caption into the clipboard"));
  copy->setAutoDefault(false);
  connect(copy, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(caption_->toPlainText()); });
  bar_->setRange(0, 0);
  bar_->setAccessibleName(tr("Progress"));
  stop_->setObjectName(QStringLiteral("figure_stop"));
  stop_->setAccessibleName(tr("Stop"));
  stop_->setToolTip(tr("Stop the work; nothing is written"));
  stop_->setAutoDefault(false);
  connect(stop_, &QPushButton::clicked, this, &FigureDialog::stop);

  auto* left = new QScrollArea;
  left->setWidget(form);
  left->setWidgetResizable(true);
  left->setFrameShape(QFrame::NoFrame);
  left->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  // Names beside their fields, unless the screen is too narrow for them.
  left->setMinimumWidth(std::clamp(form->sizeHint().width(), form->minimumSizeHint().width(),
                                   std::max(form->minimumSizeHint().width(),
                                            screen()->availableSize().width() * 2 / 5)) +
                        left->verticalScrollBar()->sizeHint().width() + 8);
  auto* right = new QVBoxLayout;
  right->addWidget(picture_, 1);
  right->addWidget(facts_);
  right->addWidget(problem_);
  auto* caption_row = new QHBoxLayout;
  caption_row->addWidget(caption_, 1);
  caption_row->addWidget(copy, 0, Qt::AlignTop);
  right->addLayout(caption_row);
  auto* columns = new QHBoxLayout;
  columns->addWidget(left, 0);
  columns->addLayout(right, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Close);
  nameButtons(*buttons);
  save_ = buttons->button(QDialogButtonBox::Save);
  save_->setObjectName(QStringLiteral("figure_save"));
  connect(save_, &QPushButton::clicked, this, &FigureDialog::save);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(bar_, 1);
  bottom->addWidget(stop_);
  bottom->addStretch(1);
  bottom->addWidget(buttons);
  auto* all = new QVBoxLayout(this);
  all->addLayout(columns, 1);
  all->addLayout(bottom);
  resizeToText(*this, {142, 37});
  delay_->setSingleShot(true);
  delay_->setInterval(kDelayMs);
  connect(delay_, &QTimer::timeout, this, &FigureDialog::preview);
  connect(&worker_, &LatestWorker::busyChanged, this, &FigureDialog::showBusy);
  showBusy(false);
  preview();
}

FigureDialog::~FigureDialog() {
  worker_.disconnect();
}

QWidget* FigureDialog::makeForm() {
  auto* form = new QWidget;
  auto* layout = new QFormLayout(form);
  layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
  addPage(layout);
  addRelief(layout);
  addStereo(layout);
  addMarks(layout);
  return form;
}

void FigureDialog::addPage(QFormLayout* layout) {
  file_ =
      field<QLineEdit>(layout, tr("&File"), "figure_file", tr("Ends in .png, .tif, .pdf or .svg"));
  auto* browse = new QPushButton(tr("Bro&wse\u2026"));
  browse->setObjectName(QStringLiteral("figure_browse"));
  browse->setAccessibleName(tr("Browse"));
  browse->setToolTip(tr("Choose another place"));
  browse->setAutoDefault(false);
  connect(browse, &QPushButton::clicked, this, [this] {
    const QString chosen = QFileDialog::getSaveFileName(this, tr("Save figure"), file_->text(),
                                                        tr("Figures (*.png *.tif *.pdf *.svg)"),
                                                        nullptr, QFileDialog::DontConfirmOverwrite);
    if (!chosen.isEmpty()) file_->setText(chosen);
  });
  layout->addRow(QString(), browse);
  layout_ = field<QComboBox>(layout, tr("&Layout"), "figure_layout", tr("What stands beside what"));
  fill(layout_, kLayouts);
  recording_ = field<QLineEdit>(layout, tr("&Recording"), "figure_recording",
                                tr("CSV file of a recording, for the plots"));
  width_ = field<QDoubleSpinBox>(layout, tr("Wi&dth on paper"), "figure_width",
                                 tr("Journals have columns of 85 and pages of 180 mm"));
  range(width_, 20, 2000, 1, QStringLiteral(" mm"));
  to_scale_ = field<QCheckBox>(layout, tr("To &scale"), "figure_to_scale",
                               tr("Choose the scale of the detail; the width follows from it"));
  scale_ = field<QDoubleSpinBox>(layout, tr("Scale &1 :"), "figure_scale",
                                 tr("Millimetres of object on one millimetre of paper"));
  range(scale_, 0.001, 100000, 3, {});
  scale_->setValue(1);
  dpi_ = field<QDoubleSpinBox>(layout, tr("D&ensity"), "figure_dpi", tr("Dots per inch of paper"));
  range(dpi_, 30, 2400, 0, tr(" dpi"));
  text_ = field<QDoubleSpinBox>(layout, tr("&Text size"), "figure_text",
                                tr("Text and bars on paper, in points"));
  range(text_, 4, 36, 1, tr(" pt"));
}

void FigureDialog::addRelief(QFormLayout* layout) {
  relief_ = field<QComboBox>(layout, tr("Rel&ief"), "figure_relief", tr("How heights are painted"));
  fill(relief_, kReliefs);
  colours_ = field<QComboBox>(layout, tr("Colours"), "figure_colours",
                              tr("Even steps of lightness, also for colour-blind readers"));
  for (const std::string_view name : kColourMapNames) {
    colours_->addItem(coreText(name));
  }
  azimuth_ = field<QDoubleSpinBox>(layout, tr("Light from"), "figure_azimuth",
                                   tr("0 is above, clockwise; 315 is the upper left"));
  range(azimuth_, 0, 360, 0, QStringLiteral("\u00b0"));
  azimuth_->setWrapping(true);
  elevation_ = field<QDoubleSpinBox>(layout, tr("Light's height"), "figure_elevation",
                                     tr("Low light brings out worn detail"));
  range(elevation_, 1, 90, 0, QStringLiteral("\u00b0"));
  radius_ = field<QDoubleSpinBox>(layout, tr("Radius"), "figure_radius",
                                  tr("Of the neighbourhood of local relief, sky view, openness"));
  range(radius_, 0, 1e6, 2, QStringLiteral(" mm"));
  radius_->setSpecialValueText(tr("10 samples"));
}

void FigureDialog::addStereo(QFormLayout* layout) {
  stereo_ = field<QComboBox>(layout, tr("Stereo"), "figure_stereo",
                             tr("For red and cyan glasses, or two pictures"));
  fill(stereo_, kStereos);
  eye_ = field<QDoubleSpinBox>(layout, tr("E&yes apart"), "figure_eye",
                               tr("Angle between the two eyes' directions"));
  range(eye_, 0.1, 20, 1, QStringLiteral("\u00b0"));
  comfort_ = field<QCheckBox>(layout, tr("Keep to 1\u00b0 of paralla&x"), "figure_comfort",
                              tr("Less angle where many readers would see double"));
  swap_ = field<QCheckBox>(layout, tr("Swap eyes"), "figure_swap",
                           tr("For glasses the other way round, or for crossed eyes"));
}

void FigureDialog::addMarks(QFormLayout* layout) {
  constexpr std::array<const char*, 8> kNames{
      "figure_scale_bar", "figure_height_bar", "figure_up",      "figure_outline",
      "figure_hatch",     "figure_legend",     "figure_letters", "figure_measurements"};
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    marks_[i] = field<QCheckBox>(layout, tr(kMarks[i].text), kNames[i],
                                 tr("Drawn in points, whatever the density"));
  }
  transparent_ = field<QCheckBox>(layout, tr("Tra&nsparent paper"), "figure_transparent",
                                  tr("No white behind the relief"));
}

void FigureDialog::showRequest(const FigureRequest& f) {
  const QSignalBlocker quiet(this);
  layout_->setCurrentIndex(static_cast<int>(f.layout));
  recording_->setText(QString::fromStdString(f.recording));
  width_->setValue(f.width_mm);
  to_scale_->setChecked(f.scale_1_to.has_value());
  if (f.scale_1_to) scale_->setValue(*f.scale_1_to);
  dpi_->setValue(f.dpi);
  text_->setValue(f.text_pt);
  relief_->setCurrentIndex(static_cast<int>(f.look.kind));
  colours_->setCurrentIndex(static_cast<int>(f.look.colours));
  azimuth_->setValue(f.look.light.azimuth_deg);
  elevation_->setValue(f.look.light.elevation_deg);
  radius_->setValue(f.look.radius_mm);
  stereo_->setCurrentIndex(static_cast<int>(f.stereo));
  eye_->setValue(f.eye_angle_deg);
  comfort_->setChecked(f.limit_parallax);
  swap_->setChecked(f.swap_eyes);
  transparent_->setChecked(f.transparent);
  const std::array<bool, 8> marks{f.scale_bar, f.height_bar, f.up_mark, f.window_outline,
                                  f.hatch,     f.legend,     f.letters, f.measurements};
  for (std::size_t i = 0; i < marks.size(); ++i) marks_[i]->setChecked(marks[i]);
  limit();
}

void FigureDialog::limit() {
  scale_->setEnabled(to_scale_->isChecked());
  width_->setEnabled(!to_scale_->isChecked());
  recording_->setEnabled(layout_->currentIndex() == static_cast<int>(FigureLayout::plot));
  const auto kind = static_cast<ReliefKind>(relief_->currentIndex());
  colours_->setEnabled(hasLegend(kind));
  const bool lamps = isLit(kind) || kind == ReliefKind::hillshade;
  azimuth_->setEnabled(lamps);
  elevation_->setEnabled(lamps || kind == ReliefKind::multi_hillshade);
  radius_->setEnabled(kind == ReliefKind::local_relief || kind == ReliefKind::sky_view ||
                      kind == ReliefKind::openness);
  const bool stereo = stereo_->currentIndex() != static_cast<int>(StereoPrint::off);
  for (QWidget* widget : {static_cast<QWidget*>(eye_), static_cast<QWidget*>(comfort_),
                          static_cast<QWidget*>(swap_)}) {
    widget->setEnabled(stereo);
  }
}

FigureRequest FigureDialog::request() const {
  FigureRequest f = project_.figure;
  f.layout = static_cast<FigureLayout>(layout_->currentIndex());
  f.recording = recording_->text().toStdString();
  f.width_mm = width_->value();
  f.scale_1_to = to_scale_->isChecked() ? std::optional(scale_->value()) : std::nullopt;
  f.dpi = dpi_->value();
  f.text_pt = text_->value();
  f.look.kind = static_cast<ReliefKind>(relief_->currentIndex());
  f.look.colours = static_cast<ColourMap>(colours_->currentIndex());
  f.look.light = {azimuth_->value(), elevation_->value()};
  f.look.radius_mm = radius_->value();
  f.stereo = static_cast<StereoPrint>(stereo_->currentIndex());
  f.eye_angle_deg = eye_->value();
  f.limit_parallax = comfort_->isChecked();
  f.swap_eyes = swap_->isChecked();
  f.transparent = transparent_->isChecked();
  const std::array<bool*, 8> marks{&f.scale_bar, &f.height_bar, &f.up_mark, &f.window_outline,
                                   &f.hatch,     &f.legend,     &f.letters, &f.measurements};
  for (std::size_t i = 0; i < marks.size(); ++i) *marks[i] = marks_[i]->isChecked();
  return f;
}

QString FigureDialog::file() const {
  return file_->text();
}

Project FigureDialog::wanted() const {
  Project project = project_;
  project.figure = request();
  return project;
}

void FigureDialog::changed() {
  if (!complete_) return;
  limit();
  Q_EMIT requestChanged(request());
  delay_->start();
}

void FigureDialog::preview() {
  if (writing_) return;
  const auto drawn = std::make_shared<Drawn>();
  worker_.start(
      [drawn, surface = surface_, project = wanted()](const Task& task) {
        drawn->error = errorOf([&] {
          drawn->figure = previewFigure(*surface, project, kPreviewPx, task);
          drawn->facts = drawn->figure.facts;
        });
      },
      [this, drawn] {
        problem_->setVisible(!drawn->error.isEmpty());
        problem_->setText(drawn->error);
        save_->setEnabled(drawn->error.isEmpty());
        const RgbaImage& image = drawn->figure.image;
        if (image.rgba.empty()) return;
        const QImage shown(image.rgba.data(), image.width, image.height, 4 * image.width,
                           QImage::Format_RGBA8888_Premultiplied);
        picture_->setPixmap(QPixmap::fromImage(shown).scaled(picture_->size(), Qt::KeepAspectRatio,
                                                             Qt::SmoothTransformation));
        showFacts(drawn->facts);
      });
}

void FigureDialog::showFacts(const FigureFacts& facts) {
  QString text = tr("%1 \u00d7 %2 mm on paper, %3 \u00d7 %4 pixels, scale 1 : %5")
                     .arg(numberText(facts.width_mm, 1), numberText(facts.height_mm, 1))
                     .arg(facts.width_px)
                     .arg(facts.height_px)
                     .arg(numberText(1 / facts.paper_per_mm, 3));
  if (facts.eye_angle_deg > 0) {
    text += tr(". Parallax %1\u00b0 of %2\u00b0 with %3\u00b0 between the eyes")
                .arg(numberText(facts.parallax_deg, 2), numberText(kComfortDeg, 1),
                     numberText(facts.eye_angle_deg, 1));
  }
  facts_->setText(text + '.');
  caption_->setPlainText(QString::fromStdString(facts.caption));
}

void FigureDialog::save() {
  const QFileInfo target(file_->text());
  const QString folder = target.absolutePath();
  if (folder == own_folder_) QDir().mkpath(folder);
  if (!QFileInfo(folder).isDir()) {
    problem_->setText(tr("There is no folder %1. Nothing was written. Choose another, or make it.")
                          .arg(QDir::toNativeSeparators(folder)));
    problem_->show();
    return;
  }
  if (!target.exists()) {
    write();
    return;
  }
  auto* box = new QMessageBox(QMessageBox::Warning, tr("Replace figure"),
                              tr("%1 exists already in %2. Replace it?")
                                  .arg(target.fileName(), QDir::toNativeSeparators(folder)),
                              QMessageBox::Cancel, this);
  box->setObjectName(QStringLiteral("figure_replace"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setAccessibleName(box->windowTitle());
  nameButtons(*box->findChild<QDialogButtonBox*>());
  auto* replace = box->addButton(tr("&Replace"), QMessageBox::AcceptRole);
  replace->setAccessibleName(tr("Replace"));
  box->setDefaultButton(QMessageBox::Cancel);
  box->setEscapeButton(QMessageBox::Cancel);
  connect(replace, &QPushButton::clicked, this, &FigureDialog::write);
  box->open();
}

void FigureDialog::write() {
  delay_->stop();
  const QString target = file_->text();
  const auto drawn = std::make_shared<Drawn>();
  const auto stopped = std::make_shared<bool>(true);
  writing_ = true;
  worker_.start(
      [drawn, stopped, surface = surface_, project = wanted(), target](const Task& task) {
        drawn->error = errorOf([&] {
          drawn->facts =
              writeFigure(*surface, project, QFile::encodeName(target).toStdString(), task);
          *stopped = false;
        });
      },
      [this, drawn, stopped, target] {
        problem_->setVisible(!drawn->error.isEmpty());
        problem_->setText(drawn->error);
        if (*stopped) return;
        Q_EMIT written(target);
        accept();
      });
}

void FigureDialog::stop() {
  if (writing_) {
    problem_->setText(tr("Stopped. Nothing was written."));
    problem_->show();
  }
  worker_.cancel();
}

void FigureDialog::done(int result) {
  worker_.outliveJob(*this);
  QDialog::done(result);
}

void FigureDialog::showBusy(bool busy) {
  if (!busy) writing_ = false;
  bar_->setVisible(busy);
  stop_->setVisible(busy);
}

}  // namespace relievo
