// SPDX-License-Identifier: BSD-3-Clause
// The fields of the figure dialog.
#include <algorithm>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QStandardItemModel>

#include "core/session/colours/surface_colours.h"
#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/dialogs/figure/figure_number.h"
#include "ui/language/core_words.h"
#include "ui/style/mnemonic.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr int kLeastCharacters = 16;  // That a field shows ...
constexpr int kMostCharacters = 34;   // ... or more, where the screen is wide.
constexpr double kFarMm = 1e9;        // Maps of countries have such heights and scales.

struct Words {
  const char* text;
};
constexpr std::array<Words, 5> kLayouts{
    {{QT_TRANSLATE_NOOP("relievo::FigureDialog", "Detail alone")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Whole object and detail")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "As measured and filled")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Several levels")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "With force plots of a recording")}}};
constexpr std::array<Words, kReliefKindNames.size()> kReliefs{
    {{QT_TRANSLATE_NOOP("relievo::FigureDialog", "Shaded relief")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Height in colour")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Hillshade")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Hillshade, four lights")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Slope")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Local relief")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Sky-view factor")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Openness")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Deviation, several scales")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Curvature, several scales")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Stone with ambient occlusion")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Natural colours")},
     {QT_TRANSLATE_NOOP("relievo::FigureDialog", "Intensity")}}};
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

}  // namespace

/// Where a file is chosen.
struct FigureDialog::Place {
  QString title, filter;  ///< Of the dialog that "..." opens.
  bool new_file = true;   ///< Or one that exists.
};

template <class Widget>
Widget* FigureDialog::field(QFormLayout* layout, const QString& title, const char* name,
                            const QString& tip) {
  auto* widget = new Widget;
  describe(widget, title, name, tip);
  if constexpr (std::is_base_of_v<QCheckBox, Widget>) {
    widget->setText(title);
    layout->addRow(widget);
    connect(widget, &QCheckBox::toggled, this, &FigureDialog::changed);
  } else {
    widget->setMinimumWidth(fieldWidth(*this));
    layout->addRow(new FieldLabel(title, widget), widget);
  }
  if constexpr (std::is_base_of_v<QComboBox, Widget>) {
    widget->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(widget, QOverload<int>::of(&QComboBox::activated), this, &FigureDialog::changed);
  } else if constexpr (std::is_base_of_v<FigureNumber, Widget>) {
    connect(widget, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &FigureDialog::changed);
  }
  return widget;
}

QLineEdit* FigureDialog::place(QFormLayout* layout, const QString& title, const char* name,
                               const QString& tip, const Place& chosen_in) {
  auto* path = new QLineEdit;
  describe(path, title, name, tip);
  auto* choose = new QPushButton(QStringLiteral("\u2026"));
  describe(choose, tr("Browse: %1").arg(withoutMnemonic(title)),
           (QByteArray(name) + "_browse").constData(), tr("Choose another place"));
  if (!chosen_in.new_file) choose->setToolTip(tip);
  choose->setAutoDefault(false);
  // No wider than its text, which leaves the room to the path.
  choose->setMaximumWidth(6 * fontMetrics().averageCharWidth() + 8);
  auto* both = new QWidget;
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(path, 1);
  row->addWidget(choose);
  both->setMinimumWidth(fieldWidth(*this));
  layout->addRow(new FieldLabel(title, path), both);
  connect(path, &QLineEdit::editingFinished, this, &FigureDialog::changed);
  connect(choose, &QPushButton::clicked, this,
          [this, path, chosen_in] { browse(path, chosen_in); });
  return path;
}

