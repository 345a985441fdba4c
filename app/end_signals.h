// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QObject>

class QSocketNotifier;

namespace relievo {

/// Brings the signals that ask a program to end (SIGTERM, SIGINT, and SIGHUP of a terminal or
/// session that closes) into the event loop, the first of them. Further ones belong to the same
/// request; a second Ctrl+C, and each of them after ten seconds, ends a process that hangs. What
/// was ignored when the program started, as nohup leaves SIGHUP, stays so. One at a time. [GUI
/// thread]
class EndSignals : public QObject {
  Q_OBJECT
 public:
  /// To be made before a device is opened, which sends its last words on signals that nobody
  /// handles.
  explicit EndSignals(QObject* parent = nullptr);
  ~EndSignals() override;  ///< The signals do again what they did.

 Q_SIGNALS:
  void came(int signal);

 private:
  std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace relievo
