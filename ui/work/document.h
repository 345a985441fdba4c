// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <QObject>
#include <QString>
#include <QUndoStack>

#include "core/project/project.h"
#include "core/region/region.h"
#include "core/region/window.h"
#include "core/session/surface.h"
#include "ui/work/open_request.h"
#include "ui/work/region_editor.h"
#include "ui/work/saved_work.h"
#include "ui/work/surface_choices.h"
#include "ui/work/surface_loader.h"

namespace relievo {

struct Message;
class TilesAhead;  // ui/work/tiles_ahead.h

/// How far the detail view is turned up or down, at most: beyond, its upright would be undefined.
inline constexpr double kMostTiltDeg = 85;

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
/// else keeps it (docs/adr/0139). Edits of one kind have an object of their own, as has the long
/// work, which runs in one worker; a newer request cancels the older one (docs/adr/0202).
/// [GUI thread]
class Document : public QObject {
  Q_OBJECT
 public:
  /// @param depth_buffer  runs for the engine "depthbuffer", on the worker
  explicit Document(DepthEngine depth_buffer, QObject* parent = nullptr);
  ~Document() override;

  void open(const OpenRequest& request);
  /// Nothing is open any more, as at the start; how things are looked at goes on to the next file.
  void close();

  bool isOpen() const { return state_.surface != nullptr; }
  /// The state of the work. While nothing is open, what the next file will be shown with.
  const Project& project() const { return state_.project; }
  const DocumentState& state() const { return state_; }
  std::shared_ptr<const Surface> surface() const { return state_.surface; }
  /// Of a map from the web it may be coarser than project().region says, until its tiles are here.
  std::shared_ptr<const RegionWindow> window() const { return window_; }
  /// What the surface was made from; nothing while nothing is open.
  const OpenedInput& source() const;
  QString file() const;  ///< Its name; empty while nothing is open.
  QString fileSha256() const { return QString::fromStdString(state_.project.sha256); }
  /// "Detail 2 of 4" numbers; 0 while nothing is open.
  int detail() const;
  int details() const;
  /// The state as files keep it, pictures and packages too.
  Project stored() const;
  /// Where something that is written to `file` comes from. @pre isOpen()
  Provenance provenanceIn(const QString& file) const;
  Provenance provenanceInFolder(const QString& folder) const;

  // Its parts.
  RegionEditor& region() { return region_; }      ///< Moves the window.
  SurfaceChoices& choices() { return choices_; }  ///< What the surface is made by.
  SurfaceLoader& loader() { return loader_; }     ///< The work in hand.
  const SurfaceLoader& loader() const { return loader_; }
  SavedWork& saved() { return saved_; }  ///< What files hold of it.
  const SavedWork& saved() const { return saved_; }
  QUndoStack& history() { return history_; }

  /// One step of the history that changes what `change` does. False: it changed nothing that steps
  /// bring back. While nothing is open it is done and is no step.
  /// @param merge_id  -1: a step of its own; else one step with those of the same id before it
  bool edit(const QString& name, const std::function<void(Project&)>& change, int merge_id = -1);
  /// A change that is no step and that undo leaves alone: camera paths, figures, recordings.
  void amend(const std::function<void(Project&)>& change);
  /// Somebody turns the camera: turns in a row are one step. Where the relief follows the view, the
  /// relief is the step.
  void turnView(double azimuth_deg, double elevation_deg, int merge_id = kTurnsInARow);
  static constexpr int kTurnsInARow = 0x7456;  ///< For edit().
  /// Looks straight at the relief, by a step of its own.
  void straighten();
  /// Turn of the camera by nobody: a film, a relief that follows the view. No step.
  void setTurn(double azimuth_deg, double elevation_deg);
  /// What the view makes of the stereo that was chosen; see Project.
  void setDrawnEyeAngle(double drawn_deg, const std::optional<double>& chosen_deg);

  /// False, and told by failed(), for a map by tiles: its heights are in files as they were made.
  bool canRemake();
  /// Made anew from the scan in memory, in the worker.
  /// @param turn  one step of the history with the turns right before it
  void remake(const SurfaceOptions& options, const QString& name,
              const std::optional<ReliefTurn>& turn = std::nullopt);
  /// A surface made elsewhere from source() takes the place of the present one.
  void adopt(std::shared_ptr<const Surface> surface, const SurfaceOptions& options,
             const QString& name, const std::optional<ReliefTurn>& turn = std::nullopt);

  /// For the history's commands only: changes in the present state what differs between two. False,
  /// and told by failed(), if its window cannot be read from a map by tiles; then nothing changes.
  bool change(const DocumentState& from, const DocumentState& to);
  /// For RegionEditor only: shows a window without a step. @pre isOpen() @return as change()
  bool showPlace(const Region& region, double gain);

 Q_SIGNALS:
  void opened(const QString& file);  ///< A file was read; surfaceChanged came before.
  /// Another file is shown, by a step, its undo or redo; surfaceChanged comes after.
  void fileChanged(const QString& file);
  void surfaceChanged();
  void windowChanged();  ///< Region, level, gain or surface: `window()` is another one.
  void toldOfWeb(const relievo::Message& message);  ///< What comes of the map, or does not.
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
  /// An edit, or work of the loader.
  void failed(const QString& message, const QString& code, const QString& file);

 private:
  void takeMade(const LoadJob& job);
  void showOpened(const LoadJob& job);
  void lookAhead(const Surface& surface);
  /// False, and told by failed(), if its window cannot be read.
  bool restoreSteps(const LoadJob& job, DocumentState now);
  /// The states between the steps, oldest first and the present one last; empty if a step does not
  /// fit.
  std::vector<DocumentState> statesOf(const std::vector<UndoStep>& steps) const;
  /// Null, and told by failed(), if it cannot be read from a map by tiles.
  std::shared_ptr<const RegionWindow> windowFor(const DocumentState& state);
  /// False, and told by failed(), as change().
  bool show(DocumentState next);
  void tell(const Project& before);
  void fitLook(DocumentState& next);
  bool push(DocumentState after, const QString& name, int merge_id = -1);
  /// Names of the steps that led here, those of earlier runs first, and those that can be undone
  /// after a restart.
  void noteSteps();
  std::vector<UndoStep> undoSteps() const;

  DocumentState state_;
  // Of the surface named beside it; it takes a look at each cell, and states are asked for often.
  mutable std::string made_;
  mutable std::weak_ptr<const Surface> made_of_;
  std::shared_ptr<const RegionWindow> window_;
  QUndoStack history_;
  std::vector<std::string> earlier_steps_;  ///< Of earlier runs, beyond undoing.
  bool steps_come_back_ = false;            ///< Steps enter the history without being shown.
  std::unique_ptr<TilesAhead> ahead_;       ///< While the surface is one by tiles.

  RegionEditor region_;
  SurfaceChoices choices_;
  SavedWork saved_;
  SurfaceLoader loader_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
