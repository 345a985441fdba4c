// SPDX-License-Identifier: BSD-3-Clause
// Named places, views as text, and work that outlives a crash.
#include <algorithm>
#include <cmath>
#include <QAction>
#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QTimer>
#include <utility>

#include "core/base/error.h"
#include "core/region/window.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/side_panels.h"
#include "ui/language/spoken_error.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/places_panel.h"
#include "ui/panels/stereo_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/views/detail_view.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"
#include "ui/work/work_keeper.h"

namespace relievo {
namespace {

constexpr int kMostBeacons = 9;
// Of steps that merge while a slider is dragged; the document's own ids are below.
constexpr int kMergeLight = 102, kMergeShading = 103;
constexpr double kSameBeaconMm = 5;  // Of hand: nearer than that is the same beacon.

QString beaconName(int number) {
  return MainWindow::tr("Beacon %1").arg(number);
}

bool isBeacon(const NamedRegion& place) {
  for (int n = 1; n <= kMostBeacons; ++n) {
    if (place.name == beaconName(n).toStdString()) return true;
  }
  return false;
}

/// The first name that is not taken; empty: all are.
QString freeBeacon(const std::vector<NamedRegion>& places) {
  for (int n = 1; n <= kMostBeacons; ++n) {
    const std::string name = beaconName(n).toStdString();
    const auto has = [&](const NamedRegion& p) { return p.name == name; };
    if (std::none_of(places.begin(), places.end(), has)) return beaconName(n);
  }
  return {};
}

}  // namespace

void MainWindow::makePlaceCommands() {
  commands_.on(Command::name_place, this, [this] { namePlace(); });
  commands_.on(Command::next_place, this, [this] { places_panel_->step(1); });
  commands_.on(Command::previous_place, this, [this] { places_panel_->step(-1); });
  commands_.on(Command::copy_view, this, [this] { copyView(); });
  commands_.on(Command::paste_view, this, [this] { pasteView(); });
  commands_.on(Command::beacon, this, [this] { toggleBeacon(); });
}

void MainWindow::connectPlaces() {
  connect(places_panel_, &PlacesPanel::addAsked, this, &MainWindow::namePlace);
  connect(places_panel_, &PlacesPanel::goAsked, this, &MainWindow::goToPlace);
  connect(places_panel_, &PlacesPanel::said, this, &MainWindow::announce);
  connect(stereo_panel_, &StereoPanel::changed, this, &MainWindow::chooseStereo);
  // The window may be another one before the panel has heard of another stereo.
  connect(stereo_panel_, &StereoPanel::drawnChanged, this, &MainWindow::showStereo);
  connect(view_panel_, &ViewPanel::lightChanged, this, [this](const LightOptions& light) {
    chooseLook(
        tr("Light"), [&](ReliefLook& look) { look.light = light; }, kMergeLight);
  });
  connect(view_panel_, &ViewPanel::shadingChanged, this, [this](double shading) {
    chooseLook(
        tr("Shading of colours"), [&](ReliefLook& look) { look.shading = shading; }, kMergeShading);
  });
  connect(&document_, &Document::amended, this, &MainWindow::keepWork);
  connect(&document_.history(), &QUndoStack::indexChanged, this, &MainWindow::keepWork);
  connect(keeper_, &WorkKeeper::failed, this, &MainWindow::showMessage);
}

void MainWindow::keepWork() {
  if (!document_.isOpen()) return;
  keeper_->changed();
  if (std::exchange(title_due_, true)) return;
  constexpr int kTitleMs = 200;  // Of many changes in a row the title tells the last.
  QTimer::singleShot(kTitleMs, this, [this] {
    title_due_ = false;
    showTitle();
  });
}

void MainWindow::namePlace() {
  if (!document_.isOpen()) return;
  commands_[Command::show_panels].setChecked(true);
  panels_->reveal(places_panel_);
  NamedRegion place{.name = places_panel_->freeName().toStdString(),
                    .region = document_.project().region,
                    .gain = document_.project().gain};
  if (places_panel_->withView()) place.view = viewOf(document_.project());
  places_panel_->add(std::move(place));
}

// A beacon's window is centred on the hand wherever that lies; it is put on the map when gone to.
void MainWindow::toggleBeacon() {
  const auto window = document_.window();
  if (!window) return;
  const StepAbout here = about();
  const double reach_mm = kSameBeaconMm * handMapping(*window).objectMmPerHandMm();
  const std::vector<NamedRegion>& places = places_panel_->places();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Region& r = places[i].region;
    const double away_mm = std::hypot(r.centreX() - here.x_mm, r.centreY() - here.y_mm);
    if (!isBeacon(places[i]) || away_mm > reach_mm) continue;
    const QString name = QString::fromStdString(places[i].name);
    places_panel_->removeAt(i);
    announce(tr("%1 removed.").arg(name));
    return;
  }
  const QString name = freeBeacon(places);
  if (name.isEmpty()) {
    announce(tr("There are %1 beacons already. Remove one first.").arg(kMostBeacons));
    return;
  }
  NamedRegion place{.name = name.toStdString(),
                    .region = document_.project().region,
                    .gain = document_.project().gain};
  place.region.x_mm = here.x_mm - 0.5 * place.region.side_mm;
  place.region.y_mm = here.y_mm - 0.5 * place.region.side_mm;
  places_panel_->put(std::move(place));
  announce(tr("%1 set.").arg(name));
}

void MainWindow::goToPlace(const NamedRegion& place) {
  const QString name = QString::fromStdString(place.name);
  if (!document_.isOpen()) return;
  if (place.region.level.value >= document_.details()) {
    strip_->show(
        tr("%1 lies on a finer detail than this map has. The window was not moved.").arg(name));
    return;
  }
  Region to = place.region;
  if (isBeacon(place)) to = moved(document_.surface()->ladder, to, 0, 0).value_or(to);
  if (place.view) showView(*place.view, tr("Go to %1").arg(name));
  document_.goTo(to, place.gain, tr("Go to %1").arg(name));
  announce(tr("%1. Detail %2 of %3").arg(name).arg(document_.detail()).arg(document_.details()));
}

void MainWindow::copyView() {
  QGuiApplication::clipboard()->setText(
      QString::fromStdString(toText(viewOf(document_.project()))));
  announce(tr("The view is copied as text"));
}

void MainWindow::pasteView() {
  if (!document_.isOpen()) return;
  try {
    const ViewState view =
        viewFromText(QGuiApplication::clipboard()->text().trimmed().toStdString());
    const DetailLadder& ladder = document_.surface()->ladder;
    if (view.region.level.value >= document_.details() || !onMap(ladder, view.region)) {
      strip_->show(
          tr("The copied view does not lie on this map. The window was not moved. Open the "
             "scan that it was copied from."));
      return;
    }
    showView(view, tr("Paste view"));
    document_.goTo(view.region, view.gain, tr("Paste view"));
    announce(tr("The copied view is shown. Detail %1 of %2")
                 .arg(document_.detail())
                 .arg(document_.details()));
  } catch (const Error& error) {
    strip_->show(shownError(error));
  }
}

void MainWindow::offerLeftWork() {
  const auto left = keeper_->left();
  if (!left) return;
  const Project& work = left->project;
  const QString name = shownName(pathFromBytes(work.saved_as.empty() ? work.file : work.saved_as));
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
