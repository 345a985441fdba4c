// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/output/tiles_controller.h"

#include <cmath>
#include <QFileInfo>
#include <QPointer>
#include <utility>

#include "core/base/error.h"
#include "core/base/replaceable.h"
#include "core/base/time_left.h"
#include "core/project/tiled_work.h"
#include "core/session/input_names.h"
#include "ui/dialogs/tiled_map_dialog.h"
#include "ui/language/core_text.h"
#include "ui/language/error_text.h"
#include "ui/message/message_text.h"
#include "ui/style/text.h"
#include "ui/work/file_names.h"
#include "ui/work/file_path.h"

namespace relievo {
namespace {

/// In words, about; empty while nobody can tell.
QString timeLeft(std::chrono::steady_clock::time_point began, double began_at, double fraction) {
  constexpr double kMinuteS = 60, kHourS = 3600;
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const auto left = secondsLeft(seconds, began_at, fraction);
  if (!left) return {};
  if (*left < kMinuteS) {
    return TilesController::tr("about %1 s left of it").arg(5 * std::ceil(*left / 5));
  }
  return *left < 2 * kHourS
             ? TilesController::tr("about %1 min left of it").arg(std::ceil(*left / kMinuteS))
             : TilesController::tr("about %1 h left of it").arg(std::ceil(*left / kHourS));
}

/// How fine what is ready is. [GUI thread]
QString readyText(const GridFrame& frame, const HeightRange& z) {
  return TilesController::tr("From a sample of the points: %1 × %2 cells of %3, %4 high.")
      .arg(frame.size.cols)
      .arg(frame.size.rows)
      .arg(lengthText(frame.spacing_mm), lengthText(z.max_mm - z.min_mm));
}

/// How many rows of it have their heights.
QString readyText(int rows, GridSize whole) {
  if (rows == whole.rows) {
    return TilesController::tr("All heights of %1 × %2 cells are there; gaps are looked for.")
        .arg(whole.cols)
        .arg(whole.rows);
  }
  return TilesController::tr(
             "%1 of %2 rows have their heights, from below; the rest is from a "
             "sample of the points.")
      .arg(rows)
      .arg(whole.rows);
}

/// What is open, with its unit and side; nothing of a map by tiles, which is no scan any more.
TiledMapOrder begunWith(const Document& document) {
  TiledMapOrder begun;
  if (!document.isOpen() || document.surface()->tiles) return begun;
  begun.names << document.file();
  const SurfaceOptions& options = document.project().options;
  begun.unit = options.unit;
  const bool is_named =
      options.view && !options.view->rotation && options.view->turn_deg == std::array<double, 3>{};
  if (is_named) begun.view = QString::fromStdString(options.view->name);
  return begun;
}

TiledWork workOf(const TiledMapOrder& order, const QString& kept) {
  TiledWork work{.names = {}, .out = pathOf(order.file)};
  for (const QString& name : order.names) work.names.push_back(pathOf(name));
  work.options.unit = order.unit;
  if (!order.view.isEmpty()) work.options.view = ViewChoice{order.view.toStdString(), {}, {}};
  work.memory_bytes = static_cast<std::uint64_t>(order.memory_mb) * 1'000'000;
  work.threads = order.threads;
  if (!kept.isEmpty()) work.job_folder = pathOf(kept);
  return work;
}
}  // namespace

struct TilesController::Work {
  TiledWork work;
  QString file;
  std::filesystem::path open;  ///< What the window shows.
  bool opens = false;
  std::optional<LargeMap> made;
  QString error;
};

TilesController::TilesController(const ControllerParts& parts) : Controller(parts) {
  commands_.on(Command::tiled_map, this, [this] { choose(); });
  messages_.follow(work_);
  connect(&messages_, &WindowMessages::cancelAsked, this, &TilesController::stop);
  connect(&work_, &WorkQueue::progressed, this, &TilesController::showProgress);
}

void TilesController::choose() {
  // One that was closed and is at rest may be of another scan than the one that is open now.
  if (dialog_ != nullptr && !work_.busy() && !dialog_->isVisible()) {
    delete std::exchange(dialog_, nullptr);
  }
  if (dialog_ == nullptr) {
    dialog_ = new TiledMapDialog(begunWith(document_), &window_);
    connect(dialog_, &TiledMapDialog::makeAsked, this, [this] { make(dialog_->order()); });
    connect(dialog_, &TiledMapDialog::stopAsked, this, &TilesController::stop);
  }
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

void TilesController::make(const TiledMapOrder& order) {
  if (work_.busy()) return;
  kept_ = order.keeps_parts ? order.file + QLatin1String(".job") : QString();
  const auto work = std::make_shared<Work>();
  work->work = workOf(order, kept_);
  work->file = order.file;
  work->open = pathOf(document_.file());
  work->opens = order.opens;
  dialog_->showProblem({});
  dialog_->showBusy(true);
  step_.clear();
  work_.add(
      [this, work](const Task& task) {
        try {
          std::vector<FileRead> read;
          for (const auto& file : filesNamed(work->work.names)) read.push_back({.file = file});
          read.push_back({.file = work->open, .what = "what the window shows"});
          requireNotAnInput(work->work.out, read);
          work->work.on_view = [this, &task](const Surface& view) {
            showReady(
                view.map,
                [frame = view.map.frame, z = heightRange(view.map)] { return readyText(frame, z); },
                task);
          };
          work->work.on_ready = [this, &task](const ReadyMap& ready) {
            const auto words = [rows = ready.rows, whole = ready.whole] {
              return readyText(rows, whole);
            };
            showReady(ready.map, words, task);
          };
          work->made = makeTiledMap(work->work, task);
        } catch (const Cancelled&) {  // Its end is not told.
        } catch (const std::exception& failure) {
          work->error = shownError(failure);
        }
      },
      [this, work] { finish(*work); });
}

void TilesController::showReady(const DepthMap& map, const std::function<QString()>& words,
                                const Task& task) {
  const DepthMapPicture picture = pictureOf(map, task);
  QMetaObject::invokeMethod(
      this, [this, picture, words] { dialog_->showReady(picture, words()); }, Qt::QueuedConnection);
}

void TilesController::stop() {
  if (!work_.cancel()) return;
  dialog_->showBusy(false);
  announce(kept_.isEmpty()
               ? tr("Cancelled. No map was made.")
               : tr("Cancelled. No map was made; what was finished is kept in %1, and the same "
                    "choices go on there.")
                     .arg(shownName(kept_)));
  Q_EMIT ended(false);
}

void TilesController::showProgress(const QString& step, double fraction) {
  if (step != step_) {
    step_ = step;
    step_began_ = std::chrono::steady_clock::now();
    step_at_ = fraction;
  }
  dialog_->showProgress(coreText(step), fraction, timeLeft(step_began_, step_at_, fraction));
}

void TilesController::finish(const Work& work) {
  dialog_->showBusy(false);
  if (!work.made) {
    dialog_->showProblem(work.error);
    messages_.show(work.error);
    Q_EMIT ended(false);
    return;
  }
  const GridSize size = work.made->frames.front().size;
  QStringList said{tr("%1 is made: %2 × %3 cells, %4 levels.")
                       .arg(shownName(work.file))
                       .arg(size.cols)
                       .arg(size.rows)
                       .arg(work.made->frames.size())};
  for (const Message& left : work.made->not_done) said << messageText(left);
  announce(said.join(' '));
  Q_EMIT ended(true);
  if (!work.opens) return;
  dialog_->close();
  Q_EMIT openAsked(work.file);
}

}  // namespace relievo
