// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QTimer>

namespace relievo {

/// Tells the supervisor once a second that the event loop runs, by a pipe that it gave
/// ($RELIEVO_HEARTBEAT_FD). Without a supervisor it does nothing. [GUI thread]
class Heartbeat : public QObject {
  Q_OBJECT
 public:
  explicit Heartbeat(QObject* parent = nullptr);
  ~Heartbeat() override;

 private:
  void beat() const;

  int pipe_ = -1;
  QTimer timer_;
};

}  // namespace relievo
