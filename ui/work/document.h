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
#include "ui/work/latest_worker.h"
#include "ui/work/surface_work.h"

namespace relievo {

class TilePrefetcher;  // core/tiles/tiled_map.h

/// How far the detail view is turned up or down, at most: beyond, its upright would be undefined.
inline constexpr double kMostTiltDeg = 85;

/// What to open and how; nothing chosen means the defaults of `SurfaceOptions`.
struct OpenRequest {
  QString file;
  std::optional<LengthUnit> unit;             ///< Said by the user for this file.
  std::optional<LengthUnit> remembered_unit;  ///< Said for this folder; used if the file has none.
  std::optional<ViewChoice> view;
  std::optional<RectMm> region;  ///< First window, view mm.
  std::optional<int> detail;     ///< First detail, 1 = whole.
  bool accept_incomplete = false;
  ScanChoices scan = {};    ///< What of the file is read.
  bool keeps_view = false;  ///< Side, turn, exaggeration and place of what is open, if anything is.
  std::optional<SurfaceOptions> options;  ///< In place of `unit` and `view`.
  /// A state that comes back, in place of the choices above; its `file` is `file`.
  std::optional<Project> project = {};
  QString project_file = {};  ///< That holds this state; empty: none.
  /// Name of a step: the file takes the present one's place and can be undone; empty: a new
  /// beginning.
  QString step = {};
};

/// What undo and redo go between: the state of the work as a value, and what was made of it.
/// Surface and source are shared and never change.
struct DocumentState {
  Project project;
  std::shared_ptr<const Surface> surface = nullptr;     ///< Made as project.options say ...
  std::shared_ptr<const OpenedInput> source = nullptr;  ///< ... from this.
  /// Shows the same of the same surface.
  friend bool operator==(const DocumentState& a, const DocumentState& b) {
    return a.surface == b.surface && a.project.region == b.project.region &&
           a.project.gain == b.project.gain;
  }
};

/// The one open object: the whole state of the work on it, which is one `Project`, its surface, the
/// window on it, and the history. Panels and views show the state and ask for edits of it; nothing
/// else keeps it (docs/adr/0139). Long work runs in one worker; a newer request cancels the older
/// one. [GUI thread]
class Document : public QObject {
  Q_OBJECT
 public:
  /// @param depth_buffer  runs for the engine "depthbuffer", on the worker
  explicit Document(DepthEngine depth_buffer, QObject* parent = nullptr);
  ~Document() override;

  void open(const OpenRequest& request);
  /// Nothing is open any more, as at the start; how things are looked at goes on to the next file.
  void close();
  /// Ends the running work; what was shown stays.
  void cancel();
  bool busy() const { return worker_.busy(); }
  /// Files with fewer points are opened without a first view (core/session/first_view.h).
  void setFirstViewFrom(std::uint64_t points) { first_view_from_ = points; }

  /// What the memory is taken to hold, in place of what the system says.
  void setFreeBytes(std::uint64_t bytes) { free_bytes_ = bytes; }
  /// One point in how many the memory would hold; nothing: the last failure was another one.
  const std::optional<std::uint64_t>& offeredEvery() const { return offered_every_; }

  bool isOpen() const { return state_.surface != nullptr; }
  /// The state of the work. While nothing is open, what the next file will be shown with.
  const Project& project() const { return state_.project; }
  const DocumentState& state() const { return state_; }
  std::shared_ptr<const Surface> surface() const { return state_.surface; }
  std::shared_ptr<const RegionWindow> window() const { return window_; }
  /// The state as files keep it, pictures and packages too.
  Project stored() const;
  /// Where something that is written to `file` comes from. @pre isOpen()
  Provenance provenanceIn(const QString& file) const;
  Provenance provenanceInFolder(const QString& folder) const;

  /// One step of the history that changes what `change` does. False: it changed nothing that steps
  /// bring back. While nothing is open it is done and is no step.
  /// @param merge_id  -1: a step of its own; else one step with those of the same id before it
  bool edit(const QString& name, const std::function<void(Project&)>& change, int merge_id = -1);
  /// A change that is no step and that undo leaves alone: camera paths, figures, recordings.
  void amend(const std::function<void(Project&)>& change);
  /// Turn of the camera; no step, but an other surface and its undo bring the one before back.
  void setTurn(double azimuth_deg, double elevation_deg);
  /// What the view makes of the stereo that was chosen; see Project.
  void setDrawnEyeAngle(double drawn_deg, const std::optional<double>& chosen_deg);

