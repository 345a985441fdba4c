// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "ui/window/controller.h"
#include "ui/work/work_queue.h"

namespace relievo {

class TiledMapDialog;
struct DepthMap;
struct Task;
struct TiledMapOrder;

/// Maps larger than the memory, made in the background from files that need not be open. [GUI
/// thread]
class TilesController : public Controller {
  Q_OBJECT
 public:
  explicit TilesController(const ControllerParts& parts);

  bool busy() const { return work_.busy(); }

 Q_SIGNALS:
  void ended(bool written);  ///< A map is made, or was not; after what was said of it.
  void openAsked(const QString& file);

 private:
  struct Work;

  void choose();
  void make(const TiledMapOrder& order);
  void stop();
  /// [worker] @param words  of it [GUI thread]
  void showReady(const DepthMap& map, const std::function<QString()>& words, const Task& task);
  void showProgress(const QString& step, double fraction);
  void finish(const Work& work);

  TiledMapDialog* dialog_ =
      nullptr;    ///< Of the window; from the first time on that it is asked for.
  QString kept_;  ///< Folder of the work's finished parts; empty: none.
  QString step_;  ///< That is being done, since `step_began_`, from `step_at_` on.
  std::chrono::steady_clock::time_point step_began_;
  double step_at_ = 0;
  WorkQueue work_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
