// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QTimer>

namespace relievo {

/// Whether the views draw with half as many pixels each way for now: while somebody drags and whole
/// pictures come more slowly than 25 a second, as they do with software OpenGL. A moment after the
/// last step the views draw whole pictures again. [GUI thread]
class CoarsePictures : public QObject {
  Q_OBJECT
 public:
  static constexpr double kPart = 0.5;  ///< Of the pixels each way.

  explicit CoarsePictures(QObject* parent = nullptr);

  bool on() const { return rest_.isActive(); }
  /// The picture of a step of a drag was made.
  /// @param took_ms  from what the pointer asked for to its picture
  /// @param more     the pointer is elsewhere by now
  void stepDrawn(qint64 took_ms, bool more);

 Q_SIGNALS:
  void over();  ///< on() was true, and is so no more.

 private:
  QTimer rest_;
};

}  // namespace relievo