  /// The project file that the state goes on from; empty: none.
  const QString& projectFile() const { return project_file_; }
  /// The state is in this project file now; empty: in none, but nothing of it is work.
  void noteSaved(const QString& project_file);
  /// The state is work, whatever it is: what a crash left.
  void noteUnsaved() { is_in_no_file_ = true; }
  /// Places, measurements, camera paths or, in a project, settings that no file holds.
  bool hasUnsavedWork() const;

  /// What the surface was made from; nothing while nothing is open.
  const OpenedInput& source() const;
  const DepthEngine& depthBuffer() const { return depth_buffer_; }
  QString file() const;  ///< Its name; empty while nothing is open.
  QString fileSha256() const { return QString::fromStdString(state_.project.sha256); }
  /// "Detail 2 of 4" numbers; 0 while nothing is open.
  int detail() const;
  int details() const;
  QUndoStack& history() { return history_; }
  /// False, and told by failed(), for a map by tiles: its heights are in files as they were made.
  bool canRemake();
  // Made anew from the scan in memory, in the worker.
  void setView(const ViewChoice& view);
  void setEngine(const QString& engine);
  void setUnit(LengthUnit unit);
  void setStrays(StrayRule rule);
  void setNodata(const NodataChoice& nodata);
  void setRasterScale(const RasterScale& scale);
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

  /// For the history's commands only: changes in the present state what differs between two. False,
  /// and told by failed(), if its window cannot be read from a map by tiles; then nothing changes.
  bool change(const DocumentState& from, const DocumentState& to);

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
  // A part of project() is another one.
  void lookChanged();
  void stereoChanged();
  void turnChanged();
  void placesChanged();
  void measurementsChanged();
  void pathsChanged();
  void amended();  ///< By no step.
  /// The surface lacks what the state would show: it is shown as lit stone.
  void lookRefused(relievo::ReliefKind wanted);
  void busyChanged(bool busy);
  void progressed(const QString& step, double fraction);
  void failed(const QString& message, const QString& code, const QString& file);
  void cancelled();

 private:
  struct Work;

  std::optional<ViewChoice> shownView() const;  ///< @pre isOpen()
  void start(Work work);
  void read(Work& work, const Task& task);  ///< [worker]
  /// Tells of first views while this is the work in hand. [worker]
  void showFirstViews(const std::shared_ptr<Work>& work, const Task& task);
  void finish(const Work& work);
  void showOpened(const Work& work);
  /// False, and told by failed(), if its window cannot be read.
  bool restoreSteps(const Work& work, DocumentState now);
  /// The state that a file was read for. @return the step's, or a new beginning's
  DocumentState stateOf(const Work& work) const;
  void placeWindow(const Work& work, DocumentState& next);
  void go(const std::optional<Region>& region, const QString& name);
  /// Null, and told by failed(), if it cannot be read from a map by tiles.
  std::shared_ptr<const RegionWindow> windowFor(const DocumentState& state);
  /// False, and told by failed(), as change().
  bool show(DocumentState next);
  void tell(const Project& before);
  void fitLook(DocumentState& next);
  bool push(DocumentState after, const QString& name, int merge_id = -1);
  /// Names of the steps that led here, those of earlier runs first, and those that can be undone
  /// after a restart, each with where it began.
  void noteSteps();
  std::vector<NamedRegion> undoSteps() const;

  struct Place {
    Region region;
    double gain = 1;
  };

  DepthEngine depth_buffer_;
  std::uint64_t first_view_from_ = FirstViewOptions{}.least_points;
  std::optional<std::uint64_t> free_bytes_, offered_every_;
  std::weak_ptr<Work> in_hand_;  ///< The newest work.
  DocumentState state_;
  // Of the surface named beside it; it takes a look at each cell, and states are asked for often.
  mutable std::string made_;
  mutable std::weak_ptr<const Surface> made_of_;
  std::shared_ptr<const RegionWindow> window_;
  std::optional<Place> gesture_start_;
  QUndoStack history_;
  std::vector<std::string> earlier_steps_;  ///< Of earlier runs, beyond undoing.
  bool steps_come_back_ = false;            ///< Steps enter the history without being shown.
  QString project_file_;
  std::optional<Project> saved_work_;      ///< What a file holds of the work; see workIn.
  bool is_in_no_file_ = false;             ///< See noteUnsaved().
  std::unique_ptr<TilePrefetcher> ahead_;  ///< While the surface is one by tiles.

  LatestWorker worker_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
