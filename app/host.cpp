// SPDX-License-Identifier: BSD-3-Clause
#include "app/host.h"

#include <memory>
#include <new>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QScopedValueRollback>
#include <QStringList>
#include <vector>

#include "core/base/failure.h"
#include "core/describe/named_place.h"
#include "core/exhibit/visit.h"
#include "core/message/message.h"
#include "core/provenance/provenance.h"
#include "core/provenance/sha256.h"
#include "core/region/carry.h"
#include "core/region/edges.h"
#include "core/region/window.h"
#include "core/session/finer_heights.h"
#include "core/session/firmness.h"
#include "ui/exhibit/exhibit_control.h"
#include "ui/language/error_text.h"
#include "ui/message/message_text.h"
#include "ui/views/cloud_view.h"
#include "ui/views/detail_view.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

// What a device pushes and turns in a row is one step. Beside the document's own ids and those of
// the look.
constexpr int kMergePushes = 201;

}  // namespace

WindowHost::WindowHost(MainWindow& window) : window_(window) {
  connect(&window_, &MainWindow::windowShown, this, &ShownWindow::windowShown);
  connect(&window_, &MainWindow::closing, this, &ShownWindow::closing);
  connect(&window_.controllers().places, &PlaceController::wentToMarker, this,
          &ShownWindow::wentToMarker);
  connect(&window_, &MainWindow::handMoved, this, [this](const ViewMm& position, bool inside) {
    Q_EMIT handMoved({position, inside});
  });
}

void WindowHost::addPanel(const QString& title, QWidget* panel) {
  window_.addPanel(title, panel);
  new_panels_.emplace_back(panel);
}

void WindowHost::addAction(const QString& menu, QAction* action) {
  window_.addToMenu(menu, action);
  new_actions_.emplace_back(action);
}

void WindowHost::keepAdditions() {
  new_panels_.clear();
  new_actions_.clear();
}

void WindowHost::takeAdditionsBack() {
  for (const QPointer<QWidget>& panel : new_panels_) {
    if (panel) window_.removePanel(panel);
  }
  for (const QPointer<QAction>& action : new_actions_) {
    if (!action) continue;
    const QList<QWidget*> places = action->associatedWidgets();
    delete action;
    for (QWidget* place : places) {
      auto* menu = qobject_cast<QMenu*>(place);
      if (menu != nullptr && menu->isEmpty()) menu->menuAction()->setVisible(false);
    }
  }
  keepAdditions();
}

void WindowHost::showProbe(const Probe& probe) {
  window_.controllers().touch.showProbe(probe);
  if (voice_ != nullptr) voice_->feel(probe);
  if (exhibit_ != nullptr) exhibit_->feel(probe);
}

void WindowHost::plot(std::span<const ForcePoint> samples) {
  window_.controllers().touch.plot(samples);
}

namespace {
VisitDevice visitDevice(TouchDevice state) {
  switch (state) {
    case TouchDevice::ready:
      break;
    case TouchDevice::preparing:
      return VisitDevice::preparing;
    case TouchDevice::gone:
      return VisitDevice::gone;
  }
  return VisitDevice::ready;
}
}  // namespace

void WindowHost::showStatus(const TouchStatus& status) {
  TouchReadout readout;
  readout.device = status.device;
  readout.rate_hz = status.rate_hz;
  readout.worst_period_ms = status.worst_period_ms;
  readout.late_ticks = status.late_ticks;
  readout.realtime = status.realtime;
  readout.realtime_note = status.realtime_note;
  readout.forces_on = status.forces_on;
  readout.recording = status.recording;
  readout.recorded_samples = status.recorded_samples;
  window_.controllers().touch.show(readout);
  if (exhibit_ == nullptr) return;
  exhibit_->noteDevice(visitDevice(status.state));
  if (status.grip) exhibit_->noteGrip(*status.grip);
}

