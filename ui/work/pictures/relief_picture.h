// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QImage>
#include <QObject>
#include <QStringList>

#include "ui/work/latest_worker.h"

namespace relievo {

struct Surface;

/// Longest side of the pictures on the start page.
inline constexpr int kPicturePx = 160;

/// A small hillshade of the whole surface, without a graphics card. @throw FileError (tiles)
/// [any thread]
QImage reliefPicture(const Surface& surface, int longest_px);

/// Pictures of files, kept in $XDG_CACHE_HOME/relievo; a changed file has none. [GUI thread]
class ReliefPictures : public QObject {
  Q_OBJECT
 public:
  explicit ReliefPictures(QObject* parent = nullptr);

  /// Null if there is none yet.
  static QImage kept(const QString& file);  ///< [any thread]
  /// A null one is not kept. [any thread]
  static void keep(const QString& file, const QImage& picture);
  /// Makes those of the files that have none, one after the other, in a worker.
  void make(const QStringList& files);

 Q_SIGNALS:
  void made(const QString& file, const QImage& picture);

 private:
  LatestWorker worker_;
};

}  // namespace relievo
