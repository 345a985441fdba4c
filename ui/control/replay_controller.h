// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ui/panels/replay_control.h"
#include "ui/window/controller.h"
#include "ui/work/work_queue.h"

namespace relievo {

class DetailView;
class OpenController;
class TouchController;

/// Comment lines about input, unit, view and region for the header of a recording in `file`.
QString recordingHeader(const Document& document, const QString& file);

/// Recordings: where they go, which of them belong to the work, and showing one again, with the map
/// that it needs. [GUI thread]
class ReplayController : public Controller {
  Q_OBJECT
 public:
  ReplayController(const ControllerParts& parts, ReplayControl& replay, DetailView& detail,
                   TouchController& touch, OpenController& opening);

  ReplayControl& control() { return replay_; }
  WorkQueue& noting() { return work_; }  ///< Where saved recordings are added to the work.
  /// Who reads recordings in place of core's readRecording.
  void setReader(RecordingReader reader);
  /// Shows a recording on the open map, or offers to open the one it was made on.
  void open(const QString& file);
  /// A recording of the open map is on the disk: from now on it belongs to the work.
  void noteRecording(const QString& file);
  QString ending() const;  ///< Of names of recordings: "csv" or "h5", as chosen.
  /// Where they go: as chosen, else relievo in the documents folder; empty: there is none.
  QString folder() const;
  void showKind();  ///< The next recording's, as chosen.

 Q_SIGNALS:
  /// A recording is shown, or no longer; before the focus moves.
  void shownChanged(bool shown);
  /// A recording is on the disk; its place in the work is noted next.
  void recordingNoted(const QString& file);

 private:
  void makeCommands();
  void choose();
  void chooseFolder();
  void askForFolder();
  void showReplaying(bool on);
  void offerRecordedMap(const QString& sentence);
  void openRecordedMap(const QString& file);
  void openOld(const Project& project);

  ReplayControl& replay_;
  DetailView& detail_;
  TouchController& touch_;
  OpenController& opening_;
  WorkQueue work_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
