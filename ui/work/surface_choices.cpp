// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/surface_choices.h"

#include "ui/work/document.h"

namespace relievo {

const SurfaceOptions& SurfaceChoices::now() const {
  return document_.project().options;
}

void SurfaceChoices::setView(const ViewChoice& view) {
  if (!document_.isOpen()) return;
  SurfaceOptions options = now();
  options.view = view;
  document_.remake(options, tr("View %1 \u2192 %2")
                                .arg(QString::fromStdString(document_.surface()->view_name),
                                     QString::fromStdString(view.name)));
}

void SurfaceChoices::turnTo(const Rotation& view, const ReliefTurn& turn) {
  if (!document_.isOpen()) return;
  SurfaceOptions options = now();
  options.view = {"free", view};
  document_.remake(options, tr("Turn the relief"), turn);
}

void SurfaceChoices::setEngine(const QString& engine) {
  if (!document_.isOpen() || engine.toStdString() == now().engine) return;
  SurfaceOptions options = now();
  options.engine = engine.toStdString();
  document_.remake(
      options,
      tr("Depth method \u2192 %1").arg(engine == QLatin1String("cpu") ? tr("CPU") : tr("OpenGL")));
}

void SurfaceChoices::setUnit(LengthUnit unit) {
  if (!document_.isOpen()) return;
  SurfaceOptions options = now();
  options.unit = unit;
  options.unit_source = UnitSource::given;
  const auto text = [](LengthUnit u) { return QString::fromUtf8(name(u).data()); };
  document_.remake(options,
                   tr("Unit %1 \u2192 %2").arg(text(document_.surface()->unit), text(unit)));
}

void SurfaceChoices::setStrays(StrayRule rule) {
  if (!document_.isOpen() || rule == now().strays) return;
  SurfaceOptions options = now();
  options.strays = rule;
  document_.remake(options, rule == StrayRule::keep          ? tr("Keep far-off points")
                            : rule == StrayRule::drop_groups ? tr("Leave out far-off groups")
                                                             : tr("Leave out far-off points"));
}

void SurfaceChoices::setNodata(const NodataChoice& nodata) {
  if (!document_.isOpen() || nodata == now().nodata) return;
  SurfaceOptions options = now();
  options.nodata = nodata;
  document_.remake(options, nodata.value ? tr("Take heights as missing") : tr("Keep all heights"));
}

void SurfaceChoices::setRasterScale(const RasterScale& scale) {
  if (!document_.isOpen() || scale == now().raster) return;
  SurfaceOptions options = now();
  options.raster = scale;
  document_.remake(options, tr("Size of the samples"));
}

}  // namespace relievo
