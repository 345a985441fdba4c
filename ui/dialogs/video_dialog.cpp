// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/video_dialog.h"

#include <algorithm>
#include <array>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <utility>

#include "core/relief/eye_angle.h"
#include "ui/language/core_text.h"
#include "ui/style/dialog_size.h"
#include "ui/style/mnemonic.h"

namespace relievo {
namespace {

constexpr std::array<QSize, 3> kSizes{{{1280, 720}, {1920, 1080}, {3840, 2160}}};
constexpr int kLeastPx = 64, kMostPx = 4096;

/// Within a video's limits; its sides are even.
QSize possible(const QSize& pixels) {
  const auto side = [](int px) { return std::clamp(px / 2 * 2, kLeastPx, kMostPx); };
  return {side(pixels.width()), side(pixels.height())};
}

template <class Widget>
Widget* field(QFormLayout* form, const QString& title, const char* name, const QString& tip) {
  auto* widget = new Widget;
  widget->setObjectName(QString::fromLatin1(name));
  widget->setAccessibleName(withoutMnemonic(title));
  widget->setToolTip(tip);
  form->addRow(title, widget);
  // A letter that is underlined stands farther from its neighbours than a label reckons.
  auto* label = form->labelForField(widget);
  label->setMinimumWidth(label->sizeHint().width() + label->fontMetrics().averageCharWidth());
  return widget;
}

}  // namespace

VideoDialog::VideoDialog(const Start& start, QWidget* parent) : QDialog(parent), start_(start) {
  setObjectName(QStringLiteral("video_options_dialog"));
  setWindowTitle(tr("Video"));
  auto* page = new QWidget;
  auto* form = new QFormLayout(page);
  addPacking(form);
  addPart(form);
  addContent(form);
  addStereo(form);
  connect(profile_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this] { showStereoFor(static_cast<VideoProfile>(profile_->currentData().toInt())); });
  showStereoFor(static_cast<VideoProfile>(profile_->currentData().toInt()));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  auto* next = buttons->addButton(tr("&Choose file\u2026"), QDialogButtonBox::AcceptRole);
  next->setObjectName(QStringLiteral("video_next"));
  next->setDefault(true);
  nameButtons(*buttons);
  auto* scroll = new QScrollArea;
  scroll->setWidget(page);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  // As wide as the longest choice, where the screen is.
  const int wide =
      page->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width();
  scroll->setMinimumWidth(std::min(wide, screen()->availableSize().width() * 4 / 5));
  auto* column = new QVBoxLayout(this);
  column->addWidget(scroll, 1);
  column->addWidget(buttons);
  resizeToText(*this, {56, 31});
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void VideoDialog::addPacking(QFormLayout* form) {
  profile_ = field<QComboBox>(form, tr("&For"), "video_profile",
                              tr("How the pictures are packed: small, or without loss"));
  // In the order of VideoProfile.
  const QStringList profiles{tr("Talk: plays everywhere"), tr("Archive: every pixel comes back"),
                             tr("Anaglyph: for red and cyan glasses"),
                             tr("Images: a folder of pictures")};
  const int first = start_.can_pack ? 0 : static_cast<int>(VideoProfile::images);
  for (int i = first; i < profiles.size(); ++i) profile_->addItem(profiles[i], i);
  size_ = field<QComboBox>(form, tr("&Size"), "video_size", tr("Of each picture, in pixels"));
  for (const QSize& size : kSizes) {
    size_->addItem(QStringLiteral("%1 \u00d7 %2").arg(size.width()).arg(size.height()), size);
  }
  const QSize view = possible(start_.view_px);
  size_->addItem(tr("As the detail view: %1 \u00d7 %2").arg(view.width()).arg(view.height()), view);
  fps_ = field<QDoubleSpinBox>(form, tr("&Pictures a second"), "video_fps",
                               tr("30 look smooth; 24 to 60 are usual"));
  fps_->setRange(1, 120);
  fps_->setDecimals(0);
  fps_->setValue(VideoRequest{}.fps);
}

void VideoDialog::addPart(QFormLayout* form) {
  speed_ = field<QDoubleSpinBox>(form, tr("Sp&eed"), "video_speed",
                                 tr("1 as it was; 0.25 four times slower"));
  speed_->setRange(0.01, 100);
  speed_->setSingleStep(0.25);
  speed_->setSuffix(QStringLiteral(" \u00d7"));
  speed_->setValue(start_.request.speed);
  from_ = field<QDoubleSpinBox>(form, tr("F&rom"), "video_from",
                                tr("Where it begins, since the start of recording or path"));
  to_ = field<QDoubleSpinBox>(form, tr("&To"), "video_to",
                              tr("Where it ends, since the start of recording or path"));
  for (QDoubleSpinBox* time : {from_, to_}) {
    time->setRange(0, start_.duration_s);
    time->setSuffix(tr(" s"));
  }
  to_->setValue(start_.duration_s);
  connect(from_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), to_,
          [this](double from) { to_->setMinimum(from); });
}

