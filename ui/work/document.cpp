// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/document.h"

#include <algorithm>
#include <cmath>
#include <QFileInfo>

#include "core/message/catalogue.h"
#include "core/provenance/program.h"
#include "core/session/colours/surface_colours.h"
#include "core/session/large/tiled_surface.h"
#include "core/session/turned_region.h"
#include "core/tiles/tiled_map.h"
#include "ui/language/error_text.h"
#include "ui/work/file_names.h"
#include "ui/work/opened_state.h"
#include "ui/work/state_command.h"
#include "ui/work/tiles_ahead.h"

namespace relievo {
namespace {

constexpr int kUndoLimit = 250;
constexpr int kTurnStep = 0x7452;  // Turns of the relief in a row are one step.

/// Takes the names of steps that come back out of those that only have names, the last ones first.
/// @return false: they are not all there
bool takeOut(const std::vector<UndoStep>& steps, std::vector<std::string>& names) {
  std::size_t end = names.size();
  for (std::size_t i = steps.size(); i-- > 0;) {
    do {
      if (end == 0) return false;
      --end;
    } while (names[end] != steps[i].before.name);
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return true;
}

bool sameGrid(const Surface& a, const Surface& b) {
  return a.map.frame == b.map.frame && a.ladder.spacings_mm == b.ladder.spacings_mm;
}

}  // namespace

Document::Document(DepthEngine depth_buffer, QObject* parent)
    : QObject(parent),
      region_(*this),
      choices_(*this),
      saved_(*this),
      loader_(std::move(depth_buffer)) {
  history_.setUndoLimit(kUndoLimit);
  state_.project.version = programVersion();
  connect(&history_, &QUndoStack::indexChanged, this, &Document::noteSteps);
  connect(&loader_, &SurfaceLoader::made, this, &Document::takeMade);
  connect(&loader_, &SurfaceLoader::failed, this, &Document::failed);
}

Document::~Document() {
  history_.disconnect(this);
}

void Document::open(const OpenRequest& request) {
  LoadJob job{.reads = true, .open = request};
  if (request.project) {
    job.options = request.project->options;
    job.open.accept_incomplete = request.project->accept_incomplete;
    job.open.scan = request.project->scan;
  } else if (request.options) {
    job.options = *request.options;
  } else {
    job.options.unit = request.unit;
    job.options.view = request.view;
    if (request.keeps_view && isOpen()) {
      job.kept = state_.project;
      job.kept->options.view = shownView(state_);
    }
  }
  loader_.start(std::move(job));
}

void Document::close() {
  loader_.cancel();
  if (!isOpen()) return;
  region_.revert();
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
  saved_.clear();
  history_.clear();
  Q_EMIT surfaceChanged();
  Q_EMIT windowChanged();
  tell(before);
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

int Document::detail() const {
  return isOpen() ? state_.surface->ladder.detailOf(state_.project.region.level) : 0;
}

int Document::details() const {
  return isOpen() ? state_.surface->ladder.levels() : 0;
}

bool Document::canRemake() {
  if (!isOpen()) return false;
  if (!state_.surface->tiles) return true;
  Q_EMIT failed(tr("This map is read by tiles, as it was made; nothing was changed. To make it "
                   "otherwise, run relievo depthmap --memory on its scan, with the choices you "
                   "want."),
                {}, {});
  return false;
}

void Document::remake(const SurfaceOptions& options, const QString& name,
                      const std::optional<ReliefTurn>& turn) {
  if (!canRemake()) return;
  loader_.start(LoadJob{.source = source(), .options = options, .name = name, .turn = turn});
}

void Document::takeMade(const LoadJob& job) {
  if (job.reads) {
    showOpened(job);
  } else {
    adopt(job.outcome.surface, job.options, job.name, job.turn);
  }
}

void Document::adopt(std::shared_ptr<const Surface> surface, const SurfaceOptions& options,
                     const QString& name, const std::optional<ReliefTurn>& turn) {
  region_.revert();
  DocumentState next = state_;
  next.surface = std::move(surface);
  next.project.options = options;
  next.project.azimuth_deg = next.project.elevation_deg = 0;
  if (turn) {
    next.project.region =
        turnedRegion(*state_.surface, state_.project.region, turn->about, *next.surface);
  } else if (!sameGrid(*state_.surface, *next.surface)) {
    next.project.region = wholeRegion(next.surface->ladder);
  }
  const Project before = state_.project;
  // So that an undo comes back to a view that asks for no other turn.
  if (turn && choices_.reliefFollows()) setTurn(0, 0);
  push(std::move(next), name, turn ? kTurnStep : -1);
  if (turn) {  // It went on while the surface was made.
    setTurn(before.azimuth_deg - turn->azimuth_deg, before.elevation_deg - turn->elevation_deg);
  }
}

void Document::showOpened(const LoadJob& job) {
  region_.revert();
  DocumentState next = openedState(job, state_);
  if (!job.open.step.isEmpty() && isOpen()) {
    if (!sameGrid(*state_.surface, *next.surface)) {
      next.project.region = wholeRegion(next.surface->ladder);
    }
    push(std::move(next), job.open.step);
    return;
  }
  const QString problem = placeWindow(job, next);
  if (!problem.isEmpty()) Q_EMIT failed(problem, {}, job.open.file);
  if (next.surface->tiles && !windowFor(next)) return;  // What was shown stays.
  history_.clear();
  saved_.forget();
  lookAhead(*next.surface);
  if (!restoreSteps(job, next)) return;
  saved_.noteSaved(job.open.project_file);
  Q_EMIT opened(file());
  if (job.from_before) {
    Q_EMIT toldOfWeb(said<MessageId::web_map_from_before>(state_.surface->tiles->place()));
  }
}

void Document::lookAhead(const Surface& surface) {
  ahead_.reset();
  if (!surface.tiles) return;
  ahead_ = std::make_unique<TilesAhead>(surface.tiles);
  connect(ahead_.get(), &TilesAhead::said, this, &Document::toldOfWeb);
  connect(ahead_.get(), &TilesAhead::better, this,
          [this](const std::shared_ptr<const RegionWindow>& window) {
            window_ = window;
            Q_EMIT windowChanged();
          });
}

bool Document::restoreSteps(const LoadJob& job, DocumentState now) {
  std::vector<UndoStep> undo = std::exchange(now.project.undo, {});
  // A file may name more than the history keeps; each of them would be a whole state here.
  if (undo.size() > kUndoLimit) undo.erase(undo.begin(), undo.end() - kUndoLimit);
  earlier_steps_ = std::exchange(now.project.history, {});
  const Region asked = job.open.project ? job.open.project->region : Region{};
  fitLook(now);
  std::vector<std::string> earlier = earlier_steps_;
  const bool fit = now.project.region == asked && takeOut(undo, earlier);
  if (!show(now)) return false;
  const std::vector<DocumentState> states = fit ? statesOf(undo) : std::vector<DocumentState>();
  if (states.size() > 1) {
    earlier_steps_ = std::move(earlier);
    // They end at what is shown already: of all the windows on the way none is needed.
    steps_come_back_ = true;
    state_ = states.front();
    for (std::size_t i = 0; i < undo.size(); ++i) {
      history_.push(new StateCommand(*this, states[i], states[i + 1],
                                     QString::fromStdString(undo[i].before.name), -1));
    }
    state_ = states.back();
    steps_come_back_ = false;
  }
  noteSteps();
  return true;
}

std::vector<DocumentState> Document::statesOf(const std::vector<UndoStep>& steps) const {
  std::vector<DocumentState> states{state_};
  for (std::size_t i = steps.size(); i-- > 0;) {
    DocumentState before = states.back();
    Project& p = before.project;
    if (!takeBack(steps[i], p) || !(p.region.level.value < before.surface->ladder.levels())) {
      return {};
    }
    if (!canShow(*before.surface, p.look.kind)) p.look.kind = ReliefKind::lit;
    p.azimuth_deg = turnedBack(p.azimuth_deg);
    p.elevation_deg = tilted(p.elevation_deg);
    states.push_back(std::move(before));
  }
  std::reverse(states.begin(), states.end());
  return states;
}

void Document::noteSteps() {
  if (steps_come_back_) return;
  std::vector<std::string> names = earlier_steps_;
  for (int i = 0; i < history_.index(); ++i) names.push_back(history_.text(i).toStdString());
  state_.project.history = std::move(names);
  state_.project.undo = undoSteps();
}

std::vector<UndoStep> Document::undoSteps() const {
  std::vector<UndoStep> steps;
  for (int i = history_.index() - 1; i >= 0; --i) {
    const auto* command = static_cast<const StateCommand*>(history_.command(i));
    // Its surface would have to be made again.
    if (command->before().surface != state_.surface) break;
    steps.push_back(undoStep(history_.text(i).toStdString(), command->before().project,
                             command->after().project));
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

bool Document::push(DocumentState after, const QString& name, int merge_id) {
  fitLook(after);
  after.project.azimuth_deg = turnedBack(after.project.azimuth_deg);
  after.project.elevation_deg = tilted(after.project.elevation_deg);
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

void Document::turnView(double azimuth_deg, double elevation_deg, int merge_id) {
  if (choices_.reliefFollows()) return setTurn(azimuth_deg, elevation_deg);
  edit(
      tr("Turn the view"),
      [&](Project& p) {
        p.azimuth_deg = azimuth_deg;
        p.elevation_deg = elevation_deg;
      },
      merge_id);
}

void Document::straighten() {
  edit(tr("Straighten the view"), [](Project& p) { p.azimuth_deg = p.elevation_deg = 0; });
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

bool Document::showPlace(const Region& region, double gain) {
  DocumentState next = state_;
  next.project.region = region;
  next.project.gain = gain;
  return show(std::move(next));
}

std::shared_ptr<const RegionWindow> Document::windowFor(const DocumentState& state) {
  try {
    const Project& p = state.project;
    if (state.surface->tiles) return TilesAhead::now(*state.surface->tiles, p.region, p.gain);
    return std::make_shared<const RegionWindow>(windowOf(*state.surface, p.region, p.gain));
  } catch (const Error& error) {
    Q_EMIT failed(spokenError(error), {}, {});
    return nullptr;
  }
}

bool Document::change(const DocumentState& from, const DocumentState& to) {
  // A drag began on a map that is no longer shown, and has nothing to go back to.
  if (from.surface != to.surface) region_.forgetGesture();
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
  if (ahead_ && other_window) ahead_->around(state_.project.region, *window_);
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
