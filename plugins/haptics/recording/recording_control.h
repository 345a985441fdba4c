// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QObject>
#include <QPointer>
#include <QString>

#include "core/region/region_window.h"
#include "core/session/firmness.h"
#include "plugins/haptics/device/hand_device.h"
#include "plugins/haptics/recording/note_dialog.h"
#include "plugins/haptics/touch_parts.h"

namespace relievo {

/// Recordings of what the hand does: start, end, notes into them, and what is said of them. All
/// calls: GUI thread.
class RecordingControl : public QObject {
  Q_OBJECT
 public:
  RecordingControl(TouchParts& parts, HandDevice& device) : parts_(parts), device_(device) {}

  void setRecording(bool on);
  /// Waits until the running one is on the disk. Before its loop goes.
  void end();
  /// What was said of a fault: what is said of its flight record, a moment later, begins with it,
  /// because of two sentences the newest wins.
  void setFault(const QString& sentence) { fault_ = sentence; }
  /// Says what became of a recording. Once a frame.
  void watch();
  /// Of the running recording, or of the next.
  QString folder() const;
  bool isRunning() const;

  /// Another window is under the hand.
  void addWindow(const RegionWindow& window);
  /// What says where the ground is firm, for the headers of the next recordings; null: the origins.
  void setFirmness(std::shared_ptr<const FirmnessMap> firmness) { firmness_ = std::move(firmness); }
  /// Opens the dialog for a note of the present tick.
  void askNote();

 Q_SIGNALS:
  void noted();  ///< A note is in the recording.

 private:
  void start();
  void addNote();
  void tellFlight(const RecordingEnd& flight);

  TouchParts& parts_;
  HandDevice& device_;
  QString folder_;        // The running recording's.
  QString window_lines_;  // For the running recording's end.
  QString fault_;         // Whose flight record is being written; empty: none.
  std::shared_ptr<const FirmnessMap> firmness_;
  QPointer<NoteDialog> note_;
};

}  // namespace relievo
