// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/replay_control.h"

#include <QFile>
#include <QFileInfo>
#include <vector>

#include "core/base/error.h"
#include "core/io/web/web_link.h"
#include "core/provenance/sha256.h"
#include "core/tiles/published/published_tiles.h"
#include "ui/language/error_text.h"
#include "ui/panels/replay_events.h"
#include "ui/panels/replay_panel.h"
#include "ui/style/text.h"
#include "ui/work/document.h"
#include "ui/work/file_names.h"
#include "ui/work/file_path.h"

namespace relievo {
namespace {

/// What a job in the worker leaves behind.
struct Read {
  std::shared_ptr<TouchRecording> recording;
  QString error;
};

}  // namespace

ReplayControl::ReplayControl(Document& document, QObject* parent)
    : QObject(parent), document_(document), panel_(new ReplayPanel(player_)) {
  panel_->hide();
  connect(&player_, &ReplayPlayer::moved, this, &ReplayControl::showRow);
  connect(&player_, &ReplayPlayer::playingChanged, this, [this](bool playing) {
    if (showing()) {
      // While it plays, the time that could be said is past at once.
      Q_EMIT said(playing ? tr("Playing") : tr("Paused, %1").arg(panel_->timeText()));
    }
  });
  connect(panel_, &ReplayPanel::eventAsked, this, &ReplayControl::goToEvent);
  connect(panel_, &ReplayPanel::closeAsked, this, &ReplayControl::close);
  connect(&worker_, &LatestWorker::busyChanged, this, &ReplayControl::busyChanged);
  connect(&worker_, &LatestWorker::progressed, this, &ReplayControl::progressed);
}

ReplayControl::~ReplayControl() = default;

void ReplayControl::open(const QString& file) {
  auto read = std::make_shared<Read>();
  worker_.start(
      [reader = reader_, read, path = pathOf(file)](const Task& task) {
        try {
          task.report("Recording", 0);
          read->recording = std::make_shared<TouchRecording>(reader(path, task));
        } catch (const Cancelled&) {
          return;
        } catch (const Error& error) {
          read->error = shownError(error);
        }
      },
      [this, read, file] {
        if (!read->recording) {
          Q_EMIT failed(read->error);
          return;
        }
        if (document_.isOpen()) {
          const int placed = placeUnknownWindows(*read->recording, document_.surface()->ladder);
          if (placed > 0) {
            Q_EMIT said(
                tr("The recording does not say where %n window(s) lay; they are shown "
                   "around what was touched.",
                   nullptr, placed));
          }
        }
        show(read->recording, file);
      });
}

void ReplayControl::cancel() {
  if (worker_.cancel()) Q_EMIT said(tr("Cancelled. Nothing was changed."));
}

QString ReplayControl::whatIsMissing(const TouchRecording& recording) const {
  const QString name = shownName(pathFromBytes(recording.name));
  const QString input = shownPath(pathFromBytes(recording.input));
  if (!document_.isOpen()) {
    return input.isEmpty() ? tr("%1 does not say what was touched. Open that file first.").arg(name)
                           : tr("%1 was recorded on %2, which is not open.").arg(name, input);
  }
  switch (fitOf(recording, document_.fileSha256().toStdString(),
                document_.surface()->view_from_file.m)) {
    case RecordingFit::other_input:
      return tr("%1 was recorded on %2, not on %3.").arg(name, input, shownName(document_.file()));
    case RecordingFit::other_view:
      return tr("%1 was recorded on another view of %2 or with another unit.")
          .arg(name, shownName(document_.file()));
    case RecordingFit::fits:
    case RecordingFit::not_said:
      break;
  }
  return {};
}

void ReplayControl::show(std::shared_ptr<const TouchRecording> recording, const QString& file) {
  const QString missing = whatIsMissing(*recording);
  if (!missing.isEmpty()) {
    waiting_ = std::move(recording);
    waiting_file_ = file;
    Q_EMIT needsItsMap(missing);
    return;
  }
  const bool said_nothing = recording->input_sha256.empty();
  waiting_.reset();
  file_ = file;
  shown_window_ = 0;
  player_.load(std::move(recording));
  Q_EMIT shownChanged(true);
  showRow();
  Q_EMIT said(said_nothing
                  ? tr("%1 does not say what it was recorded on; it is shown on the open map.")
                        .arg(shownName(file))
                  : tr("Replay of %1, %2 s. Forces are off. Space plays.")
                        .arg(shownName(file), numberText(player_.durationS(), 1)));
}

void ReplayControl::close() {
  if (!showing()) return;
  player_.unload();
  document_.region().revert();  // The window from before.
  Q_EMIT shownChanged(false);
  Q_EMIT said(tr("Replay closed"));
}

void ReplayControl::goToEvent(int direction) {
  if (!showing()) return;
  const TouchEvent* event = player_.goToEvent(direction);
  if (event == nullptr) {
    Q_EMIT said(direction > 0 ? tr("No event after this place") : tr("No event before this place"));
    return;
  }
  Q_EMIT said(tr("%1 s: %2").arg(numberText(player_.timeS(), 2), eventText(*event)));
}

void ReplayControl::showRow() {
  if (!showing() || !document_.isOpen()) return;
  const TouchRow& row = player_.row();
  if (row.window_id != shown_window_) {
    shown_window_ = row.window_id;
    const TouchedWindow* window = windowOf(*player_.recording(), row);
    // A level of another pyramid cannot be shown; the hand is drawn all the same.
    if (window != nullptr && window->region.level.value >= 0 &&
        window->region.level.value < document_.details()) {
      document_.region().preview(window->region);
      document_.region().previewGain(window->gain);
    }
  }
  if (const auto shown = document_.window()) Q_EMIT probeMoved(probeOf(row, shown->id));
}

void ReplayControl::findInput(const QStringList& others) {
  if (!waiting_) return;
  std::vector<std::filesystem::path> places;
  const std::filesystem::path beside = pathOf(QFileInfo(waiting_file_).absolutePath());
  const auto add = [&places](const std::string& name) {
    // Of a map from the web, what was opened before.
    if (!isWebAddress(name)) return places.emplace_back(name), void();
    if (const auto kept = keptMap(name)) places.push_back(*kept);
  };
  if (isWebAddress(waiting_->input)) {
    add(waiting_->input);
  } else if (!waiting_->input.empty()) {
    places.push_back((beside / waiting_->input).lexically_normal());
    places.push_back(beside / std::filesystem::path(waiting_->input).filename());
  }
  for (const QString& other : others) add(bytesOfPath(other));
  auto found = std::make_shared<QString>();
  worker_.start(
      [places, found, wanted = waiting_->input_sha256](const Task& task) {
        for (const auto& place : places) {
          try {
            std::error_code missing;
            if (!std::filesystem::is_regular_file(place, missing)) continue;
            if (!wanted.empty() && sha256OfFile(place, task) != wanted) continue;
            *found = QFile::decodeName(place.c_str());
            return;
          } catch (const Cancelled&) {
            return;
          } catch (const FileError&) {
            continue;  // Not this one.
          }
        }
      },
      [this, found] { Q_EMIT inputFound(*found); });
}

void ReplayControl::showWaiting() {
  if (!waiting_ || !document_.isOpen()) return;
  auto recording = std::make_shared<TouchRecording>(*waiting_);
  placeUnknownWindows(*recording, document_.surface()->ladder);
  show(recording, waiting_file_);
}

}  // namespace relievo
