// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <QImage>
#include <QObject>
#include <QString>

#include "core/depth/depth_request.h"
#include "core/session/first_view.h"
#include "ui/work/latest_worker.h"
#include "ui/work/open_request.h"
#include "ui/work/surface_work.h"

namespace relievo {

/// Part of the turn of the view that a new surface takes over: the view is turned less by it then.
struct ReliefTurn {
  double azimuth_deg = 0, elevation_deg = 0;
  ViewMm about;  ///< Stays where it is in the window; view mm of the surface of before.
};

/// A surface to be made, of a file or of what is in memory; and what came of it.
struct LoadJob {
  bool reads = false;        ///< Reads `open.file`; otherwise works on `source`.
  OpenRequest open = {};     ///< Of an address, once it is found, the map.json that is kept of it.
  bool from_before = false;  ///< The server gave no answer: what is kept of its map was opened.
  std::optional<Project> kept = {};  ///< Whose view this file is shown with.
  OpenedInput source = {};
  SurfaceOptions options = {};
  QString name = {};  ///< In the history.
  std::optional<ReliefTurn> turn = {};

  SurfaceOutcome outcome = {};
  QString sha256 = {};  ///< Of the file that was read.
};

/// Reads files and makes surfaces, one at a time in a worker; a newer job stops the older one,
/// whose end is then not told. [GUI thread]
class SurfaceLoader : public QObject {
  Q_OBJECT
 public:
  /// @param depth_buffer  runs for the engine "depthbuffer", on the worker
  explicit SurfaceLoader(DepthEngine depth_buffer);
  ~SurfaceLoader() override;

  void start(LoadJob job);
  /// Ends the running work; what was shown stays.
  void cancel();
  bool busy() const { return worker_.busy(); }
  const DepthEngine& depthBuffer() const { return depth_buffer_; }

  /// Files with fewer points are opened without a first view (core/session/first_view.h).
  void setFirstViewFrom(std::uint64_t points) { first_view_from_ = points; }
  /// What the memory is taken to hold, in place of what the system says.
  void setFreeBytes(std::uint64_t bytes) { free_bytes_ = bytes; }
  /// One point in how many the memory would hold; nothing: the last failure was another one.
  const std::optional<std::uint64_t>& offeredEvery() const { return offered_every_; }

 Q_SIGNALS:
  void workStarted();  ///< What was told of earlier work is past.
  /// A file was read and is about to be worked on: its size as it will be, millimetres.
  void scanRead(const QString& file, double width_mm, double height_mm, double depth_mm,
                quint64 points);
  /// What a large file looks like, from `used` of its `all` points (samples, of a map by tiles),
  /// while it is read; a better one may follow.
  void firstView(const QString& file, const QImage& picture, quint64 used, quint64 all);
  void made(const relievo::LoadJob& job);  ///< Its outcome is a surface.
  void failed(const QString& message, const QString& code, const QString& file);
  void cancelled();
  void busyChanged(bool busy);
  void progressed(const QString& step, double fraction);

 private:
  ImportOptions importOf(const LoadJob& job) const;
  /// An address becomes a file (docs/adr/0200). [worker] @throw as webMap
  static void find(LoadJob& job, const Task& task);
  /// Both read as `import` says. [worker]
  void read(LoadJob& job, const ImportOptions& import, const Task& task);
  /// Tells of first views while this is the job in hand.
  void showFirstViews(const std::shared_ptr<LoadJob>& job, const ImportOptions& import,
                      std::uint64_t least_points, const Task& task);
  void finish(const LoadJob& job);

  DepthEngine depth_buffer_;
  std::uint64_t first_view_from_ = FirstViewOptions{}.least_points;
  std::optional<std::uint64_t> free_bytes_, offered_every_;
  std::weak_ptr<LoadJob> in_hand_;  ///< The newest.
  LatestWorker worker_;             ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
