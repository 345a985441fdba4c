// SPDX-License-Identifier: BSD-3-Clause
#include "ui/document.h"

#include <algorithm>
#include <cmath>
#include <QFile>
#include <QUndoCommand>

#include "core/io/import.h"
#include "core/provenance/sha256.h"
#include "core/session/open_input.h"
#include "core/session/tiled_surface.h"
#include "core/session/unit_guess.h"
#include "core/tiles/tiled_map.h"
#include "ui/depth_map_preview.h"
#include "ui/relief_picture.h"
#include "ui/spoken_error.h"

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

class StateCommand : public QUndoCommand {
 public:
  StateCommand(Document& document, DocumentState before, DocumentState after, const QString& name,
               int merge_id)
      : QUndoCommand(name),
        document_(document),
        before_(std::move(before)),
        after_(std::move(after)),
        merge_id_(merge_id) {}

  // A step to what cannot be read leaves the history.
  void undo() override { setObsolete(!document_.apply(before_)); }
  void redo() override { setObsolete(!document_.apply(after_)); }
  int id() const override { return merge_id_; }
  const DocumentState& before() const { return before_; }
  bool mergeWith(const QUndoCommand* later) override {
    if (later->id() != merge_id_ || later->isObsolete()) return false;
    after_ = static_cast<const StateCommand*>(later)->after_;
    return true;
  }

 private:
  Document& document_;
  DocumentState before_, after_;
  int merge_id_;
};

bool sameGrid(const Surface& a, const Surface& b) {
  return a.map.frame == b.map.frame && a.ladder.spacings_mm == b.ladder.spacings_mm;
}

}  // namespace

struct Document::Work {
  bool reads = false;  ///< Reads `open.file`; otherwise works on what is in memory.
  std::uint64_t first_view_from = 0;
  OpenRequest open;
  SurfaceSource source;
  SurfaceOptions options;
  QString name;  ///< In the history.
  SurfaceOutcome outcome;
  QString sha256;

  std::filesystem::path path() const { return QFile::encodeName(open.file).toStdString(); }
  ImportOptions import() const {
    ImportOptions import;
    import.accept_incomplete = open.accept_incomplete;
    import.scan = open.scan;
    return import;
  }
};

Document::Document(DepthEngine depth_buffer, QObject* parent)
    : QObject(parent), depth_buffer_(std::move(depth_buffer)) {
  history_.setUndoLimit(kUndoLimit);
  connect(&worker_, &LatestWorker::busyChanged, this, &Document::busyChanged);
  connect(&worker_, &LatestWorker::progressed, this, &Document::progressed);
}

// Nobody hears of work that ends with the document.
Document::~Document() {
  worker_.disconnect();
}

void Document::open(const OpenRequest& request) {
  Work work;
  work.reads = true;
  work.open = request;
  if (request.options) {
    work.options = *request.options;
  } else {
    work.options.unit = request.unit;
    work.options.view = request.view;
  }
  start(std::move(work));
}

void Document::cancel() {
  if (worker_.cancel()) Q_EMIT cancelled();
}

const OpenedFile& Document::openedFile() const {
  static const OpenedFile none;
  return state_.file ? *state_.file : none;
}

int Document::detail() const {
  return isOpen() ? state_.surface->ladder.detailOf(state_.region.level) : 0;
}

int Document::details() const {
  return isOpen() ? state_.surface->ladder.levels() : 0;
}

void Document::setView(const ViewChoice& view) {
  if (!isOpen()) return;
  SurfaceOptions options = state_.options;
  options.view = view;
  remake(options, tr("View %1 \u2192 %2")
                      .arg(QString::fromStdString(state_.surface->view_name),
                           QString::fromStdString(view.name)));
}

void Document::setEngine(const QString& engine) {
  if (!isOpen() || engine.toStdString() == state_.options.engine) return;
  SurfaceOptions options = state_.options;
  options.engine = engine.toStdString();
  remake(options, tr("Depth engine \u2192 %1").arg(engine));
}

void Document::setUnit(LengthUnit unit) {
  if (!isOpen()) return;
  SurfaceOptions options = state_.options;
  options.unit = unit;
  options.unit_source = UnitSource::given;
  const auto text = [](LengthUnit u) { return QString::fromUtf8(name(u).data()); };
  remake(options, tr("Unit %1 \u2192 %2").arg(text(state_.surface->unit), text(unit)));
}

void Document::setStrays(StrayRule rule) {
  if (!isOpen() || rule == state_.options.strays) return;
  SurfaceOptions options = state_.options;
  options.strays = rule;
  remake(options, rule == StrayRule::keep          ? tr("Keep far-off points")
                  : rule == StrayRule::drop_groups ? tr("Leave out far-off groups")
                                                   : tr("Leave out far-off points"));
}

