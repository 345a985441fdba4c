// SPDX-License-Identifier: BSD-3-Clause
// Named places, and work that outlives a crash.
#include <QAction>
#include <QFileInfo>

#include "ui/detail_view.h"
#include "ui/main_window.h"
#include "ui/measure_panel.h"
#include "ui/message_strip.h"
#include "ui/places_panel.h"
#include "ui/stereo_panel.h"
#include "ui/view_panel.h"
#include "ui/work_keeper.h"

namespace relievo {

void MainWindow::makePlaceCommands() {
  make({"name_place",
        tr("Na&me this place\u2026"),
        {QKeySequence("Ctrl+N")},
        tr("Give the window's place a name, to come back to it"),
        [this] { namePlace(); },
        {}});
  make({"next_place",
        tr("Ne&xt place"),
        {QKeySequence("Ctrl+PgDown")},
        tr("Go to the next place that has a name"),
        [this] { places_panel_->step(1); },
        {}});
  make({"previous_place",
        tr("Pre&vious place"),
        {QKeySequence("Ctrl+PgUp")},
        tr("Go to the place with a name before this one"),
        [this] { places_panel_->step(-1); },
        {}});
}

void MainWindow::connectPlaces() {
  connect(places_panel_, &PlacesPanel::addAsked, this, &MainWindow::namePlace);
  connect(places_panel_, &PlacesPanel::goAsked, this, &MainWindow::goToPlace);
  connect(places_panel_, &PlacesPanel::said, this, &MainWindow::announce);
  connect(places_panel_, &PlacesPanel::changed, this, &MainWindow::keepWork);
  connect(measure_panel_, &MeasurePanel::changed, this, &MainWindow::keepWork);
  connect(stereo_panel_, &StereoPanel::changed, this, &MainWindow::keepWork);
  connect(view_panel_, &ViewPanel::lightChanged, this, &MainWindow::keepWork);
  connect(&document_.history(), &QUndoStack::indexChanged, this, &MainWindow::keepWork);
  connect(keeper_, &WorkKeeper::failed, this, &MainWindow::showMessage);
}

void MainWindow::keepWork() {
  if (document_.isOpen()) keeper_->changed();
}

void MainWindow::namePlace() {
  if (!document_.isOpen()) return;
  command("show_panels")->setChecked(true);
  NamedRegion place{.name = places_panel_->freeName().toStdString(),
                    .region = document_.state().region,
                    .gain = document_.state().gain};
  if (places_panel_->withView()) place.view = viewOf(project());
  places_panel_->add(std::move(place));
}

void MainWindow::goToPlace(const NamedRegion& place) {
  const QString name = QString::fromStdString(place.name);
  if (!document_.isOpen()) return;
  if (place.region.level.value >= document_.details()) {
    strip_->show(
        tr("%1 lies on a finer detail than this map has. The window was not moved.").arg(name));
    return;
  }
  document_.goTo(place.region, place.gain, tr("Go to %1").arg(name));
  if (place.view) showView(*place.view);
  announce(tr("%1. Detail %2 of %3").arg(name).arg(document_.detail()).arg(document_.details()));
}

void MainWindow::showView(const ViewState& view) {
  showStereo(view.stereo);
  showLook(view.look);
  view_panel_->showLight(view.look.light);
  detail_->straighten();
  detail_->turnBy(view.azimuth_deg, view.elevation_deg);
}

void MainWindow::offerLeftWork() {
  const auto left = keeper_->left();
  if (!left) return;
  const QString name = QFileInfo(QString::fromStdString(left->project.file)).fileName();
  const int steps = static_cast<int>(left->project.history.size());
  strip_->show(
      tr("relievo ended unexpectedly. Work on %1 of %2 was kept (%n step(s)).", nullptr, steps)
          .arg(name, left->time),
      {{tr("&Restore"),
        [this, left] {
          recovered_copy_ = left->copy;
          restore(left->project, {});
        }},
       {tr("&Discard"), [this, left] {
          WorkKeeper::discard(left->copy);
          offerLeftWork();
        }}});
}

}  // namespace relievo
