// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/place_controller.h"

#include <algorithm>
#include <cmath>
#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <utility>

#include "core/base/error.h"
#include "core/region/window.h"
#include "ui/control/look_controller.h"
#include "ui/control/touch_controller.h"
#include "ui/frame/side_panels.h"
#include "ui/language/error_text.h"
#include "ui/panels/places_panel.h"
#include "ui/panels/suggest_panel.h"
#include "ui/views/reference_view.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr int kMostMarkers = 9;
constexpr double kSameMarkerMm = 5;  // Of hand: nearer than that is the same marker.

QString markerName(int number) {
  return PlaceController::tr("Marker %1").arg(number);
}

/// The first name that is not taken; empty: all are.
QString freeMarker(const std::vector<NamedRegion>& places) {
  for (int n = 1; n <= kMostMarkers; ++n) {
    const std::string name = markerName(n).toStdString();
    const auto has = [&](const NamedRegion& p) { return p.name == name; };
    if (std::none_of(places.begin(), places.end(), has)) return markerName(n);
  }
  return {};
}

}  // namespace

PlaceController::PlaceController(const ControllerParts& parts, const Panels& panels,
                                 ReferenceView& reference, LookController& look,
                                 const TouchController& touch)
    : Controller(parts), panels_(panels), look_(look), touch_(touch) {
  makeCommands();
  connect(&panels_.places, &PlacesPanel::addAsked, this, &PlaceController::name);
  connect(&panels_.places, &PlacesPanel::goAsked, this, &PlaceController::goTo);
  connect(&panels_.places, &PlacesPanel::said, &messages_, &WindowMessages::announce);
  connectSuggestions(reference);
}

void PlaceController::makeCommands() {
  commands_.on(Command::name_place, this, [this] { name(); });
  commands_.on(Command::next_place, this, [this] { panels_.places.step(1); });
  commands_.on(Command::previous_place, this, [this] { panels_.places.step(-1); });
  commands_.on(Command::copy_view, this, [this] { copyView(); });
  commands_.on(Command::paste_view, this, [this] { pasteView(); });
  commands_.on(Command::beacon, this, [this] { toggleMarker(); });
  commands_.on(Command::suggest_windows, this, [this] {
    commands_[Command::show_panels].setChecked(true);
    panels_.all.reveal(&panels_.suggestions);
    panels_.suggestions.find();
  });
}

void PlaceController::connectSuggestions(ReferenceView& reference) {
  SuggestPanel& suggestions = panels_.suggestions;
  connect(&suggestions, &SuggestPanel::said, &messages_, &WindowMessages::announce);
  messages_.follow(suggestions);
  connect(&messages_, &WindowMessages::cancelAsked, &suggestions, &SuggestPanel::cancel);
  connect(&suggestions, &SuggestPanel::shownChanged, &reference, [&suggestions, &reference] {
    std::vector<SuggestedFrame> frames;
    if (suggestions.overlayWanted()) {
      for (const FeelableWindow& w : suggestions.windows()) {
        const Region& r = w.region;
        const bool is_current = static_cast<int>(frames.size()) == suggestions.current();
        frames.push_back({{r.x_mm, r.y_mm, r.side_mm, r.side_mm}, is_current});
      }
    }
    reference.setSuggestions(frames);
  });
}

void PlaceController::name() {
  if (!document_.isOpen()) return;
  commands_[Command::show_panels].setChecked(true);
  panels_.all.reveal(&panels_.places);
  NamedRegion place{.name = panels_.places.freeName().toStdString(),
                    .region = document_.project().region,
                    .gain = document_.project().gain};
  if (panels_.places.withView()) place.view = viewOf(document_.project());
  panels_.places.add(std::move(place));
}

// A marker's window is centred on the hand wherever that lies; it is put on the map when gone to.
void PlaceController::toggleMarker() {
  const auto window = document_.window();
  if (!window) return;
  const StepAbout here = touch_.about();
  const double reach_mm = kSameMarkerMm * handMapping(*window).objectMmPerHandMm();
  const std::vector<NamedRegion>& places = panels_.places.places();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Region& r = places[i].region;
    const double away_mm = std::hypot(r.centreX() - here.x_mm, r.centreY() - here.y_mm);
    if (!places[i].is_point || away_mm > reach_mm) continue;
    const QString name = QString::fromStdString(places[i].name);
    panels_.places.removeAt(i);
    announce(tr("%1 removed.").arg(name));
    return;
  }
  const QString name = freeMarker(places);
  if (name.isEmpty()) {
    announce(tr("There are %1 markers already. Remove one first.").arg(kMostMarkers));
    return;
  }
  NamedRegion place{.name = name.toStdString(),
                    .region = document_.project().region,
                    .gain = document_.project().gain,
                    .is_point = true};
  place.region.x_mm = here.x_mm - 0.5 * place.region.side_mm;
  place.region.y_mm = here.y_mm - 0.5 * place.region.side_mm;
  panels_.places.put(std::move(place));
  announce(tr("%1 set.").arg(name));
}

void PlaceController::goTo(const NamedRegion& place) {
  const QString name = QString::fromStdString(place.name);
  if (!document_.isOpen()) return;
  if (place.is_point) return goToPoint(place);
  if (place.region.level.value >= document_.details()) {
    messages_.show(
        tr("%1 has a finer resolution than this map. The window was not moved.").arg(name));
    return;
  }
  if (place.view) look_.showView(*place.view, tr("Go to %1").arg(name));
  document_.region().goTo(place.region, place.gain, tr("Go to %1").arg(name));
  announce(
      tr("%1. Resolution %2 of %3").arg(name).arg(document_.detail()).arg(document_.details()));
}

// The window stays as large and as fine as it is: whoever set the marker far out finds it close up.
void PlaceController::goToPoint(const NamedRegion& marker) {
  const QString name = QString::fromStdString(marker.name);
  Region to = document_.project().region;
  to.x_mm = marker.region.centreX() - 0.5 * to.side_mm;
  to.y_mm = marker.region.centreY() - 0.5 * to.side_mm;
  to = moved(document_.surface()->ladder, to, 0, 0).value_or(to);
  const bool is_other =
      document_.region().goTo(to, document_.project().gain, tr("Go to %1").arg(name));
  Q_EMIT wentToMarker(marker.region.centreX(), marker.region.centreY());
  if (!is_other) {
    announce(tr("%1 is in the window already.").arg(name));
    return;
  }
  announce(
      tr("%1. Resolution %2 of %3").arg(name).arg(document_.detail()).arg(document_.details()));
}

void PlaceController::copyView() {
  QGuiApplication::clipboard()->setText(
      QString::fromStdString(toText(viewOf(document_.project()))));
  announce(tr("The view is copied as text"));
}

void PlaceController::pasteView() {
  if (!document_.isOpen()) return;
  try {
    const ViewState view =
        viewFromText(QGuiApplication::clipboard()->text().trimmed().toStdString());
    const DetailLadder& ladder = document_.surface()->ladder;
    if (view.region.level.value >= document_.details() || !onMap(ladder, view.region)) {
      messages_.show(
          tr("The copied view does not lie on this map. The window was not moved. Open the "
             "scan that it was copied from."));
      return;
    }
    look_.showView(view, tr("Paste view"));
    document_.region().goTo(view.region, view.gain, tr("Paste view"));
    announce(tr("The copied view is shown. Resolution %1 of %2")
                 .arg(document_.detail())
                 .arg(document_.details()));
  } catch (const Error& error) {
    messages_.show(shownError(error));
  }
}

}  // namespace relievo
