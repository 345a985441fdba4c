// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <QObject>
#include <QStringList>

#include "core/project/recording.h"
#include "ui/panels/replay_player.h"
#include "ui/work/latest_worker.h"

namespace relievo {

class Document;
class ReplayPanel;

/// Reads a recording. [worker] @throw Error
using RecordingReader =
    std::function<TouchRecording(const std::filesystem::path&, const Task& task)>;

/// Replays a recording on the open map: the window follows the recorded one, hand and proxy are
/// drawn where they were. Nothing is felt; no device hears of it. [GUI thread]
class ReplayControl : public QObject {
  Q_OBJECT
 public:
  explicit ReplayControl(Document& document, QObject* parent = nullptr);
  ~ReplayControl() override;

  ReplayPlayer& player() { return player_; }
  ReplayPanel* panel() { return panel_; }  ///< The window's layout owns it.
  void setReader(RecordingReader reader) { reader_ = std::move(reader); }

  /// Reads a file, then shows it, or says what it would need.
  void open(const QString& file);
  bool reading() const { return worker_.busy(); }
  void cancel();
  /// Shows a recording that is in memory.
  void show(std::shared_ptr<const TouchRecording> recording, const QString& file);
  bool showing() const { return player_.recording() != nullptr; }
  void close();
  /// To the next event or, below 0, the one before; says which.
  void goToEvent(int direction);
  QString file() const { return file_; }

  /// A file with the recording's checksum: where the recording says, beside it, or one of
  /// `others`. Looked for in the worker; then inputFound.
  void findInput(const QStringList& others);
  const QString& waitingFile() const { return waiting_file_; }
  /// Of what findInput looks for, and what waits for its map.
  std::shared_ptr<const TouchRecording> waiting() const { return waiting_; }
  /// The map of the waiting recording is open: show it. It stops waiting.
  void showWaiting();
  void forgetWaiting() { waiting_.reset(); }

 Q_SIGNALS:
  void said(const QString& text);
  void failed(const QString& message);
  void shownChanged(bool showing);
  void probeMoved(const relievo::Probe& probe);
  /// The recording was not made on the open map; `sentence` says so. It is waiting().
  void needsItsMap(const QString& sentence);
  void inputFound(const QString& file);  ///< Empty: none.
  void busyChanged(bool busy);
  void progressed(const QString& step, double fraction);

 private:
  void showRow();
  QString whatIsMissing(const TouchRecording& recording) const;

  Document& document_;
  ReplayPlayer player_;
  ReplayPanel* panel_;
  RecordingReader reader_ = readRecording;
  QString file_, waiting_file_;
  std::shared_ptr<const TouchRecording> waiting_;
  std::uint64_t shown_window_ = 0;  ///< The recording's number of the window that is shown.
  LatestWorker worker_;             ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