void WindowHost::announce(const QString& text, SaidBecause why) {
  const QScopedValueRollback<SaidBecause> because(window_says_because_, why);
  window_.messages().announce(text);
}

void WindowHost::say(const std::vector<Message>& sentences, SaidBecause why) {
  QStringList spoken;
  for (const Message& sentence : sentences) spoken << spokenMessage(sentence);
  const bool is_heard = voice_ != nullptr && voice_->speak(sentences, why);
  window_.messages().announceAs(messageText(sentences),
                                is_heard ? QString() : spoken.join(QLatin1Char(' ')));
}

void WindowHost::hush() {
  if (voice_ != nullptr) voice_->hush();
}

void WindowHost::setVoice(Voice* voice) {
  voice_ = voice;
  // What the window itself has to say is heard of one voice, too.
  window_.messages().setSpeaker(
      voice == nullptr ? std::function<bool(const QString&)>()
                       : [this, voice](const QString& text) {
                           const bool is_quiet = exhibit_ != nullptr && exhibit_->isQuiet();
                           return is_quiet || voice->speak(text, window_says_because_);
                         });
}

void WindowHost::showError(const QString& sentence, const QString& code) {
  // A plugin fails by itself, not because somebody asked for it just now.
  const QScopedValueRollback<SaidBecause> because(window_says_because_, SaidBecause::noticed);
  window_.messages().showError(sentence, code);
  if (exhibit_ != nullptr) {
    exhibit_->noteError(code);
  } else if (code == QLatin1String("E402")) {
    low_tones_.play();
  }
}

bool WindowHost::run(const QString& command) {
  const QString button = QString::fromLatin1(kButtonFirst);
  if (command.startsWith(button)) {
    if (exhibit_ == nullptr) return false;
    return command == button ? exhibit_->chooses() : exhibit_->press(command.mid(button.size()));
  }
  if (exhibit_ != nullptr && !exhibit_->allows(command)) return false;
  return window_.runCommand(command);
}

std::shared_ptr<const RegionWindow> WindowHost::shownWindow() const {
  return window_.document().window();
}

namespace {
/// What workers leave for the GUI thread.
struct FinerReply {
  std::vector<float> finer_mm;
  QString problem;
};
struct FirmnessReply {
  std::shared_ptr<const FirmnessMap> firmness;
  QString problem;
};

FirmnessReply firmnessIn(const QString& file, const Task& task) {
  try {
    const std::filesystem::path path = QFile::encodeName(file).toStdString();
    auto firmness = std::make_shared<FirmnessMap>(readFirmness(path, task));
    firmness->sha256 = sha256OfFile(path, task);
    return {std::move(firmness), {}};
  } catch (const Error& error) {
    return {nullptr, spokenError(error)};
  } catch (const std::bad_alloc&) {
    return {nullptr, WindowHost::tr("%1 is too large for the memory and was not used. Make it "
                                    "coarser; it is laid over the whole map.")
                         .arg(shownName(file))};
  }
}
}  // namespace

std::vector<float> WindowHost::finerHeights(const RegionWindow& window) {
  const auto surface = window_.document().surface();
  finer_worker_.cancel();
  if (!surface) return {};
  if (!surface->tiles) return relievo::finerHeights(*surface, window.region, window.gain);
  auto reply = std::make_shared<FinerReply>();
  finer_worker_.start(
      [surface, region = window.region, gain = window.gain, reply](const Task&) {
        try {
          reply->finer_mm = relievo::finerHeights(*surface, region, gain);
        } catch (const Error& error) {
          reply->problem = spokenError(error);
        }
      },
      [this, id = window.id, reply] {
        Q_EMIT finerHeightsRead(id, reply->finer_mm, reply->problem);
      });
  return {};
}

void WindowHost::readFirmness(const QString& file) {
  auto reply = std::make_shared<FirmnessReply>();
  firmness_worker_.start(
      [file, reply](const Task& task) { *reply = firmnessIn(file, task); },
      [this, file, reply] { Q_EMIT firmnessRead(file, reply->firmness, reply->problem); });
}

