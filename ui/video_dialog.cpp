// SPDX-License-Identifier: BSD-3-Clause
#include "ui/video_dialog.h"

#include <algorithm>
#include <array>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>

#include "ui/core_words.h"
#include "ui/mnemonic.h"

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
  return widget;
}

}  // namespace

VideoDialog::VideoDialog(const QSize& view_px, bool can_pack, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("video_options_dialog"));
  setWindowTitle(tr("Video"));
  auto* form = new QFormLayout(this);
  profile_ = field<QComboBox>(form, tr("&For"), "video_profile",
                              tr("How the pictures are packed: small, or without loss"));
  // In the order of VideoProfile.
  const QStringList profiles{tr("Talk: plays everywhere"), tr("Archive: every pixel comes back"),
                             tr("Anaglyph: for red and cyan glasses"),
                             tr("Images: a folder of pictures")};
  for (int i = can_pack ? 0 : static_cast<int>(VideoProfile::images); i < profiles.size(); ++i) {
    profile_->addItem(profiles[i], i);
  }
  size_ = field<QComboBox>(form, tr("&Size"), "video_size", tr("Of each picture, in pixels"));
  for (const QSize& size : kSizes) {
    size_->addItem(QStringLiteral("%1 \u00d7 %2").arg(size.width()).arg(size.height()), size);
  }
  const QSize view = possible(view_px);
  size_->addItem(tr("As the detail view: %1 \u00d7 %2").arg(view.width()).arg(view.height()), view);
  fps_ = field<QDoubleSpinBox>(form, tr("&Pictures a second"), "video_fps",
                               tr("30 look smooth; 24 to 60 are usual"));
  fps_->setRange(1, 120);
  fps_->setDecimals(0);
  fps_->setValue(VideoRequest{}.fps);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  auto* next = buttons->addButton(tr("&Choose file\u2026"), QDialogButtonBox::AcceptRole);
  next->setObjectName(QStringLiteral("video_next"));
  next->setDefault(true);
  nameButtons(*buttons);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

VideoRequest VideoDialog::request() const {
  VideoRequest chosen;
  chosen.profile = static_cast<VideoProfile>(profile_->currentData().toInt());
  const QSize pixels = size_->currentData().toSize();
  chosen.width_px = pixels.width();
  chosen.height_px = pixels.height();
  chosen.fps = fps_->value();
  return chosen;
}

}  // namespace relievo
