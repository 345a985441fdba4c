// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/controllers.h"

#include "ui/frame/side_panels.h"
#include "ui/panels/places_panel.h"
#include "ui/panels/suggest_panel.h"
#include "ui/panels/surface_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/plots/profile_strip.h"
#include "ui/plots/time_plot.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/window/work_area.h"
#include "ui/work/file_names.h"

namespace relievo {

Controllers::Controllers(const ControllerParts& parts, WorkArea& area)
    : saving(parts),
      foreign(parts),
      packages(parts, foreign),
      opening(parts, saving, foreign, packages),
      look(parts, area.detail(), area.reference(), *area.panels().view, *area.panels().stereo),
      measure(parts, *area.panels().measure, area.profile(), area.detail(), area.reference()),
      touch(parts, area.detail(), area.plot(), area.replay(), *area.panels().measure),
      places(parts, {*area.panels().all, *area.panels().places, *area.panels().suggestions},
             area.reference(), look, touch),
      replays(parts, area.replay(), area.detail(), touch, opening),
      videos(parts, area.detail(), area.plot(), area.replay()),
      recordings_end(videos.control(), replays.noting(), nullptr),
      pictures(parts, area.detail(), area.reference(), foreign),
      exports(parts, {area.detail(), area.reference(), *area.panels().measure, pictures}),
      tiles(parts),
      questions(parts),
      pointer(parts, area.detail()),
      surface(parts, area.detail(), area.scan(), touch),
      study(parts, look),
      web(parts, opening),
      turns(parts, area.detail(), touch),
      exhibits(parts) {
  saving.watch({pictures, packages, exports, tiles, videos});
  QObject::connect(&tiles, &TilesController::openAsked, &opening,
                   [this](const QString& file) { opening.open(file); });
  QObject::connect(&opening, &OpenController::recordingChosen, &replays, &ReplayController::open);
  QObject::connect(&opening, &OpenController::begun, &replays.control(),
                   &ReplayControl::forgetWaiting);
  QObject::connect(&touch, &TouchController::readoutShown, &pointer, &PointerController::follow);
  study.setStudiesFolder([this] {
    const QString recordings = replays.folder();
    return recordings.isEmpty() ? QString() : recordings + QLatin1String("/studies");
  });
  QObject::connect(&touch, &TouchController::readoutShown, &study, &StudyController::follow);
  QObject::connect(&replays, &ReplayController::recordingNoted, &study,
                   &StudyController::noteRecording);
  QObject::connect(&touch, &TouchController::readoutShown, &recordings_end,
                   [this](const TouchReadout& now) { recordings_end.noteRunning(now.recording); });
  QObject::connect(&parts.messages, &WindowMessages::errorShown, &recordings_end,
                   &RecordingsEnd::forget);
  QObject::connect(&opening, &OpenController::begun, &recordings_end, &RecordingsEnd::forget);
  QObject::connect(&replays, &ReplayController::recordingNoted, &recordings_end,
                   [this](const QString& file) { recordings_end.noteSaved(shownName(file)); });
  QObject::connect(area.panels().surface, &SurfacePanel::unitChosen, &questions,
                   &QuestionController::chooseUnit);
  ViewPanel* view = area.panels().view;
  QObject::connect(view, &ViewPanel::viewChosen, &surface,
                   [&document = parts.document](const QString& name) {
                     document.choices().setView({name.toStdString(), {}});
                   });
  QObject::connect(view, &ViewPanel::useThisViewAsked, &surface, &SurfaceController::useThisView);
  QObject::connect(view, &ViewPanel::straightenAsked, &area.detail(), &DetailView::straighten);
  QObject::connect(
      &parts.document, &Document::opened, &replays,
      [this, measuring = area.panels().measure, detail = &area.detail()](const QString&) {
        questions.begin(opening.restoring(), foreign.withheld().size());
        if (measuring->measuring()) measuring->cancel();
        pictures.begin(opening.finish());
        look.warnOfRivalry();
        detail->setFocus();
        replays.control().showWaiting();
      });
}

}  // namespace relievo
