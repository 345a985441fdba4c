// SPDX-License-Identifier: BSD-3-Clause
// Choices between the file and its surface; each makes it anew from what is in memory.
#include "ui/work/document.h"

namespace relievo {

void Document::setView(const ViewChoice& view) {
  if (!isOpen()) return;
  SurfaceOptions options = state_.project.options;
  options.view = view;
  remake(options, tr("View %1 \u2192 %2")
                      .arg(QString::fromStdString(state_.surface->view_name),
                           QString::fromStdString(view.name)));
}

void Document::setEngine(const QString& engine) {
  if (!isOpen() || engine.toStdString() == state_.project.options.engine) return;
  SurfaceOptions options = state_.project.options;
  options.engine = engine.toStdString();
  remake(
      options,
      tr("Depth method \u2192 %1").arg(engine == QLatin1String("cpu") ? tr("CPU") : tr("OpenGL")));
}

void Document::setUnit(LengthUnit unit) {
  if (!isOpen()) return;
  SurfaceOptions options = state_.project.options;
  options.unit = unit;
  options.unit_source = UnitSource::given;
  const auto text = [](LengthUnit u) { return QString::fromUtf8(name(u).data()); };
  remake(options, tr("Unit %1 \u2192 %2").arg(text(state_.surface->unit), text(unit)));
}

void Document::setStrays(StrayRule rule) {
  if (!isOpen() || rule == state_.project.options.strays) return;
  SurfaceOptions options = state_.project.options;
  options.strays = rule;
  remake(options, rule == StrayRule::keep          ? tr("Keep far-off points")
                  : rule == StrayRule::drop_groups ? tr("Leave out far-off groups")
                                                   : tr("Leave out far-off points"));
}

void Document::setNodata(const NodataChoice& nodata) {
  if (!isOpen() || nodata == state_.project.options.nodata) return;
  SurfaceOptions options = state_.project.options;
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

void Document::setRasterScale(const RasterScale& scale) {
  if (!isOpen() || scale == state_.project.options.raster) return;
  SurfaceOptions options = state_.project.options;
  options.raster = scale;
  remake(options, tr("Size of the samples"));
}

}  // namespace relievo
