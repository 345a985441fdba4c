// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/surface_loader.h"

#include <QFile>

#include "core/io/import.h"
#include "core/provenance/sha256.h"
#include "core/session/source/unit_guess.h"
#include "core/tiles/published/published_tiles.h"
#include "ui/work/file_names.h"
#include "ui/work/pictures/depth_map_picture.h"
#include "ui/work/pictures/relief_picture.h"

namespace relievo {
namespace {

std::filesystem::path pathOf(const LoadJob& job) {
  return QFile::encodeName(job.open.file).toStdString();
}

}  // namespace

SurfaceLoader::SurfaceLoader(DepthEngine depth_buffer) : depth_buffer_(std::move(depth_buffer)) {
  connect(&worker_, &LatestWorker::busyChanged, this, &SurfaceLoader::busyChanged);
  connect(&worker_, &LatestWorker::progressed, this, &SurfaceLoader::progressed);
}

// Nobody hears of work that ends with the loader.
SurfaceLoader::~SurfaceLoader() {
  worker_.disconnect();
}

ImportOptions SurfaceLoader::importOf(const LoadJob& job) const {
  ImportOptions import;
  import.accept_incomplete = job.open.accept_incomplete;
  import.scan = job.open.scan;
  import.free_bytes = free_bytes_;
  return import;
}

void SurfaceLoader::start(LoadJob job) {
  const auto shared = std::make_shared<LoadJob>(std::move(job));
  in_hand_ = shared;
  offered_every_.reset();
  Q_EMIT workStarted();
  worker_.start(
      [this, shared, import = importOf(*shared), least = first_view_from_](const Task& task) {
        LoadJob& j = *shared;
        j.outcome = outcomeOf([&] {
          if (j.reads) find(j, task);
          if (j.reads) showFirstViews(shared, import, least, task);
          if (j.reads) read(j, import, task);
          task.check();
          auto surface = makeSurface(j.source, j.options, depth_buffer_, task);
          // For the start page.
          if (j.reads) ReliefPictures::keep(j.open.file, reliefPicture(*surface, kPicturePx));
          return surface;
        });
      },
      [this, shared] { finish(*shared); });
}

void SurfaceLoader::find(LoadJob& job, const Task& task) {
  if (!isAddress(job.open.file)) return;
  task.report("Fetching the map", 0);
  const WebMap map = webMap(bytesOfPath(job.open.file), task);
  job.open.file = pathFromBytes(map.manifest.native());
  job.from_before = map.from_before;
}

void SurfaceLoader::cancel() {
  if (worker_.cancel()) Q_EMIT cancelled();
}

void SurfaceLoader::showFirstViews(const std::shared_ptr<LoadJob>& job, const ImportOptions& import,
                                   std::uint64_t least_points, const Task& task) {
  FirstViewOptions views;
  views.least_points = least_points;
  views.on_view = [&](const FirstView& view) {
    const QImage picture = pictureOf(view.surface, task).shaded;
    const std::weak_ptr<LoadJob> of = job;
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
  makeFirstViews(pathOf(*job), job->options, import, views, task);
}

void SurfaceLoader::read(LoadJob& job, const ImportOptions& import, const Task& task) {
  const std::filesystem::path file = pathOf(job);
  job.source = openInput(file, {.import = import}, task);
  const ScanInfo& info = job.source.info();
  if (!job.options.unit && !info.unit && job.open.remembered_unit) {
    job.options.unit = job.open.remembered_unit;
    job.options.unit_source = UnitSource::remembered;
  }
  // A raster has its own.
  if (job.kept && job.source.scan && !job.options.view) job.options.view = job.kept->options.view;
  if (info.bounds) {
    const FilePoint size = sizeMm(job.source, job.options);
    Q_EMIT scanRead(job.open.file, size.x, size.y, size.z, info.points);
  }
  job.sha256 = QString::fromStdString(sha256OfFile(file, task));
}

void SurfaceLoader::finish(const LoadJob& job) {
  if (job.outcome.cancelled) {
    Q_EMIT cancelled();
    return;
  }
  if (!job.outcome.surface) {
    offered_every_ = job.outcome.every;
    Q_EMIT failed(job.outcome.error, job.outcome.code, addressOrPath(job.open.file));
    return;
  }
  Q_EMIT made(job);
}

}  // namespace relievo