void Document::setNodata(const NodataChoice& nodata) {
  if (!isOpen() || nodata == state_.options.nodata) return;
  SurfaceOptions options = state_.options;
  options.nodata = nodata;
  remake(options, nodata.value ? tr("Take heights as missing") : tr("Keep all heights"));
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
  in_hand_ = shared;
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
  OpenedInput input = openInput(file, {.import = w.import()}, task);
  w.source = {std::move(input.scan), std::move(input.raster), std::move(input.tiled)};
  const ScanInfo& info = w.source.info();
  if (!w.options.unit && !info.unit && w.open.remembered_unit) {
    w.options.unit = w.open.remembered_unit;
    w.options.unit_source = UnitSource::remembered;
  }
  if (info.bounds) {
    const double mm = mmPer(unitInUse(info, w.options.unit, w.options.unit_source).unit);
    const FilePoint size = mm * (info.bounds->max - info.bounds->min);
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
  DocumentState next{std::move(surface), options, {}, state_.gain, state_.file};
  next.region =
      sameGrid(*state_.surface, *next.surface) ? state_.region : wholeRegion(next.surface->ladder);
  push(std::move(next), name);
}

void Document::showOpened(const Work& work) {
  revert();
  DocumentState next{work.outcome.surface, work.options, wholeRegion(work.outcome.surface->ladder),
                     1,
                     std::make_shared<const OpenedFile>(
                         OpenedFile{.name = work.open.file,
                                    .sha256 = work.sha256,
                                    .accept_incomplete = work.open.accept_incomplete,
                                    .scan = work.open.scan,
                                    .source = work.source})};
  if (!work.open.step.isEmpty() && isOpen()) {
    if (sameGrid(*state_.surface, *next.surface)) next.region = state_.region;
    next.gain = state_.gain;
    push(std::move(next), work.open.step);
    return;
  }
  const DetailLadder& ladder = next.surface->ladder;
  try {
    if (work.open.exact_region && work.open.exact_region->level.value < ladder.levels()) {
      next.region = *work.open.exact_region;
      next.gain = work.open.gain;
    }
    if (work.open.region) next.region = regionFromRect(ladder, *work.open.region);
    for (int d = 1; work.open.detail && d < *work.open.detail && !work.open.region; ++d) {
      const StepAbout about{next.region.centreX(), next.region.centreY(), false};
      next.region = relievo::finer(ladder, next.region, about).value_or(next.region);
    }
  } catch (const ArgumentError& error) {
    Q_EMIT failed(spokenError(error), {}, work.open.file);
  }
  if (next.surface->tiles && !windowFor(next)) return;  // What was shown stays.
  history_.clear();
  ahead_ = next.surface->tiles ? std::make_unique<TilePrefetcher>(next.surface->tiles) : nullptr;
  restoreSteps(work, next);
  Q_EMIT opened(file());
}

// Each step began where its record says, and ended where the next one began.
void Document::restoreSteps(const Work& work, const DocumentState& now) {
  const std::vector<NamedRegion>& undo = work.open.undo;
  earlier_steps_ = work.open.history;
  const int levels = now.surface->ladder.levels();
  const bool fits = undo.size() <= earlier_steps_.size() &&
                    std::all_of(undo.begin(), undo.end(), [&](const NamedRegion& step) {
                      return step.region.level.value < levels;
                    });
  apply(now);
  if (!fits || undo.empty() || now.region != work.open.exact_region) return;
  earlier_steps_.resize(earlier_steps_.size() - undo.size());
  const auto state_of = [&](const NamedRegion& step) {
    DocumentState state = now;
    state.region = step.region;
    state.gain = step.gain;
    return state;
  };
  // They end at what is shown already: of all the windows on the way none is needed.
  steps_come_back_ = true;
  state_ = state_of(undo.front());
  for (std::size_t i = 0; i < undo.size(); ++i) {
    const DocumentState after = i + 1 < undo.size() ? state_of(undo[i + 1]) : now;
    push(after, QString::fromStdString(undo[i].name));
  }
  steps_come_back_ = false;
}

std::vector<std::string> Document::stepNames() const {
  std::vector<std::string> names = earlier_steps_;
  for (int i = 0; i < history_.index(); ++i) names.push_back(history_.text(i).toStdString());
  return names;
}

std::vector<NamedRegion> Document::undoSteps() const {
  std::vector<NamedRegion> steps;
  for (int i = history_.index() - 1; i >= 0; --i) {
    const auto* command = dynamic_cast<const StateCommand*>(history_.command(i));
    if (command == nullptr) continue;  // The window's own: it changed no region.
    const DocumentState& before = command->before();
    if (before.surface != state_.surface) break;  // Its surface would have to be made again.
    steps.push_back(
        {.name = history_.text(i).toStdString(), .region = before.region, .gain = before.gain});
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

StepAbout Document::aboutCentre() const {
  return {state_.region.centreX(), state_.region.centreY(), false};
}

void Document::push(DocumentState after, const QString& name, int merge_id) {
  history_.push(new StateCommand(*this, state_, std::move(after), name, merge_id));
}

void Document::go(const std::optional<Region>& region, const QString& name) {
  if (!region) return;
  DocumentState after = state_;
  after.region = *region;
  push(std::move(after), name);
}

bool Document::finer(const StepAbout& about) {
  if (!isOpen() || inGesture()) return false;
  const auto next = relievo::finer(state_.surface->ladder, state_.region, about);
  if (!next) return false;
  go(next, detailName(detail(), state_.surface->ladder.detailOf(next->level), false));
  return true;
}

bool Document::coarser(const StepAbout& about) {
  if (!isOpen() || inGesture()) return false;
  const auto next = relievo::coarser(state_.surface->ladder, state_.region, about);
  if (!next) return false;
  go(next, detailName(detail(), state_.surface->ladder.detailOf(next->level), true));
  return true;
}

bool Document::whole() {
  if (!isOpen() || inGesture()) return false;
  const Region next = wholeRegion(state_.surface->ladder);
  if (next == state_.region) return false;
  go(next, tr("Whole object"));
  return true;
}

bool Document::move(double dx, double dy) {
  if (!isOpen() || inGesture()) return false;
  const auto next = moved(state_.surface->ladder, state_.region, dx, dy);
  if (!next || *next == state_.region) return false;
  go(next, tr("Move window"));
  return true;
}

bool Document::setLevel(Level level) {
  if (!isOpen() || inGesture() || level == state_.region.level) return false;
  const auto next = atLevel(state_.surface->ladder, state_.region, level);
  if (!next) return false;
  go(next, detailName(detail(), state_.surface->ladder.detailOf(level), false));
  return true;
}

bool Document::setRect(const RectMm& rect) {
  if (!isOpen() || inGesture()) return false;
  try {
    const Region next = regionFromRect(state_.surface->ladder, rect);
    if (next == state_.region) return false;
    go(next, tr("Choose window"));
    return true;
  } catch (const ArgumentError& error) {
    Q_EMIT failed(spokenError(error), {}, {});
    return false;
  }
}

bool Document::setGain(double gain) {
  if (!isOpen() || inGesture() || !(gain > 0) || gain == state_.gain) return false;
  DocumentState after = state_;
  after.gain = gain;
  push(std::move(after), tr("Height gain"), kMergeGain);
  return true;
}

bool Document::goTo(const Region& region, double gain, const QString& name) {
  if (!isOpen() || inGesture() || !(gain > 0)) return false;
  DocumentState after = state_;
  after.region = region;
  after.gain = gain;
  if (after == state_) return false;
  push(std::move(after), name);
  return true;
}

bool Document::zoomTo(const Region& region) {
  if (!isOpen() || inGesture() || region == state_.region) return false;
  DocumentState after = state_;
  after.region = region;
  push(std::move(after), tr("Zoom"), kMergeZoom);
  return true;
}

void Document::preview(const Region& region) {
  if (!isOpen() || !(region.side_mm > 0) || region == state_.region) return;
  if (!gesture_start_) gesture_start_ = state_;
  DocumentState next = state_;
  next.region = region;
  apply(next);
}

void Document::previewGain(double gain) {
  if (!isOpen() || !(gain > 0) || gain == state_.gain) return;
  if (!gesture_start_) gesture_start_ = state_;
  DocumentState next = state_;
  next.gain = gain;
  apply(next);
}

void Document::commit(const QString& name) {
  if (!gesture_start_) return;
  const DocumentState before = *std::exchange(gesture_start_, std::nullopt);
  if (before == state_) return;
  history_.push(new StateCommand(*this, before, state_, name, -1));
}

void Document::revert() {
  if (!gesture_start_) return;
  apply(*std::exchange(gesture_start_, std::nullopt));
}

std::shared_ptr<const RegionWindow> Document::windowFor(const DocumentState& state) {
  try {
    return std::make_shared<const RegionWindow>(windowOf(*state.surface, state.region, state.gain));
  } catch (const FileError& error) {
    Q_EMIT failed(spokenError(error), {}, {});
    return nullptr;
  }
}

bool Document::apply(const DocumentState& state) {
  if (steps_come_back_) {
    state_ = state;
    return true;
  }
  const bool other_surface = state.surface != state_.surface;
  const bool other_window =
      other_surface || !window_ || state.region != state_.region || state.gain != state_.gain;
  if (other_window) {
    auto window = windowFor(state);
    if (!window) return false;
    window_ = std::move(window);
  }
  const bool other_file = state.file != state_.file;
  state_ = state;
  if (other_file) Q_EMIT fileChanged(file());
  if (ahead_ && other_window) ahead_->around(state_.region);
  if (other_surface) Q_EMIT surfaceChanged();
  if (other_window) Q_EMIT windowChanged();
  return true;
}

}  // namespace relievo
