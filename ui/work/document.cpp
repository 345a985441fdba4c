// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/document.h"

#include <algorithm>
#include <cmath>
#include <QFile>
#include <QFileInfo>

#include "core/io/import.h"
#include "core/provenance/program.h"
#include "core/provenance/sha256.h"
#include "core/session/colours/surface_colours.h"
#include "core/session/large/tiled_surface.h"
#include "core/session/source/unit_guess.h"
#include "core/tiles/tiled_map.h"
#include "ui/dialogs/depth_map_preview.h"
#include "ui/language/error_text.h"
#include "ui/views/relief_picture.h"
#include "ui/work/file_names.h"
#include "ui/work/state_command.h"

namespace relievo {
namespace {

constexpr int kUndoLimit = 250;
constexpr int kMergeGain = 1;
constexpr int kMergeZoom = 2;

/// @param grows  the window, as it does beyond the coarsest detail and shrinks below the finest
QString detailName(int from, int to, bool grows) {
  if (from == to) return grows ? Document::tr("Larger window") : Document::tr("Smaller window");
  return Document::tr("Detail %1 \u2192 %2").arg(from).arg(to);
}

/// Takes the names of steps that come back out of those that only have names, the last ones first.
/// @return false: they are not all there
bool takeOut(const std::vector<NamedRegion>& steps, std::vector<std::string>& names) {
  std::size_t end = names.size();
  for (std::size_t i = steps.size(); i-- > 0;) {
    do {
      if (end == 0) return false;
      --end;
    } while (names[end] != steps[i].name);
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return true;
}

bool sameGrid(const Surface& a, const Surface& b) {
  return a.map.frame == b.map.frame && a.ladder.spacings_mm == b.ladder.spacings_mm;
}

double turnedBack(double azimuth_deg) {
  return std::remainder(azimuth_deg, 360.0);
}

double tilted(double elevation_deg) {
  return std::clamp(elevation_deg, -kMostTiltDeg, kMostTiltDeg);
}

}  // namespace

struct Document::Work {
  bool reads = false;  ///< Reads `open.file`; otherwise works on what is in memory.
  std::uint64_t first_view_from = 0;
  std::optional<std::uint64_t> free_bytes;
  OpenRequest open;
  OpenedInput source;
  SurfaceOptions options;
  QString name;  ///< In the history.
  SurfaceOutcome outcome;
  QString sha256;
  std::optional<Project> kept;  ///< Whose view this file is shown with.