void VideoDialog::addContent(QFormLayout* form) {
  const auto box = [form](const QString& title, const char* name, const QString& tip) {
    auto* made = new QCheckBox(title);
    made->setObjectName(QString::fromLatin1(name));
    made->setAccessibleName(withoutMnemonic(title));
    made->setToolTip(tip);
    made->setChecked(true);
    form->addRow(QString(), made);
    return made;
  };
  plots_ = box(tr("P&lots"), "video_plots", tr("Height of hand and proxy, and the force, below"));
  overview_ = box(tr("&Whole object"), "video_overview",
                  tr("The whole object with the pink window, beside the detail"));
  scale_bar_ =
      box(tr("Scale &bar"), "video_scale_bar", tr("How long a millimetre is in the detail"));
  sound_ = box(tr("So&und"), "video_sound",
               tr("What the hand met, at its time: clicks, rustling and the tone of heights; a "
                  "folder of pictures has none"));
  enableSound();
  connect(profile_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &VideoDialog::enableSound);
  for (QCheckBox* of_recording : {plots_, overview_}) {
    of_recording->setChecked(start_.recording);
    of_recording->setEnabled(start_.recording);
  }
  along_path_ = box(tr("Along the camera pat&h"), "video_along_path",
                    tr("The camera passes the key views; else it looks at the recorded window"));
  along_path_->setChecked(!start_.recording);
  along_path_->setEnabled(start_.recording && start_.request.path);
}

void VideoDialog::addStereo(QFormLayout* form) {
  stereo_ = field<QComboBox>(form, tr("Stere&o"), "video_stereo",
                             tr("Red and cyan pictures; not for talks, whose colours are halved"));
  for (const auto& [text, value] : {std::pair{tr("Off"), StereoPrint::off},
                                    {tr("Grey"), StereoPrint::grey},
                                    {tr("Half colour"), StereoPrint::half_colour},
                                    {tr("Dubois"), StereoPrint::dubois},
                                    {tr("Side by side"), StereoPrint::side_by_side},
                                    {tr("Over and under"), StereoPrint::over_under},
                                    {tr("Interlaced"), StereoPrint::interlaced}}) {
    stereo_->addItem(text, static_cast<int>(value));
  }
  angle_ = field<QDoubleSpinBox>(form, tr("Eye sep&aration"), "video_eye_angle",
                                 tr("Angle between the two eyes' directions"));
  angle_->setRange(kLeastEyeAngleDeg, kMostEyeAngleDeg);
  angle_->setSingleStep(0.5);
  angle_->setSuffix(QStringLiteral("\u00b0"));
  angle_->setValue(start_.request.eye_angle_deg);
  swap_ = new QCheckBox(tr("Swap e&yes"));
  swap_->setObjectName(QStringLiteral("video_swap_eyes"));
  swap_->setAccessibleName(withoutMnemonic(swap_->text()));
  swap_->setToolTip(tr("For glasses whose red filter is at the right eye"));
  swap_->setChecked(start_.request.swap_eyes);
  form->addRow(QString(), swap_);
  both_eyes_ = new QCheckBox(tr("Both eyes as f&iles"));
  both_eyes_->setObjectName(QStringLiteral("video_both_eyes"));
  both_eyes_->setAccessibleName(withoutMnemonic(both_eyes_->text()));
  both_eyes_->setToolTip(
      tr("Also each eye's video as a file of its own: NAME.left.mp4 and NAME.right.mp4"));
  form->addRow(QString(), both_eyes_);
  connect(stereo_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &VideoDialog::enableEyes);
  connect(both_eyes_, &QCheckBox::toggled, this, &VideoDialog::enableEyes);
}

void VideoDialog::enableEyes() {
  const bool eyes = stereo_->currentIndex() > 0 || both_eyes_->isChecked();
  angle_->setEnabled(eyes);
  swap_->setEnabled(eyes);
}

void VideoDialog::enableSound() {
  const bool is_folder = profile_->currentData().toInt() == static_cast<int>(VideoProfile::images);
  const bool possible = start_.recording && start_.can_sound && !is_folder;
  sound_->setEnabled(possible);
  sound_->setChecked(possible && start_.request.sound);
}

bool VideoDialog::bothEyes() const {
  return both_eyes_->isChecked();
}

void VideoDialog::showStereoFor(VideoProfile profile) {
  const bool possible = profile != VideoProfile::talk;
  stereo_->setEnabled(possible);
  if (!possible) stereo_->setCurrentIndex(0);
  const bool missing = profile == VideoProfile::anaglyph && stereo_->currentIndex() == 0;
  if (missing) stereo_->setCurrentIndex(1);
  enableEyes();
}

VideoRequest VideoDialog::request() const {
  VideoRequest chosen = start_.request;
  chosen.profile = static_cast<VideoProfile>(profile_->currentData().toInt());
  const QSize pixels = size_->currentData().toSize();
  chosen.width_px = pixels.width();
  chosen.height_px = pixels.height();
  chosen.fps = fps_->value();
  chosen.speed = speed_->value();
  // The ends are rounded in their fields; the whole is the whole.
  if (from_->value() > 0) chosen.from_s = from_->value();
  if (to_->value() < to_->maximum()) chosen.to_s = to_->value();
  if (!along_path_->isChecked()) chosen.path.reset();
  chosen.plots = plots_->isChecked();
  chosen.overview = overview_->isChecked();
  chosen.scale_bar = scale_bar_->isChecked();
  chosen.sound = sound_->isChecked();
  chosen.stereo = static_cast<StereoPrint>(stereo_->currentData().toInt());
  chosen.eye_angle_deg = angle_->value();
  chosen.swap_eyes = swap_->isChecked();
  return chosen;
}

}  // namespace relievo