std::vector<float> WindowHost::firmnessUnder(const FirmnessMap& firmness,
                                             const RegionWindow& window) const {
  const auto surface = window_.document().surface();
  if (!surface) throw failure<MessageId::no_map_for_raster>();
  try {
    return relievo::firmnessUnder(firmness, surface->ladder, window.region);
  } catch (const ArgumentError& error) {
    throw ArgumentError(messageOf(error));
  }
}

ObjectPlace WindowHost::placeAt(double x_mm, double y_mm) const {
  const Document& document = window_.document();
  if (!document.isOpen()) return {};
  const DetailLadder& ladder = document.surface()->ladder;
  const auto window = document.window();
  const auto level = static_cast<std::size_t>(document.project().region.level.value);
  const RectMm object{ladder.left_mm, ladder.bottom_mm, ladder.width_mm, ladder.height_mm};
  // As near as two markers are the same one.
  constexpr double kReachHandMm = 5;
  const double reach_mm =
      window ? kReachHandMm * handMapping(*window).objectMmPerHandMm() : ladder.spacings_mm.front();
  return {.left_mm = object.x_mm,
          .bottom_mm = object.y_mm,
          .width_mm = object.width_mm,
          .height_mm = object.height_mm,
          .spacing_mm = ladder.spacings_mm.at(level),
          .name = QString::fromStdString(
              nameAt(document.project().places, object, {.x = x_mm, .y = y_mm}, reach_mm))};
}

bool WindowHost::showRegion(const Region& region) {
  return window_.document().region().zoomTo(region);
}

std::uint8_t WindowHost::edges() const {
  const Document& document = window_.document();
  return document.isOpen() ? edgesOf(document.surface()->ladder, document.project().region)
                           : std::uint8_t{0};
}

void WindowHost::turnView(double azimuth_deg, double elevation_deg, double tilt_deg) {
  if (CloudView* scan = window_.scanInHand()) {
    scan->turnBy(-azimuth_deg, -elevation_deg, tilt_deg);
    return;
  }
  if (window_.document().isOpen()) {
    window_.detailView().turnBy(azimuth_deg, elevation_deg, kMergePushes);
  }
}

void WindowHost::pushView(const ViewPush& push) {
  if (CloudView* scan = window_.scanInHand()) {
    scan->push(push.right, push.up, push.nearer);
    return;
  }
  Document& document = window_.document();
  if (!document.isOpen() || document.region().inGesture()) return;
  const Region& from = document.project().region;
  const Region to = carried(document.surface()->ladder, from,
                            {.right = push.right, .up = push.up, .nearer = push.nearer});
  if (to == from) return;
  document.edit(
      tr("Move and zoom"), [&to](Project& project) { project.region = to; }, kMergePushes);
}

QString WindowHost::recordingHeader(const QString& file) const {
  return relievo::recordingHeader(window_.document(), file);
}

QString WindowHost::scanName() const {
  const StudyController& study = window_.controllers().study;
  if (study.running()) return study.recordingName();
  return stemOf(window_.document().file(), {});
}

QString WindowHost::recordingEnding() const {
  return window_.controllers().replays.ending();
}

QString WindowHost::recordingFolder() const {
  const StudyController& study = window_.controllers().study;
  if (study.running()) return study.folder();
  return window_.controllers().replays.folder();
}

void WindowHost::recordingSaved(const QString& file) {
  window_.controllers().replays.noteRecording(file);
}

QString WindowHost::mapState(const QString& folder) const {
  const Document& document = window_.document();
  if (!document.isOpen()) return {};
  Provenance made = document.provenanceInFolder(folder);
  // A state without a view shows nothing, and a recording has its own.
  made.view = ViewState{.region = wholeRegion(document.surface()->ladder)};
  return QString::fromStdString(toJson(made, -1));
}

}  // namespace relievo