  std::filesystem::path path() const { return QFile::encodeName(open.file).toStdString(); }
  ImportOptions import() const {
    ImportOptions import;
    import.accept_incomplete = open.accept_incomplete;
    import.scan = open.scan;
    import.free_bytes = free_bytes;
    return import;
  }
};

Document::Document(DepthEngine depth_buffer, QObject* parent)
    : QObject(parent), depth_buffer_(std::move(depth_buffer)) {
  history_.setUndoLimit(kUndoLimit);
  state_.project.version = programVersion();
  connect(&history_, &QUndoStack::indexChanged, this, &Document::noteSteps);
  connect(&worker_, &LatestWorker::busyChanged, this, &Document::busyChanged);
  connect(&worker_, &LatestWorker::progressed, this, &Document::progressed);
}

// Nobody hears of work that ends with the document.
Document::~Document() {
  worker_.disconnect();
  history_.disconnect(this);
}

void Document::open(const OpenRequest& request) {
  Work work;
  work.reads = true;
  work.open = request;
  if (request.project) {
    work.options = request.project->options;
    work.open.accept_incomplete = request.project->accept_incomplete;
    work.open.scan = request.project->scan;
  } else if (request.options) {
    work.options = *request.options;
  } else {
    work.options.unit = request.unit;
    work.options.view = request.view;
    if (request.keeps_view && isOpen()) {
      work.kept = state_.project;
      work.kept->options.view = shownView();
    }
  }
  start(std::move(work));
}

/// Also where it was found automatically.
std::optional<ViewChoice> Document::shownView() const {
  const Surface& surface = *state_.surface;
  const auto& chosen = state_.project.options.view;
  if (surface.is_raster || !standardRotation(surface.view_name)) return chosen;
  return ViewChoice{.name = surface.view_name,
                    .rotation = std::nullopt,
                    .turn_deg = chosen ? chosen->turn_deg : std::array<double, 3>{}};
}

void Document::close() {
  cancel();
  if (!isOpen()) return;
  revert();
  const Project before = state_.project;
  DocumentState none;
  none.project.version = before.version;
  none.project.look = before.look;
  none.project.stereo = before.stereo;
  none.project.chosen_eye_angle_deg = before.chosen_eye_angle_deg;
  state_ = std::move(none);
  window_.reset();
  ahead_.reset();
  earlier_steps_.clear();
  project_file_.clear();
  saved_work_.reset();
  is_in_no_file_ = false;
  history_.clear();
  Q_EMIT surfaceChanged();
  Q_EMIT windowChanged();
  tell(before);
}

void Document::cancel() {
  if (worker_.cancel()) Q_EMIT cancelled();
}

const OpenedInput& Document::source() const {
  static const OpenedInput kNone;
  return state_.source ? *state_.source : kNone;
}

QString Document::file() const {
  return pathFromBytes(state_.project.file);
}

Project Document::stored() const {
  return isOpen() ? storedProject(state_.project, *state_.surface) : state_.project;
}

Provenance Document::provenanceIn(const QString& file) const {
  return provenanceInFolder(QFileInfo(file).absolutePath());
}

Provenance Document::provenanceInFolder(const QString& folder) const {
  if (made_of_.lock() != state_.surface) {
    made_ = madeText(*state_.surface);
    made_of_ = state_.surface;
  }
  return provenanceOf(state_.project, *state_.surface, bytesOfPath(folder), made_);
}

void Document::noteSaved(const QString& project_file) {
  project_file_ = project_file;
  saved_work_ = workIn(state_.project, !project_file_.isEmpty());
  is_in_no_file_ = false;
}

bool Document::hasUnsavedWork() const {
  // While the first file is being opened nothing has been noted yet, and there is no work.
  if (!isOpen() || !saved_work_) return false;
  return is_in_no_file_ || !(workIn(state_.project, !project_file_.isEmpty()) == *saved_work_);
}

int Document::detail() const {
  return isOpen() ? state_.surface->ladder.detailOf(state_.project.region.level) : 0;
}

int Document::details() const {
  return isOpen() ? state_.surface->ladder.levels() : 0;
}

void Document::remake(const SurfaceOptions& options, const QString& name) {
  if (!canRemake()) return;
  Work work;
  work.source = source();
  work.options = options;
  work.name = name;
  start(std::move(work));
}

void Document::start(Work work) {
  const auto shared = std::make_shared<Work>(std::move(work));
  shared->first_view_from = first_view_from_;
  shared->free_bytes = free_bytes_;
  in_hand_ = shared;
  offered_every_.reset();
  Q_EMIT workStarted();
  worker_.start(
      [this, shared](const Task& task) {
        Work& w = *shared;
        w.outcome = outcomeOf([&] {
          if (w.reads) showFirstViews(shared, task);
          if (w.reads) read(w, task);
          task.check();
          auto surface = makeSurface(w.source, w.options, depth_buffer_, task);
          // For the start page.
          if (w.reads) ReliefPictures::keep(w.open.file, reliefPicture(*surface, kPicturePx));
          return surface;
        });
      },
      [this, shared] { finish(*shared); });
}

void Document::showFirstViews(const std::shared_ptr<Work>& work, const Task& task) {
  FirstViewOptions views;
  views.least_points = work->first_view_from;
  views.on_view = [&](const FirstView& view) {
    const QImage picture = pictureOf(view.surface, task).shaded;
    const std::weak_ptr<Work> of = work;
    QMetaObject::invokeMethod(
        this,
        [this, of, picture, used = view.used, all = view.all] {
          const auto shown = of.lock();
          // Work that was stopped may have told of a view that nobody waits for.
          if (!busy() || !shown || shown != in_hand_.lock()) return;
          Q_EMIT firstView(shown->open.file, picture, used, all);
        },
        Qt::QueuedConnection);
  };
  makeFirstViews(work->path(), work->options, work->import(), views, task);
}

void Document::read(Work& w, const Task& task) {
  const std::filesystem::path file = w.path();
  w.source = openInput(file, {.import = w.import()}, task);
  const ScanInfo& info = w.source.info();
  if (!w.options.unit && !info.unit && w.open.remembered_unit) {
    w.options.unit = w.open.remembered_unit;
    w.options.unit_source = UnitSource::remembered;
  }
  // A raster has its own.
  if (w.kept && w.source.scan && !w.options.view) w.options.view = w.kept->options.view;
  if (info.bounds) {
    const FilePoint size = sizeMm(w.source, w.options);
    Q_EMIT scanRead(w.open.file, size.x, size.y, size.z, info.points);
  }
  w.sha256 = QString::fromStdString(sha256OfFile(file, task));
}

void Document::finish(const Work& work) {
  if (work.outcome.cancelled) {
    Q_EMIT cancelled();
    return;
  }
  if (!work.outcome.surface) {
    offered_every_ = work.outcome.every;
    Q_EMIT failed(work.outcome.error, work.outcome.code, work.open.file);
    return;
  }
  if (work.reads) {
    showOpened(work);
  } else {
    adopt(work.outcome.surface, work.options, work.name);
  }
}

void Document::adopt(std::shared_ptr<const Surface> surface, const SurfaceOptions& options,
                     const QString& name) {
  revert();
  DocumentState next = state_;
  next.surface = std::move(surface);
  next.project.options = options;
  next.project.azimuth_deg = next.project.elevation_deg = 0;
  if (!sameGrid(*state_.surface, *next.surface)) {
    next.project.region = wholeRegion(next.surface->ladder);
  }
  push(std::move(next), name);
}

DocumentState Document::stateOf(const Work& work) const {
  const bool is_step = !work.open.step.isEmpty() && isOpen();
  DocumentState next;
  next.surface = work.outcome.surface;
  next.source = std::make_shared<const OpenedInput>(work.source);
  Project& p = next.project;
  if (is_step) {
    p = state_.project;
  } else if (work.open.project) {
    p = *work.open.project;
    p.azimuth_deg = turnedBack(p.azimuth_deg);
    p.elevation_deg = tilted(p.elevation_deg);
    p.picture.reset();  // It belongs to what the state came from, as these do.
    p.saved_as.clear();
    p.made.clear();
  } else {
    // How things are looked at goes on from file to file.
    p.look = state_.project.look;
    p.stereo = state_.project.stereo;
    p.chosen_eye_angle_deg = state_.project.chosen_eye_angle_deg;
  }
  if (is_step || !work.open.project) p.azimuth_deg = p.elevation_deg = 0;
  if (work.kept) {
    p.azimuth_deg = work.kept->azimuth_deg;
    p.elevation_deg = work.kept->elevation_deg;
    p.region = work.kept->region;
    p.gain = work.kept->gain;
  }
  p.file = bytesOfPath(work.open.file);
  p.sha256 = work.sha256.toStdString();
  p.bytes = static_cast<std::uint64_t>(QFileInfo(work.open.file).size());
  p.accept_incomplete = work.open.accept_incomplete;
  p.scan = work.open.scan;
  p.options = work.options;
  p.version = programVersion();
  return next;
}

namespace {

/// The same square of view millimetres, as finely as this map can show it, if it has such a place.
void keepPlace(const Project& kept, const DetailLadder& ladder, Project& project) {
  project.gain = kept.gain;
  const Region& r = kept.region;
  if (!onMap(ladder, r)) return;
  if (r.side_mm >= wholeRegion(ladder).side_mm) return;  // All of it, here as there.
  project.region = regionFromRect(
      ladder, {.x_mm = r.x_mm, .y_mm = r.y_mm, .width_mm = r.side_mm, .height_mm = r.side_mm});
}

}  // namespace

/// On the whole object, unless the request says otherwise and the map has it.
void Document::placeWindow(const Work& work, DocumentState& next) {
  const DetailLadder& ladder = next.surface->ladder;
  Region& region = next.project.region;
  const bool has_one = work.open.project && region.side_mm > 0;
  if (!has_one || region.level.value >= ladder.levels()) {
    region = wholeRegion(ladder);
    next.project.gain = 1;
  }
  if (work.kept) keepPlace(*work.kept, ladder, next.project);
  try {
    if (work.open.region) region = regionFromRect(ladder, *work.open.region);
    for (int d = 1; work.open.detail && d < *work.open.detail && !work.open.region; ++d) {
      const StepAbout about{region.centreX(), region.centreY(), false};
      region = relievo::finer(ladder, region, about).value_or(region);
    }
  } catch (const ArgumentError& error) {
    Q_EMIT failed(spokenError(error), {}, work.open.file);
  }
}

void Document::showOpened(const Work& work) {
  revert();
  DocumentState next = stateOf(work);
  if (!work.open.step.isEmpty() && isOpen()) {
    if (!sameGrid(*state_.surface, *next.surface)) {
      next.project.region = wholeRegion(next.surface->ladder);
    }
    push(std::move(next), work.open.step);
    return;
  }
  placeWindow(work, next);
  if (next.surface->tiles && !windowFor(next)) return;  // What was shown stays.
  history_.clear();
  saved_work_.reset();
  ahead_ = next.surface->tiles ? std::make_unique<TilePrefetcher>(next.surface->tiles) : nullptr;
  if (!restoreSteps(work, next)) return;
  noteSaved(work.open.project_file);
  Q_EMIT opened(file());
}

// Each step began where its record says, and ended where the next one began.
bool Document::restoreSteps(const Work& work, DocumentState now) {
  const std::vector<NamedRegion> undo = std::exchange(now.project.undo, {});
  earlier_steps_ = std::exchange(now.project.history, {});
  const Region asked = work.open.project ? work.open.project->region : Region{};
  fitLook(now);
  const int levels = now.surface->ladder.levels();
  std::vector<std::string> earlier = earlier_steps_;
  const bool fit = now.project.region == asked && takeOut(undo, earlier) &&
                   std::all_of(undo.begin(), undo.end(), [&](const NamedRegion& step) {
                     return step.region.level.value < levels;
                   });
  if (!show(now)) return false;
  if (fit && !undo.empty()) {
    earlier_steps_ = std::move(earlier);
    // They end at what is shown already: of all the windows on the way none is needed.
    steps_come_back_ = true;
    const Place end{state_.project.region, state_.project.gain};
    const auto place = [&](DocumentState& state, std::size_t i) {
      state.project.region = i < undo.size() ? undo[i].region : end.region;
      state.project.gain = i < undo.size() ? undo[i].gain : end.gain;
    };
    place(state_, 0);
    for (std::size_t i = 0; i < undo.size(); ++i) {
      DocumentState after = state_;
      place(after, i + 1);
      history_.push(
          new StateCommand(*this, state_, after, QString::fromStdString(undo[i].name), -1));
    }
    steps_come_back_ = false;
  }
  noteSteps();
  return true;
}

void Document::noteSteps() {
  if (steps_come_back_) return;
  std::vector<std::string> names = earlier_steps_;
  for (int i = 0; i < history_.index(); ++i) names.push_back(history_.text(i).toStdString());
  state_.project.history = std::move(names);
  state_.project.undo = undoSteps();
}

std::vector<NamedRegion> Document::undoSteps() const {
  std::vector<NamedRegion> steps;
  for (int i = history_.index() - 1; i >= 0; --i) {
    const auto* command = static_cast<const StateCommand*>(history_.command(i));
    const DocumentState& before = command->before();
    if (before.surface != state_.surface) break;  // Its surface would have to be made again.
    if (!command->moves()) continue;
    steps.push_back({.name = history_.text(i).toStdString(),
                     .region = before.project.region,
                     .gain = before.project.gain});
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

StepAbout Document::aboutCentre() const {
  return {state_.project.region.centreX(), state_.project.region.centreY(), false};
}

bool Document::push(DocumentState after, const QString& name, int merge_id) {
  fitLook(after);
  if (sameInSteps(state_, after)) return false;
  const DocumentState before = state_;
  history_.push(new StateCommand(*this, before, std::move(after), name, merge_id));
  return !sameInSteps(before, state_);  // A window that cannot be read is no step.
}

bool Document::edit(const QString& name, const std::function<void(Project&)>& change,
                    int merge_id) {
  if (!isOpen()) {
    amend(change);
    return true;
  }
  DocumentState after = state_;
  change(after.project);
  return push(std::move(after), name, merge_id);
}

void Document::amend(const std::function<void(Project&)>& change) {
  const Project before = state_.project;
  change(state_.project);
  tell(before);
  Q_EMIT amended();
}

void Document::setTurn(double azimuth_deg, double elevation_deg) {
  azimuth_deg = turnedBack(azimuth_deg);
  elevation_deg = tilted(elevation_deg);
  if (azimuth_deg == state_.project.azimuth_deg && elevation_deg == state_.project.elevation_deg) {
    return;
  }
  amend([&](Project& p) {
    p.azimuth_deg = azimuth_deg;
    p.elevation_deg = elevation_deg;
  });
}

void Document::setDrawnEyeAngle(double drawn_deg, const std::optional<double>& chosen_deg) {
  Project& p = state_.project;
  if (!std::isfinite(drawn_deg)) return;  // Of heights that are none.
  if (p.stereo.eye_angle_deg == drawn_deg && p.chosen_eye_angle_deg == chosen_deg) return;
  p.stereo.eye_angle_deg = drawn_deg;
  p.chosen_eye_angle_deg = chosen_deg;
  Q_EMIT stereoChanged();
}

void Document::go(const std::optional<Region>& region, const QString& name) {
  if (!region) return;
  DocumentState after = state_;
  after.project.region = *region;
  push(std::move(after), name);
}

bool Document::finer(const StepAbout& about) {
  if (!isOpen() || inGesture()) return false;
  const auto next = relievo::finer(state_.surface->ladder, state_.project.region, about);
  if (!next) return false;
  go(next, detailName(detail(), state_.surface->ladder.detailOf(next->level), false));
  return true;
}

bool Document::coarser(const StepAbout& about) {
  if (!isOpen() || inGesture()) return false;
  const auto next = relievo::coarser(state_.surface->ladder, state_.project.region, about);
  if (!next) return false;
  go(next, detailName(detail(), state_.surface->ladder.detailOf(next->level), true));
  return true;
}

bool Document::whole() {
  if (!isOpen() || inGesture()) return false;
  const Region next = wholeRegion(state_.surface->ladder);
  if (next == state_.project.region) return false;
  go(next, tr("Whole object"));
  return true;
}

bool Document::move(double dx, double dy) {
  if (!isOpen() || inGesture()) return false;
  const auto next = moved(state_.surface->ladder, state_.project.region, dx, dy);
  if (!next || *next == state_.project.region) return false;
  go(next, tr("Move window"));
  return true;
}

bool Document::setLevel(Level level) {
  if (!isOpen() || inGesture() || level == state_.project.region.level) return false;
  const auto next = atLevel(state_.surface->ladder, state_.project.region, level);
  if (!next) return false;
  go(next, detailName(detail(), state_.surface->ladder.detailOf(level), false));
  return true;
}

bool Document::setRect(const RectMm& rect) {
  if (!isOpen() || inGesture()) return false;
  try {
    const Region next = regionFromRect(state_.surface->ladder, rect);
    if (next == state_.project.region) return false;
    go(next, tr("Choose window"));
    return true;
  } catch (const ArgumentError& error) {
    Q_EMIT failed(spokenError(error), {}, {});
    return false;
  }
}

bool Document::setGain(double gain) {
  if (!isOpen() || inGesture() || !(gain > 0) || gain == state_.project.gain) return false;
  DocumentState after = state_;
  after.project.gain = gain;
  push(std::move(after), tr("Vertical exaggeration"), kMergeGain);
  return true;
}

bool Document::goTo(const Region& region, double gain, const QString& name) {
  if (!isOpen() || inGesture() || !(gain > 0)) return false;
  DocumentState after = state_;
  after.project.region = region;
  after.project.gain = gain;
  return push(std::move(after), name);
}

bool Document::zoomTo(const Region& region) {
  if (!isOpen() || inGesture() || region == state_.project.region) return false;
  DocumentState after = state_;
  after.project.region = region;
  push(std::move(after), tr("Zoom"), kMergeZoom);
  return true;
}

void Document::preview(const Region& region) {
  if (!isOpen() || !(region.side_mm > 0) || region == state_.project.region) return;
  if (!gesture_start_) gesture_start_ = {state_.project.region, state_.project.gain};
  DocumentState next = state_;
  next.project.region = region;
  show(std::move(next));
}

void Document::previewGain(double gain) {
  if (!isOpen() || !(gain > 0) || gain == state_.project.gain) return;
  if (!gesture_start_) gesture_start_ = {state_.project.region, state_.project.gain};
  DocumentState next = state_;
  next.project.gain = gain;
  show(std::move(next));
}

void Document::commit(const QString& name) {
  if (!gesture_start_) return;
  const Place start = *std::exchange(gesture_start_, std::nullopt);
  DocumentState before = state_;
  before.project.region = start.region;
  before.project.gain = start.gain;
  if (before == state_) return;
  history_.push(new StateCommand(*this, std::move(before), state_, name, -1));
}

void Document::revert() {
  if (!gesture_start_) return;
  const Place start = *std::exchange(gesture_start_, std::nullopt);
  DocumentState next = state_;
  next.project.region = start.region;
  next.project.gain = start.gain;
  show(std::move(next));
}

std::shared_ptr<const RegionWindow> Document::windowFor(const DocumentState& state) {
  try {
    return std::make_shared<const RegionWindow>(
        windowOf(*state.surface, state.project.region, state.project.gain));
  } catch (const Error& error) {
    Q_EMIT failed(spokenError(error), {}, {});
    return nullptr;
  }
}

bool Document::change(const DocumentState& from, const DocumentState& to) {
  // A drag began on a map that is no longer shown, and has nothing to go back to.
  if (from.surface != to.surface) gesture_start_.reset();
  return show(withChange(state_, from, to));
}

bool Document::show(DocumentState next) {
  if (steps_come_back_) {
    state_ = std::move(next);
    return true;
  }
  const bool other_surface = next.surface != state_.surface;
  const bool other_window = !window_ || !(next == state_);
  if (other_window) {
    auto window = windowFor(next);
    if (!window) return false;
    window_ = std::move(window);
  }
  const bool other_file = next.source != state_.source;
  const DocumentState before = std::exchange(state_, std::move(next));
  if (other_file) Q_EMIT fileChanged(file());
  if (ahead_ && other_window) ahead_->around(state_.project.region);
  if (other_surface) Q_EMIT surfaceChanged();
  if (other_window) Q_EMIT windowChanged();
  tell(before.project);
  return true;
}

void Document::tell(const Project& before) {
  const Project now = state_.project;  // Who is told may change it again.
  if (!(now.look == before.look)) Q_EMIT lookChanged();
  if (!(now.stereo == before.stereo) || now.chosen_eye_angle_deg != before.chosen_eye_angle_deg) {
    Q_EMIT stereoChanged();
  }
  if (now.azimuth_deg != before.azimuth_deg || now.elevation_deg != before.elevation_deg) {
    Q_EMIT turnChanged();
  }
  if (!(now.places == before.places)) Q_EMIT placesChanged();
  if (!(now.measurements == before.measurements)) Q_EMIT measurementsChanged();
  if (!(now.paths == before.paths)) Q_EMIT pathsChanged();
}

void Document::fitLook(DocumentState& next) {
  ReliefLook& look = next.project.look;
  if (canShow(*next.surface, look.kind)) return;
  const ReliefKind wanted = std::exchange(look.kind, ReliefKind::lit);
  Q_EMIT lookRefused(wanted);
}

}  // namespace relievo
