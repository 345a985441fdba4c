// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <QObject>
#include <QTimer>

#include "core/project/autosave.h"
#include "ui/work/latest_worker.h"

namespace relievo {

/// Keeps a copy of unsaved work on the disk while the program lives, and finds what a crash left.
/// Copies are written by a worker, at most every two seconds. [GUI thread]
class AutosaveController : public QObject {
  Q_OBJECT
 public:
  /// @param folder  empty: nothing is kept and nothing found
  /// @param work    what is to be kept; asked for when a copy is made
  AutosaveController(const QString& folder, std::function<Project()> work,
                     QObject* parent = nullptr);
  ~AutosaveController() override;

  /// There is something that no file holds.
  void changed();
  /// The program is told to end: writes the copy as the work is now, and leaves it for the next
  /// start. Waits for it.
  void leave();
  /// Nothing is unsaved any more: the copy goes.
  void forget();
  bool pending() const { return later_.isActive() || worker_.busy(); }

  struct Left {
    QString copy;  ///< File, to be given to discard().
    Project project;
    QString time;  ///< When it was written, as the locale writes it.
  };
  /// The newest copy that a program which no longer runs left; unreadable ones are removed.
  std::optional<Left> left() const;
  static void discard(const QString& copy);

 Q_SIGNALS:
  void failed(const QString& message);  ///< Once, until a copy could be written again.

 private:
  void save();

  QString folder_;
  std::function<Project()> work_;
  std::shared_ptr<Autosave> autosave_;
  QTimer later_;
  bool told_ = false;
  LatestWorker worker_;  ///< Last: its job ends before the copy goes.
};

}  // namespace relievo
