// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <QImage>
#include <QObject>
#include <QString>
#include <QUndoStack>

#include "core/depth/depth_request.h"
#include "core/project/project.h"
#include "core/region/region.h"
#include "core/region/window.h"
#include "core/session/first_view.h"
#include "core/session/surface.h"
#include "ui/latest_worker.h"
#include "ui/surface_work.h"

namespace relievo {

class TilePrefetcher;  // core/tiles/tiled_map.h

/// What to open and how; nothing chosen means the defaults of `SurfaceOptions`.
struct OpenRequest {
  QString file;
  std::optional<LengthUnit> unit;             ///< Said by the user for this file.
  std::optional<LengthUnit> remembered_unit;  ///< Said for this folder; used if the file has none.
  std::optional<ViewChoice> view;
  std::optional<RectMm> region;  ///< First window, view mm.
  std::optional<int> detail;     ///< First detail, 1 = whole.
  bool accept_incomplete = false;
  ScanChoices scan = {};  ///< What of the file is read.
  // A state that comes back, in place of the choices above.
  std::optional<SurfaceOptions> options;
  std::optional<Region> exact_region;
  std::vector<std::string> history;  ///< As Project has them.
  std::vector<NamedRegion> undo;
  double gain = 1;
  /// Name of a step: the file takes the present one's place and can be undone; empty: a new
  /// beginning.
  QString step = {};
};

/// Which file a surface was made from, and what of it.
struct OpenedFile {
  QString name, sha256;  ///< Of the bytes that were read, hexadecimal.
  bool accept_incomplete = false;
  ScanChoices scan;
  SurfaceSource source;
};

/// Everything that undo and redo bring back. Surfaces are shared and never change.
struct DocumentState {
  std::shared_ptr<const Surface> surface;
  SurfaceOptions options;  ///< How `surface` was made.
  Region region;
  double gain = 1;
  std::shared_ptr<const OpenedFile> file = nullptr;  ///< What `surface` was made from.
  friend bool operator==(const DocumentState& a, const DocumentState& b) {
    return a.surface == b.surface && a.region == b.region && a.gain == b.gain;
  }
};

/// The one open object: its surface, the window on it, and the history of both. Long work runs in
/// one worker; a newer request cancels the older one. [GUI thread]
class Document : public QObject {
  Q_OBJECT
 public:
  /// @param depth_buffer  runs for the engine "depthbuffer", on the worker
  explicit Document(DepthEngine depth_buffer, QObject* parent = nullptr);
  ~Document() override;

  void open(const OpenRequest& request);
  /// Ends the running work; what was shown stays.
  void cancel();
  bool busy() const { return worker_.busy(); }
  /// Files with fewer points are opened without a first view (core/session/first_view.h).
  void setFirstViewFrom(std::uint64_t points) { first_view_from_ = points; }

  bool isOpen() const { return state_.surface != nullptr; }
  const DocumentState& state() const { return state_; }
  std::shared_ptr<const Surface> surface() const { return state_.surface; }
  std::shared_ptr<const RegionWindow> window() const { return window_; }
  /// The file of state(), of no name while nothing is open.
  const OpenedFile& openedFile() const;
  const SurfaceSource& source() const { return openedFile().source; }
  const DepthEngine& depthBuffer() const { return depth_buffer_; }
  QString file() const { return openedFile().name; }
  QString fileSha256() const { return openedFile().sha256; }
  /// "Detail 2 of 4" numbers; 0 while nothing is open.
  int detail() const;
  int details() const;
  QUndoStack& history() { return history_; }
  /// Names of the steps that led here, those of earlier runs first.
  std::vector<std::string> stepNames() const;
  /// The last of these steps that can be undone after a restart: each with where it began.
  std::vector<NamedRegion> undoSteps() const;

  /// False, and told by failed(), for a map by tiles: its heights are in files as they were made.
  bool canRemake();
  // Made anew from the scan in memory, in the worker.
  void setView(const ViewChoice& view);
  void setEngine(const QString& engine);
  void setUnit(LengthUnit unit);
  void setStrays(StrayRule rule);
  void setNodata(const NodataChoice& nodata);
  void remake(const SurfaceOptions& options, const QString& name);
  /// A surface made elsewhere from source() takes the place of the present one.
  void adopt(std::shared_ptr<const Surface> surface, const SurfaceOptions& options,
             const QString& name);

  // At once. Each returns false at a limit or while nothing is open.
  bool finer(const StepAbout& about);
  bool coarser(const StepAbout& about);
  bool whole();
  bool move(double dx, double dy);
  bool setLevel(Level level);
  /// A drawn or typed rectangle; widened to a square about its centre.
  bool setRect(const RectMm& rect);
  bool setGain(double gain);
  /// A place as it is, with its gain, as one step.
  bool goTo(const Region& region, double gain, const QString& name);
  /// Like setRect, but one zoom in several steps is one entry in the history.
  bool zoomTo(const Region& region);
  StepAbout aboutCentre() const;

  // A gesture shows many states and leaves one entry in the history.
  void preview(const Region& region);
  void previewGain(double gain);
  void commit(const QString& name);
  void revert();
  bool inGesture() const { return gesture_start_.has_value(); }

  /// For the history's commands only: shows a state as it is. False, and told by failed(), if its
  /// window cannot be read from a map by tiles; then nothing changes.
  bool apply(const DocumentState& state);

 Q_SIGNALS:
  void workStarted();  ///< What was told of earlier work is past.
  /// A file was read and is about to be worked on: its size as it will be, millimetres.
  void scanRead(const QString& file, double width_mm, double height_mm, double depth_mm,
                quint64 points);
  /// What a large file looks like, from `used` of its `all` points (samples, of a map by tiles),
  /// while it is read; a better one may follow. Nothing of the document is changed by it.
  void firstView(const QString& file, const QImage& picture, quint64 used, quint64 all);
  void opened(const QString& file);  ///< A file was read; surfaceChanged came before.
  /// Another file is shown, by a step, its undo or redo; surfaceChanged comes after.
  void fileChanged(const QString& file);
  void surfaceChanged();
  void windowChanged();  ///< Region, level, gain or surface: `window()` is another one.
  void busyChanged(bool busy);
  void progressed(const QString& step, double fraction);
  void failed(const QString& message, const QString& code, const QString& file);
  void cancelled();

 private:
  struct Work;

  void start(Work work);
  void read(Work& work, const Task& task);  ///< [worker]
  /// Tells of first views while this is the work in hand. [worker]
  void showFirstViews(const std::shared_ptr<Work>& work, const Task& task);
  void finish(const Work& work);
  void showOpened(const Work& work);
  void restoreSteps(const Work& work, const DocumentState& now);
  void go(const std::optional<Region>& region, const QString& name);
  /// Null, and told by failed(), if it cannot be read from a map by tiles.
  std::shared_ptr<const RegionWindow> windowFor(const DocumentState& state);
  void push(DocumentState after, const QString& name, int merge_id = -1);

  DepthEngine depth_buffer_;
  std::uint64_t first_view_from_ = FirstViewOptions{}.least_points;
  std::weak_ptr<Work> in_hand_;  ///< The newest work.
  DocumentState state_;
  std::shared_ptr<const RegionWindow> window_;
  std::optional<DocumentState> gesture_start_;
  QUndoStack history_;
  std::vector<std::string> earlier_steps_;  ///< Of earlier runs, beyond undoing.
  bool steps_come_back_ = false;            ///< Steps enter the history without being shown.
  std::unique_ptr<TilePrefetcher> ahead_;   ///< While the surface is one by tiles.

  LatestWorker worker_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
