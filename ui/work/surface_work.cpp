// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/surface_work.h"

#include <cmath>
#include <new>
#include <QCoreApplication>

#include "core/base/failure.h"
#include "core/depth/rules/rasterize.h"
#include "core/session/source/unit_guess.h"
#include "ui/language/error_text.h"

namespace relievo {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("relievo", text);
}

std::optional<std::uint64_t> everyOffered(const Message& message) {
  constexpr std::size_t kEvery = 4;  // Among its arguments.
  if (message.id != MessageId::points_need_memory) return std::nullopt;
  return std::get<CountArgument>(message.arguments.at(kEvery)).value;
}

}  // namespace

FilePoint sizeMm(const OpenedInput& source, const SurfaceOptions& options) {
  const ScanInfo& info = source.info();
  const UnitInUse unit = unitInUse(info, options.unit, options.unit_source);
  FilePoint size = mmPer(unit.unit) * (info.bounds->max - info.bounds->min);
  if (!source.raster || source.raster->is_own_map) return size;
  const RasterMap& raster = *source.raster;
  const ScaleInUse scale = scaleInUse(raster, unit.unit, unit.source, options.raster,
                                      info.bounds->min.z, info.bounds->max.z);
  size = info.bounds->max - info.bounds->min;
  const double mm = scale.pixel_mm / raster.pixel;
  return {mm * size.x, mm * size.y, std::abs(scale.height_mm) * size.z};
}

SurfaceOutcome outcomeOf(const std::function<std::shared_ptr<const Surface>()>& work) {
  SurfaceOutcome out;
  try {
    out.surface = work();
  } catch (const Cancelled&) {
    out.cancelled = true;
  } catch (const Error& error) {
    out.error = spokenError(error);
    out.code = QString::fromStdString(error.code);
    if (error.message) out.every = everyOffered(*error.message);
  } catch (const std::bad_alloc&) {
    out.error =
        tr("There is not enough memory for this. Nothing was changed. Close other programs "
           "or choose a smaller file.");
  } catch (const std::exception& error) {
    out.error = tr("This failed unexpectedly: %1. Nothing was changed.").arg(spokenError(error));
  }
  return out;
}

std::shared_ptr<const Surface> makeSurface(const OpenedInput& source, const SurfaceOptions& options,
                                           const DepthEngine& depth_buffer, const Task& task) {
  if (source.tiled) return source.tiled;
  if (source.raster) {
    return std::make_shared<const Surface>(makeSurface(*source.raster, options, task));
  }
  const DepthEngine engine = options.engine == "cpu" ? DepthEngine(rasterize) : depth_buffer;
  return std::make_shared<const Surface>(makeSurface(*source.scan, options, engine, task));
}

}  // namespace relievo
