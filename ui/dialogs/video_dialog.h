// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>

#include "core/replay/video_request.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace relievo {

/// Asks what a video is for, which part of the recording it shows and what stands in its pictures;
/// the same choices as `relievo video` has, but for how the relief is painted and lit: that is as
/// in the view. [GUI thread]
class VideoDialog : public QDialog {
  Q_OBJECT
 public:
  struct Start {
    QSize view_px;           ///< Of the detail view, offered beside the usual sizes.
    bool can_pack = true;    ///< False: there is no ffmpeg; pictures alone.
    bool can_sound = false;  ///< Sound can be made of recordings.
    bool recording = false;  ///< False: a camera path alone, which has no plots and no overview.
    double duration_s = 0;   ///< Of recording or path.
    VideoRequest request;    ///< Speed, eyes and path as they are now.
  };
  VideoDialog(const Start& start, QWidget* parent);

  /// As chosen; what the dialog does not ask for is as it was.
  VideoRequest request() const;
  bool bothEyes() const;  ///< Each eye's video, too.

 private:
  void addPacking(QFormLayout* form);
  void addPart(QFormLayout* form);
  void addContent(QFormLayout* form);
  void addStereo(QFormLayout* form);
  /// A profile that halves the colours' size cannot keep two eyes apart.
  void showStereoFor(VideoProfile profile);
  void enableEyes();
  void enableSound();

  Start start_;
  QComboBox *profile_ = nullptr, *size_ = nullptr, *stereo_ = nullptr;
  QDoubleSpinBox *fps_ = nullptr, *speed_ = nullptr, *from_ = nullptr, *to_ = nullptr,
                 *angle_ = nullptr;
  QCheckBox *plots_ = nullptr, *overview_ = nullptr, *scale_bar_ = nullptr, *along_path_ = nullptr,
            *swap_ = nullptr, *both_eyes_ = nullptr, *sound_ = nullptr;
};

}  // namespace relievo
