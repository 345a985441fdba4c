// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "core/replay/sound_track.h"
#include "core/replay/video_request.h"
#include "ui/dialogs/video_control.h"
#include "ui/views/path_preview.h"
#include "ui/window/controller.h"

namespace relievo {

class DetailView;
class ReplayControl;
class TimePlot;

/// Videos of a replay, of a camera path and of the view, and the path itself. [GUI thread]
class VideoController : public Controller {
  Q_OBJECT
 public:
  VideoController(const ControllerParts& parts, DetailView& detail, TimePlot& plot,
                  ReplayControl& replay);

  /// A video of the replay, or of the camera path, in the background.
  /// @param chosen  light and relief image are as the view shows them
  /// @param both_eyes  each eye's video as a file of its own, too
  void write(const VideoRequest& chosen, const QString& file, bool both_eyes = false);
  /// What makes the sound of a recording's video; without it videos are silent.
  void setSound(SoundTrackOf sound) { sound_ = std::move(sound); }
  VideoControl& control() { return video_; }
  PathPreview& preview() { return preview_; }
  VideoControl::LiveSource liveSource();  ///< What a video of the view shows.
  /// What its commands can do has changed.
  void enable();

 private:
  void makeCommands();
  bool hasPath() const;
  void choose();
  void chooseFile(const VideoRequest& chosen, bool both_eyes);
  void setLive(bool on);
  void addKeyView();
  void previewPath();
  void showPathView(const ViewState& view);

  DetailView& detail_;
  TimePlot& plot_;
  ReplayControl& replay_;
  SoundTrackOf sound_;
  PathPreview preview_;
  double azimuth_before_deg_ = 0, elevation_before_deg_ = 0;  ///< The turn before the preview.
  VideoControl video_;
};

}  // namespace relievo
