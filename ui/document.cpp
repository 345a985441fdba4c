// SPDX-License-Identifier: BSD-3-Clause
#include "ui/document.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <QCryptographicHash>
#include <QFile>
#include <QUndoCommand>

#include "core/depth/rasterize.h"
#include "core/io/import.h"

namespace relievo {
namespace {

constexpr int kUndoLimit = 100;
constexpr int kMergeGain = 1;
constexpr int kMergeZoom = 2;
constexpr auto kProgressPeriod = std::chrono::milliseconds(33);

QString detailName(int from, int to) {
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

  void undo() override { document_.apply(before_); }
  void redo() override { document_.apply(after_); }
  int id() const override { return merge_id_; }
  bool mergeWith(const QUndoCommand* later) override {
    if (later->id() != merge_id_) return false;
    after_ = static_cast<const StateCommand*>(later)->after_;
    return true;
  }

 private:
  Document& document_;
  DocumentState before_, after_;
  int merge_id_;
};

/// Hexadecimal; empty if the file cannot be read again.
QString sha256Of(const QString& path, const Task& task) {
  constexpr qint64 kBlock = 4 << 20;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QCryptographicHash hash(QCryptographicHash::Sha256);
  while (!file.atEnd()) {
    task.check();
    hash.addData(file.read(kBlock));
  }
  return QString::fromLatin1(hash.result().toHex());
}

bool sameGrid(const Surface& a, const Surface& b) {
  return a.map.frame == b.map.frame && a.ladder.spacings_mm == b.ladder.spacings_mm;
}

}  // namespace

struct Document::Work {
  std::uint64_t id = 0;
  bool reads = false;  ///< Reads `open.file`; otherwise works on what is in memory.
  OpenRequest open;
  std::shared_ptr<const Scan> scan;
  std::shared_ptr<const RasterMap> raster;
  SurfaceOptions options;
  QString name;  ///< In the history.
};

struct Document::Outcome {
  Work work;
  std::shared_ptr<const Surface> surface;
  bool cancelled = false;
  QString error, code, sha256;
};

Document::Document(DepthEngine depth_buffer, QObject* parent)
    : QObject(parent), depth_buffer_(std::move(depth_buffer)) {
  history_.setUndoLimit(kUndoLimit);
}

Document::~Document() {
  worker_.request_stop();
  if (worker_.joinable()) worker_.join();
}

void Document::open(const OpenRequest& request) {
  Work work;
  work.reads = true;
  work.open = request;
  work.options.unit = request.unit;
  work.options.view = request.view;
  start(std::move(work));
}

void Document::cancel() {
  if (!busy()) return;
  request_ = 0;
  pending_.reset();
  worker_.request_stop();
  Q_EMIT busyChanged(false);
  Q_EMIT cancelled();
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

void Document::remake(const SurfaceOptions& options, const QString& name) {
  Work work;
  work.scan = scan_;
  work.raster = raster_;
  work.options = options;
  work.name = name;
  start(std::move(work));
}

void Document::start(Work work) {
  const bool was_busy = busy();
  request_ = work.id = ++last_request_;
  if (running_) {
    worker_.request_stop();
    pending_ = std::make_unique<Work>(std::move(work));
  } else {
    launch(std::move(work));
  }
  if (!was_busy) Q_EMIT busyChanged(true);
}

void Document::launch(Work work) {
  if (worker_.joinable()) worker_.join();
  running_ = true;
  worker_ = std::jthread([this, work = std::move(work)](std::stop_token stop) {
    Task task;
    task.stop = std::move(stop);
    auto last = std::chrono::steady_clock::time_point{};
    task.progress = [this, id = work.id, last](std::string_view step, double fraction) mutable {
      const auto now = std::chrono::steady_clock::now();
      if (now - last < kProgressPeriod) return;
      last = now;
      const QString text = QString::fromUtf8(step.data(), static_cast<int>(step.size()));
      QMetaObject::invokeMethod(
          this,
          [this, id, text, fraction] {
            if (id == request_) Q_EMIT progressed(text, fraction);
          },
          Qt::QueuedConnection);
    };
    auto outcome = std::make_shared<Outcome>(compute(work, depth_buffer_, task));
    QMetaObject::invokeMethod(
        this, [this, outcome] { finish(outcome); }, Qt::QueuedConnection);
  });
}

Document::Outcome Document::compute(const Work& work, const DepthEngine& depth_buffer,
                                    const Task& task) {
  Outcome out;
  out.work = work;
  Work& w = out.work;
  try {
    if (w.reads) {
      const std::filesystem::path file(QFile::encodeName(w.open.file).toStdString());
      if (looksLikeRaster(file)) {
        w.raster = std::make_shared<const RasterMap>(readRaster(file));
      } else {
        ImportOptions import;
        import.accept_incomplete = w.open.accept_incomplete;
        w.scan = std::make_shared<const Scan>(importScan(file, import, task));
      }
      const ScanInfo& info = w.scan ? w.scan->info : w.raster->info;
      if (!w.options.unit && !info.unit && w.open.remembered_unit) {
        w.options.unit = w.open.remembered_unit;
        w.options.unit_source = UnitSource::remembered;
      }
      out.sha256 = sha256Of(w.open.file, task);
    }
    task.check();
    const DepthEngine engine = w.options.engine == "cpu" ? DepthEngine(rasterize) : depth_buffer;
    out.surface =
        std::make_shared<const Surface>(w.scan ? makeSurface(*w.scan, w.options, engine, task)
                                               : makeSurface(*w.raster, w.options, task));
  } catch (const Cancelled&) {
    out.cancelled = true;
  } catch (const Error& error) {
    out.error = QString::fromUtf8(error.what());
    out.code = QString::fromStdString(error.code);
  } catch (const std::bad_alloc&) {
    out.error =
        tr("There is not enough memory for this. Nothing was changed. Close other programs "
           "or choose a smaller file.");
  } catch (const std::exception& error) {
    out.error = tr("This failed unexpectedly: %1. Nothing was changed.")
                    .arg(QString::fromUtf8(error.what()));
  }
  return out;
}

void Document::finish(const std::shared_ptr<Outcome>& outcome) {
  running_ = false;
  if (pending_) launch(std::move(*std::exchange(pending_, nullptr)));
  if (outcome->work.id != request_) return;  // Cancelled, or a newer request took its place.
  request_ = 0;
  Q_EMIT busyChanged(false);
  if (outcome->cancelled) {
    Q_EMIT cancelled();
    return;
  }
  if (!outcome->surface) {
    Q_EMIT failed(outcome->error, outcome->code, outcome->work.open.file);
    return;
  }
  revert();
  const Work& work = outcome->work;
  DocumentState next{outcome->surface, work.options, wholeRegion(outcome->surface->ladder), 1};
  if (!work.reads) {
    next.gain = state_.gain;
    if (sameGrid(*state_.surface, *next.surface)) next.region = state_.region;
    push(std::move(next), work.name);
    return;
  }
  file_ = work.open.file;
  sha256_ = outcome->sha256;
  scan_ = work.scan;
  raster_ = work.raster;
  history_.clear();
  const DetailLadder& ladder = next.surface->ladder;
  try {
    if (work.open.region) next.region = regionFromRect(ladder, *work.open.region);
    for (int d = 1; work.open.detail && d < *work.open.detail && !work.open.region; ++d) {
      const StepAbout about{next.region.centreX(), next.region.centreY(), false};
      next.region = relievo::finer(ladder, next.region, about).value_or(next.region);
    }
  } catch (const ArgumentError& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()), {}, file_);
  }
  apply(next);
  Q_EMIT opened(file_);
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
  go(next, detailName(detail(), state_.surface->ladder.detailOf(next->level)));
  return true;
}

bool Document::coarser(const StepAbout& about) {
  if (!isOpen() || inGesture()) return false;
  const auto next = relievo::coarser(state_.surface->ladder, state_.region, about);
  if (!next) return false;
  go(next, detailName(detail(), state_.surface->ladder.detailOf(next->level)));
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
  go(next, detailName(detail(), state_.surface->ladder.detailOf(level)));
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
    Q_EMIT failed(QString::fromUtf8(error.what()), {}, {});
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

void Document::apply(const DocumentState& state) {
  const bool other_surface = state.surface != state_.surface;
  const bool other_window =
      other_surface || !window_ || state.region != state_.region || state.gain != state_.gain;
  state_ = state;
  if (other_window) {
    window_ = std::make_shared<const RegionWindow>(
        sampleWindow(state_.surface->map, state_.surface->pyramid, state_.region, state_.gain));
  }
  if (other_surface) Q_EMIT surfaceChanged();
  if (other_window) Q_EMIT windowChanged();
}

}  // namespace relievo
