// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/replay/camera_path.h"

namespace relievo {

/// Runs along a camera path in real time. [GUI thread]
class PathPreview : public QObject {
  Q_OBJECT
 public:
  explicit PathPreview(QObject* parent = nullptr);

  /// @throw ArgumentError  as check(path)
  void play(const CameraPath& path, const DetailLadder& ladder);
  void stop();
  bool playing() const { return timer_.isActive(); }

 Q_SIGNALS:
  void viewChanged(const relievo::ViewState& view);
  void ended();

 private:
  CameraPath path_;
  DetailLadder ladder_;
  QTimer timer_;
  QElapsedTimer clock_;
};

}  // namespace relievo
