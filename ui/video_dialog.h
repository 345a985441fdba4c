// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>

#include "core/replay/video_request.h"

class QComboBox;
class QDoubleSpinBox;

namespace relievo {

/// Asks what a video is for, how large its pictures are and how many a second; the same choices as
/// `relievo video --profile --size --fps`. [GUI thread]
class VideoDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param view_px   of the detail view, offered beside the usual sizes
  /// @param can_pack  false: there is no ffmpeg; pictures alone
  VideoDialog(const QSize& view_px, bool can_pack, QWidget* parent);

  /// Profile, size and rate as chosen.
  VideoRequest request() const;

 private:
  QComboBox *profile_, *size_;
  QDoubleSpinBox* fps_;
};

}  // namespace relievo