void FigureDialog::browse(QLineEdit* field, const Place& chosen_in) {
  const QString near = field->text().isEmpty() ? pathFromBytes(project_.file) : field->text();
  auto* dialog = new QFileDialog(this, chosen_in.title, QFileInfo(near).path(), chosen_in.filter);
  dialog->setObjectName(field->objectName() + QLatin1String("_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  if (chosen_in.new_file) {
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setOption(QFileDialog::DontConfirmOverwrite);  // Asked for when it is written.
  } else {
    dialog->setFileMode(QFileDialog::ExistingFile);
  }
  if (!field->text().isEmpty()) dialog->selectFile(field->text());
  connect(dialog, &QFileDialog::fileSelected, this, [this, field](const QString& file) {
    field->setText(file);
    field->setModified(true);
    changed();
  });
  dialog->open();
}

QWidget* FigureDialog::makeForm() {
  auto* form = new QWidget;
  auto* layout = new QFormLayout(form);
  layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
  addPage(layout);
  addRelief(layout);
  addRange(layout);
  addStereo(layout);
  addMarks(layout);
  addFiles(layout);
  return form;
}

void FigureDialog::addPage(QFormLayout* layout) {
  file_ = place(layout, tr("&File"), "figure_file", tr("Ends in .png, .tif, .pdf or .svg"),
                {tr("Save figure"), tr("Figures (*.png *.tif *.pdf *.svg)")});
  connect(file_, &QLineEdit::textChanged, this, &FigureDialog::suggestNames);
  layout_ = field<QComboBox>(layout, tr("&Layout"), "figure_layout", tr("What stands beside what"));
  fill(layout_, kLayouts);
  recording_ = place(layout, tr("&Recording"), "figure_recording",
                     tr("File of a recording, CSV or HDF5, for the plots"),
                     {tr("Recording"), tr("Recordings (*.csv *.h5 *.hdf5)"), false});
  width_ = field<FigureNumber>(layout, tr("Wi&dth on paper"), "figure_width",
                               tr("Journals have columns of 85 and pages of 180 mm"));
  width_->setLimits(20, 2000, 1, QStringLiteral(" mm"));
  to_scale_ = field<QCheckBox>(layout, tr("To &scale"), "figure_to_scale",
                               tr("Choose the scale of the detail; the width follows from it"));
  scale_ = field<FigureNumber>(layout, tr("Scale &1 :"), "figure_scale",
                               tr("Millimetres of object on one millimetre of paper"));
  scale_->setLimits(0.001, kFarMm, 3, {});
  scale_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  scale_->setValue(1);
  dpi_ = field<FigureNumber>(layout, tr("D&ensity"), "figure_dpi", tr("Dots per inch of paper"));
  dpi_->setLimits(30, 2400, 0, tr(" dpi"));
  text_ = field<FigureNumber>(layout, tr("&Text size"), "figure_text",
                              tr("Text and bars on paper, in points"));
  text_->setLimits(4, 36, 1, tr(" pt"));
}

void FigureDialog::addRelief(QFormLayout* layout) {
  relief_ = field<QComboBox>(layout, tr("Rel&ief"), "figure_relief", tr("How heights are painted"));
  fill(relief_, kReliefs);
  for (std::size_t i = 0; i < kReliefs.size(); ++i) {
    if (canShow(*surface_, static_cast<ReliefKind>(i))) continue;
    auto* items = qobject_cast<QStandardItemModel*>(relief_->model());
    QStandardItem* item = items->item(static_cast<int>(i));
    item->setEnabled(false);
    item->setToolTip(tr("This scan has none"));
  }
  colours_ = field<QComboBox>(layout, tr("Colours"), "figure_colours",
                              tr("Even steps of lightness, also for colour-blind readers"));
  for (const std::string_view name : kColourMapNames) {
    colours_->addItem(coreText(name));
  }
  azimuth_ = field<FigureNumber>(layout, tr("Light from"), "figure_azimuth",
                                 tr("0 is above, clockwise; 315 is the upper left"));
  azimuth_->setLimits(0, 360, 0, QStringLiteral("\u00b0"));
  azimuth_->setWrapping(true);
  elevation_ = field<FigureNumber>(layout, tr("Light's height"), "figure_elevation",
                                   tr("Low light brings out worn detail"));
  elevation_->setLimits(0, 90, 0, QStringLiteral("\u00b0"));
  radius_ = field<FigureNumber>(layout, tr("Radius"), "figure_radius",
                                tr("Of the neighbourhood that this relief image looks at"));
  radius_->setLimits(0, kFarMm, 2, QStringLiteral(" mm"));
  radius_->setSpecialValueText(tr("10 samples"));
  shading_ = field<FigureNumber>(layout, tr("Shading"), "figure_shading",
                                 tr("How much relief shading natural colours and intensity get"));
  shading_->setLimits(0, 100, 0, QStringLiteral(" %"));
}

void FigureDialog::addRange(QFormLayout* layout) {
  own_range_ = field<QCheckBox>(layout, tr("O&wn ends of the colours"), "figure_range_on",
                                tr("The same colours for the same values in several figures; "
                                   "otherwise they follow from what is shown"));
  range_low_ = field<FigureNumber>(layout, tr("Colours from"), "figure_range_low",
                                   tr("Value at the colours' lower end"));
  range_high_ = field<FigureNumber>(layout, tr("Colours to"), "figure_range_high",
                                    tr("Value at the colours' upper end"));
  for (FigureNumber* end : {range_low_, range_high_}) {
    end->setLimits(-kFarMm, kFarMm, 1, {});
    end->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  }
  // The ends of one quantity say nothing about another.
  connect(relief_, QOverload<int>::of(&QComboBox::activated), this, [this](int kind) {
    if (kind != shown_relief_) own_range_->setChecked(false);
    shown_relief_ = kind;
  });
}

void FigureDialog::addStereo(QFormLayout* layout) {
  stereo_ = field<QComboBox>(layout, tr("Stereo"), "figure_stereo",
                             tr("For red and cyan glasses, or two pictures"));
  fill(stereo_, kStereos);
  eye_ = field<FigureNumber>(layout, tr("Eyes apart"), "figure_eye",
                             tr("Angle between the two eyes' directions"));
  eye_->setLimits(0.01, 20, 1, QStringLiteral("\u00b0"));
  comfort_ = field<QCheckBox>(layout, tr("&Keep to 1\u00b0 of parallax"), "figure_comfort",
                              tr("Less angle where many readers would see double"));
  own_zero_plane_ = field<QCheckBox>(layout, tr("Own &zero plane"), "figure_zero_plane_on",
                                     tr("Choose the height that lies in the plane of the paper; "
                                        "otherwise it is mid height"));
  zero_plane_ = field<FigureNumber>(layout, tr("Zero plane"), "figure_zero_plane",
                                    tr("Height of zero parallax: what is higher stands out of the "
                                       "paper, what is lower lies behind it"));
  zero_plane_->setLimits(-kFarMm, kFarMm, 1, QStringLiteral(" mm"));
  zero_plane_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
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

void FigureDialog::addFiles(QFormLayout* layout) {
  both_eyes_ = field<QCheckBox>(layout, tr("Both eyes &as files"), "figure_both_eyes",
                                tr("Also write the detail as each eye sees it, as NAME.left.png "
                                   "and NAME.right.png beside the figure"));
  heights_too_ = field<QCheckBox>(layout, tr("Sa&ve heights too"), "figure_heights_on",
                                  tr("Also write the detail's heights as a picture of 16 bits; its "
                                     "description says millimetres per step"));
  heights_file_ = place(layout, tr("Heights"), "figure_heights", tr("Ends in .tif"),
                        {tr("Save heights"), tr("Heights of 16 bits (*.tif *.tiff)")});
  caption_too_ = field<QCheckBox>(layout, tr("Save caption as te&xt"), "figure_caption_on",
                                  tr("Also write the caption as a text file"));
  caption_file_ =
      place(layout, tr("Caption's file"), "figure_caption_file", tr("Where the caption is written"),
            {tr("Save caption"), tr("Text (*.txt)")});
}

}  // namespace relievo
