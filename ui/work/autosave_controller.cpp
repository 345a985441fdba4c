// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/autosave_controller.h"

#include <iostream>
#include <QCoreApplication>
#include <QDateTime>
#include <QDeadlineTimer>
#include <QFile>
#include <QFileInfo>
#include <QLocale>

#include "core/base/error.h"
#include "ui/language/error_text.h"
#include "ui/work/file_path.h"
#include "ui/work/scheduling/event_turn.h"

namespace relievo {
namespace {

constexpr int kDelayMs = 2000;
constexpr int kPatienceMs = 2000, kTurnMs = 20;

}  // namespace

AutosaveController::AutosaveController(const QString& folder, std::function<Project()> work,
                                       QObject* parent)
    : QObject(parent), folder_(folder), work_(std::move(work)) {
  later_.setSingleShot(true);
  later_.setInterval(kDelayMs);
  connect(&later_, &QTimer::timeout, this, &AutosaveController::save);
}

AutosaveController::~AutosaveController() = default;

void AutosaveController::changed() {
  if (!folder_.isEmpty() && !later_.isActive()) later_.start();
}

void AutosaveController::forget() {
  later_.stop();
  autosave_.reset();
}

void AutosaveController::leave() {
  if (folder_.isEmpty()) return;
  later_.stop();
  // A copy that is being written may be an older one: it must not land after this one.
  const QDeadlineTimer patience(kPatienceMs);
  while (worker_.running() && !patience.hasExpired()) {
    waitForEvents(kTurnMs);
  }
  try {
    if (!autosave_) autosave_ = std::make_shared<Autosave>(pathOf(folder_));
    autosave_->leave();
    autosave_->save(work_());
  } catch (const Error& error) {  // The strip goes with the window; the older copy stays.
    std::cerr << "relievo: " << error.what() << '\n';
  }
}

void AutosaveController::save() {
  struct Copy {
    std::shared_ptr<Autosave> autosave;
    Project work;
    QString problem;
  };
  auto copy = std::make_shared<Copy>();
  try {
    if (!autosave_) autosave_ = std::make_shared<Autosave>(pathOf(folder_));
    copy->autosave = autosave_;
    copy->work = work_();
  } catch (const Error& error) {
    if (!std::exchange(told_, true)) Q_EMIT failed(spokenError(error));
    return;
  }
  worker_.start(
      [copy](const Task&) {
        try {
          copy->autosave->save(copy->work);
        } catch (const Error& error) {
          copy->problem = spokenError(error);
        }
        copy->autosave.reset();
      },
      [this, copy] {
        if (copy->problem.isEmpty()) {
          told_ = false;
        } else if (!std::exchange(told_, true)) {
          Q_EMIT failed(copy->problem);
        }
      });
}

std::optional<AutosaveController::Left> AutosaveController::left() const {
  if (folder_.isEmpty()) return std::nullopt;
  for (const auto& file : leftAutosaves(pathOf(folder_))) {
    const QString name = QFile::decodeName(file.c_str());
    try {
      return Left{.copy = name,
                  .project = readProject(file),
                  .time = QLocale().toString(QFileInfo(name).lastModified(), QLocale::ShortFormat)};
    } catch (const FileError&) {
      setAutosaveAside(file);  // It would be offered for ever.
    }
  }
  return std::nullopt;
}

void AutosaveController::discard(const QString& copy) {
  removeAutosave(pathOf(copy));
}

}  // namespace relievo
