// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/surface_work.h"

#include <new>
#include <QCoreApplication>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "ui/language/spoken_error.h"

namespace relievo {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("relievo", text);
}

}  // namespace

SurfaceOutcome outcomeOf(const std::function<std::shared_ptr<const Surface>()>& work) {
  SurfaceOutcome out;
  try {
    out.surface = work();
  } catch (const Cancelled&) {
    out.cancelled = true;
  } catch (const Error& error) {
    out.error = spokenError(error);
    out.code = QString::fromStdString(error.code);
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
