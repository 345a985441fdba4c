// SPDX-License-Identifier: BSD-3-Clause
#include "ui/exhibit/exhibit_control.h"

#include <algorithm>
#include <cmath>
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QVBoxLayout>
#include <utility>

#include "core/base/failure.h"
#include "core/describe/hand_place.h"
#include "core/describe/named_place.h"
#include "core/describe/sayable.h"
#include "core/project/project_files.h"
#include "core/region/hand.h"
#include "ui/exhibit/visit_words.h"
#include "ui/language/language.h"
#include "ui/message/message_text.h"
#include "ui/views/detail_view.h"
#include "ui/window/main_window.h"

namespace relievo {
namespace {

constexpr int kTickMs = 50;
constexpr double kRestS = 0.8;  // A pause in the middle of exploring is shorter.
constexpr double kLetGoS = 2;   // In contact, without any motion.
constexpr double kReadWordS = 0.25;
constexpr double kLongestFrameS = 0.25;
constexpr double kSaveS = 60;
constexpr double kPinPatienceS = 20;
constexpr double kNothingComesS = 5;  // After this an object that nobody reads is not coming.

VisitPlan planOf(const Exhibit& exhibit) {
  return {.languages = exhibit.languages.size(),
          .objects = exhibit.objects.size(),
          .introduction = exhibit.touch.introduction,
          .guide = exhibit.touch.guide && exhibit.touch.device != "mouse"};
}

}  // namespace

ExhibitControl::ExhibitControl(MainWindow& window, Exhibit exhibit, ExhibitWays ways, int starts)
    : window_(window),
      exhibit_(std::move(exhibit)),
      ways_(std::move(ways)),
      lock_(window),
      caption_(new ExhibitCaption(window.centralWidget())),
      sounds_(exhibit_.speech.volume_percent),
      visit_(planOf(exhibit_), exhibit_.times, ways_.now_s()),
      staff_(exhibit_.pin),
      counts_(recordsFolder(exhibit_)),
      health_(recordsFolder(exhibit_) / "health.log") {
  if (auto* column = qobject_cast<QVBoxLayout*>(window_.centralWidget()->layout())) {
    column->addWidget(caption_);
  }
  connectDocument();
  connect(&lock_, &ExhibitLock::stirred, this, [this] {
    if (!caption_->asks()) visit_.stir(ways_.now_s());
  });
  connect(&lock_, &ExhibitLock::closeAsked, this, &ExhibitControl::askPin);
  lock_.setKeys([this](const QKeyEvent& pressed) { return key(pressed); });
  connect(&window_.controllers().touch, &TouchController::readoutShown, this,
          &ExhibitControl::noteReadout);
  window_.controllers().surface.setTeller([this](SurfaceController::Step step) { tell(step); });
  connect(&window_.messages(), &WindowMessages::errorShown, this,
          [this] { log(window_.message().toStdString()); });
  log("started" + (starts > 0 ? ", again: " + std::to_string(starts) : std::string()));
  if (counts_.problem()) log(englishText(*counts_.problem()));
  ways_.reset_voice();
  useLanguage(0);
  if (starts > 0) speak({said<MessageId::exhibit_one_moment>()});
  connect(&timer_, &QTimer::timeout, this, &ExhibitControl::tick);
  timer_.start(kTickMs);
}

ExhibitControl::~ExhibitControl() {
  window_.controllers().surface.setTeller({});
  saveCounts();
}

void ExhibitControl::connectDocument() {
  Document& document = window_.document();
  connect(&document, &Document::opened, this, [this] { objectOpened(); });
  connect(&document, &Document::failed, this,
          [this](const QString& message) { objectFailed(message); });
}

bool ExhibitControl::press(const QString& command) {
  if (caption_->asks()) return true;
  const auto press = visitPress(command.toStdString());
  if (!press) return false;
  return visit_.press(*press, atWhole(), ways_.now_s());
}

bool ExhibitControl::allows(const QString& command) const {
  return !caption_->asks() && ExhibitLock::isAllowed(command);
}

bool ExhibitControl::atWhole() const {
  return !window_.document().isOpen() || window_.document().detail() == 1;
}

void ExhibitControl::feel(const Probe& probe) {
  const auto window = window_.document().window();
  if (!window || probe.window_id != window->id) return;
  const double now_s = ways_.now_s();
  const double since_s = std::clamp(now_s - std::exchange(felt_s_, now_s), 0.0, kLongestFrameS);
  if (visit_.state() == Visit::State::touching && probe.touching) {
    counts_.touch(ways_.day(), exhibit_.objects[visit_.object()].id, since_s);
  }
  probe_ = probe;
  const double scale = 1 / handMapping(*window).objectMmPerHandMm();
  const DeviceMm at{scale * probe.hip.x, scale * probe.hip.y, scale * probe.hip.z};
  if (hand_.moved(at, now_s)) visit_.stir(now_s);
}

void ExhibitControl::noteGrip(const DeviceMm& at) {
  const double now_s = ways_.now_s();
  if (hand_.gripMoved(at, visit_.state() == Visit::State::idle, now_s)) visit_.stir(now_s);
}

bool ExhibitControl::isChecked(const char* command) const {
  const QAction* action = window_.commands().named(QString::fromLatin1(command));
  return action != nullptr && action->isChecked();
}

void ExhibitControl::noteError(const QString& code) {
  if (code != QLatin1String("E402")) return;
  sounds_.low_tones.play();
  toggle("feltPatterns", true);
}

/// What others do by themselves.
void ExhibitControl::watch(double now_s) {
  const bool has_forces = window_.commands().named(QStringLiteral("forces")) != nullptr;
  const bool forces = isChecked("forces");
  if (std::exchange(had_forces_, forces) && !forces) visit_.stopped(now_s);
  const bool speaks = (ways_.speaks && ways_.speaks()) || now_s < read_until_s_;
  if (speaks || facts_.areAwaited()) visit_.speaking(now_s);
  switch (visit_.state()) {
    case Visit::State::introduction:
      if (!isChecked("touchIntroduction")) visit_.introduced(now_s);
      break;
    case Visit::State::guiding:
      if (!isChecked("guide")) visit_.guided(now_s);
      break;
    case Visit::State::touching:
      // A mouse that lies still is held down, perhaps; a grip that does is held by nobody.
      if (exhibit_.touch.device != "mouse" && probe_.touching && (forces || !has_forces) &&
          hand_.stillS(now_s) > kLetGoS) {
        visit_.letGo(now_s);
      } else if (!speaks && hand_.restsS(now_s) > kRestS) {
        sayPlace();
      }
      break;
    default:
      break;
  }
}

/// Where the hand rests, once for each visitor and place: its name, or that nobody measured it.
void ExhibitControl::sayPlace() {
  const Document& document = window_.document();
  const auto window = document.window();
  if (!probe_.touching || !window || probe_.window_id != window->id) return;
  const DetailLadder& ladder = document.surface()->ladder;
  const RectMm object{ladder.left_mm, ladder.bottom_mm, ladder.width_mm, ladder.height_mm};
  const double reach_mm = HandWatch::kStirMm * handMapping(*window).objectMmPerHandMm();
  const std::string name = nameAt(document.project().places, object, probe_.proxy, reach_mm);
  if (!name.empty()) {
    if (told_places_.insert(name).second) speak({said<MessageId::place_named>(name)});
    return;
  }
  if (probe_.origin != CellStatus::interpolated && probe_.origin != CellStatus::base_plane) return;
  constexpr double kParts = 20;  // Of the object's longer side.
  const double part_mm = std::max(object.width_mm, object.height_mm) / kParts;
  const auto column = std::lround((probe_.proxy.x - object.x_mm) / part_mm);
  const auto row = std::lround((probe_.proxy.y - object.y_mm) / part_mm);
  const std::string place = "\n" + std::to_string(column) + "\n" + std::to_string(row);
  if (told_places_.insert(place).second) speak({said<MessageId::exhibit_not_measured>()});
}

void ExhibitControl::tick() {
  const double now_s = ways_.now_s();
  if (caption_->asks()) {
    if (now_s - pin_key_s_ > kPinPatienceS) {
      staff_.clear();
      caption_->setAsked({});
    } else if (staff_.waitsS(now_s) > 0) {
      showPin();
    }
  }
  // First, because what was ordered is seen as begun, or as ended, only once it has been begun.
  carryOutOrders(now_s);
  watch(now_s);
  carryOutOrders(now_s);
  watchOpening();  // After the order to open, from which it counts.
  if (now_s - saved_s_ > kSaveS) saveCounts();
}

void ExhibitControl::carryOutOrders(double now_s) {
  for (const Visit::Order& order : visit_.take(now_s)) carryOut(order);
}

void ExhibitControl::carryOut(const Visit::Order& order) {
  using Do = Visit::Do;
  switch (order.what) {
    case Do::welcome:
    case Do::offer_language:
      useLanguage(order.index);
      break;
    case Do::say_needs_help:
      log("help was asked for");
      break;
    case Do::chime:
      return sounds_.chime.play();
    case Do::open:
      return openObject(order.index);
    case Do::retry_device:
      return run("takeForcesBack");
    case Do::louder:
      return run("louderSpeech");
    case Do::softer:
      return run("softerSpeech");
    case Do::repeat:
      return speak(std::vector<Message>(said_));
    case Do::reset:
      return reset();
    default:
      carryOutTouch(order);
      break;
  }
  const std::vector<Message> words = visitWords(order, exhibit_, exhibit_.languages[language_]);
  if (!words.empty()) speak(words);
}

/// Between the opening of an object and its end; what is said then comes after it.
void ExhibitControl::carryOutTouch(const Visit::Order& order) {
  using Do = Visit::Do;
  switch (order.what) {
    case Do::introduce:
      return toggle("touchIntroduction", true);
    case Do::end_introduction:
      return toggle("touchIntroduction", false);
    case Do::next_shape:
      return run("nextShape");
    case Do::say_object:
      setForces(true);
      return facts_.give([this](const std::vector<Message>& facts) { sayObject(facts); });
    case Do::guide:
      setForces(true);
      return toggle("guide", true);
    case Do::begin_touch:
    case Do::begin_free:
      felt_s_ = ways_.now_s();
      setForces(true);
      return window_.detailView().setFocus();
    case Do::end_touch:
      return endTouch();
    case Do::touch_again:
      return setForces(true);
    default:
      return;
  }
}

void ExhibitControl::sayObject(std::vector<Message> words) {
  if (const auto window = window_.document().window()) {
    HandPlace place;
    place.object_mm_per_hand_mm = handMapping(*window).objectMmPerHandMm();
    words.push_back(said<MessageId::exhibit_feel_all>());
    words.push_back(detailWords(place).at(1));  // The scale.
  }
  speak(words);
}

void ExhibitControl::toggle(const char* command, bool on) {
  if (isChecked(command) != on) run(command);
}

/// A device that was lost between two visitors is opened anew, and its forces follow. Only where
/// that fails at once is what takes its place to push.
bool ExhibitControl::takesForcesBack() {
  const QString take_back = QStringLiteral("takeForcesBack");
  return window_.runCommand(take_back) && !window_.commands().named(take_back)->isEnabled();
}

void ExhibitControl::setForces(bool on) {
  if (on && takesForcesBack()) return;
  QAction* forces = window_.commands().named(QStringLiteral("forces"));
  if (forces != nullptr && forces->isChecked() != on) forces->trigger();
  had_forces_ = isChecked("forces");
}

void ExhibitControl::speak(const std::vector<Message>& sentences) {
  const QString shown = messageText(sentences);
  caption_->setSaid(shown);
  read_until_s_ = ways_.now_s() + kReadWordS * (shown.count(QLatin1Char(' ')) + 1);
  said_ = sentences;
  ways_.say(sentences);
}

/// In a visitor's words: how much of the relief is under the hand now. Before and after a touch
/// nobody asked.
void ExhibitControl::tell(SurfaceController::Step step) {
  if (isQuiet()) return;
  if (atWhole()) return speak({said<MessageId::exhibit_whole>()});
  const Message wide = sayableLength(window_.document().project().region.side_mm);
  speak({step == SurfaceController::Step::closer ? said<MessageId::exhibit_closer>(wide)
                                                 : said<MessageId::exhibit_wider>(wide)});
}

void ExhibitControl::useLanguage(std::size_t index) {
  language_ = index;
  applyLanguage(*qApp, QString::fromStdString(exhibit_.languages[index]));
}

void ExhibitControl::openObject(std::size_t index) {
  nothing_.look(false, ways_.now_s());
  if (open_object_ == static_cast<int>(index) && window_.document().isOpen() &&
      !window_.document().loader().busy()) {
    run("whole");
    return objectOpened();
  }
  open_object_ = static_cast<int>(index);
  speak({said<MessageId::exhibit_one_moment>()});
  const ExhibitObject& object = exhibit_.objects[index];
  const QString file = QFile::decodeName(object.file.c_str());
  if (object.file.extension() == ".json") {
    try {
      window_.controllers().opening.restore(readProject(object.file), file);
    } catch (const Error& error) {
      objectFailed(QString::fromStdString(error.what()));
    }
    return;
  }
  OpenRequest request;
  request.file = file;
  request.unit = object.unit;
  if (object.view) request.view = ViewChoice{*object.view, {}};
  window_.open(request);
}

void ExhibitControl::objectOpened() {
  if (visit_.state() == Visit::State::opening) {
    counts_.start(ways_.day(), exhibit_.objects[visit_.object()].id);
    const bool says = exhibit_.touch.introduction || exhibit_.touch.guide;
    facts_.find(says ? window_.document().surface() : nullptr);
  }
  visit_.opened(ways_.now_s());
}

void ExhibitControl::objectFailed(const QString& why) {
  if (visit_.state() != Visit::State::opening && visit_.state() != Visit::State::fault) {
    return log(why.toStdString());
  }
  log(exhibit_.objects[visit_.object()].id + ": " + why.toStdString());
  open_object_ = -1;
  visit_.failed(ways_.now_s());
}

/// What was refused by a question that nobody here can answer.
void ExhibitControl::watchOpening() {
  const bool nothing_comes =
      visit_.state() == Visit::State::opening && !window_.document().loader().busy();
  if (nothing_.look(nothing_comes, ways_.now_s()) > kNothingComesS) {
    objectFailed(window_.message());
  }
}

void ExhibitControl::endTouch() {
  had_forces_ = false;  // It is not the visitor who switches them off.
  window_.controllers().touch.stopForces();
  run("moveBack");
}

/// Beacons and places of the visitor go; the next one begins with the whole relief.
void ExhibitControl::reset() {
  saveCounts();
  told_places_.clear();
  if (window_.hasUnsavedWork()) {
    window_.controllers().opening.forgetState();
    window_.controllers().touch.forgetProbe();
    window_.document().close();
    open_object_ = -1;
  } else {
    run("whole");
  }
  ways_.reset_voice();
  useLanguage(0);
  caption_->setSaid(messageText(said<MessageId::exhibit_welcome>()));
}

void ExhibitControl::run(const char* command) {
  window_.runCommand(QString::fromLatin1(command));
}

bool ExhibitControl::key(const QKeyEvent& key) {
  if (caption_->asks()) {
    pinKey(key);
    return false;
  }
  const bool in_touch = visit_.state() == Visit::State::touching;
  const auto pressed = [this](const char* command) {
    const QString name = QString::fromLatin1(command);
    if (!press(name)) window_.runCommand(name);
    return false;
  };
  switch (key.key()) {
    case Qt::Key_Plus:
      return pressed("finer");
    case Qt::Key_Minus:
      return pressed("coarser");
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      return pressed("whereAmI");
    case Qt::Key_Tab:
      return pressed("moveMode");
    case Qt::Key_Right:
    case Qt::Key_Down:
      if (!in_touch) return pressed("moveMode");
      visit_.stir(ways_.now_s());
      return true;
    case Qt::Key_Home:
      return pressed("whole");
    case Qt::Key_F1:
      return pressed("buttonHelp");
    case Qt::Key_Backspace:
      visit_.stir(ways_.now_s());
      run("repeatSpeech");
      return false;
    case Qt::Key_Escape:
      window_.controllers().touch.stopForces();
      return false;
    default:
      visit_.stir(ways_.now_s());
      return in_touch;
  }
}

void ExhibitControl::askPin() {
  window_.controllers().touch.stopForces();
  pin_key_s_ = ways_.now_s();
  staff_.clear();
  showPin();
}

void ExhibitControl::pinKey(const QKeyEvent& key) {
  const double now_s = pin_key_s_ = ways_.now_s();
  if (key.key() == Qt::Key_Escape) {
    staff_.clear();
    return caption_->setAsked({});
  }
  if (key.key() == Qt::Key_Backspace) {
    staff_.erase();
  } else if (key.key() >= Qt::Key_0 && key.key() <= Qt::Key_9) {
    staff_.digit(static_cast<char>('0' + (key.key() - Qt::Key_0)), now_s);
  } else if (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter) {
    const StaffLock::Answer answer = staff_.enter(now_s);
    if (answer == StaffLock::Answer::open) return leave();
    log("a wrong PIN was entered");
    if (answer == StaffLock::Answer::wrong) {
      return caption_->setAsked(
          messageText(said<MessageId::exhibit_pin_wrong>(staff_.triesLeft())));
    }
  }
  showPin();
}

// It is shown and never spoken (EN 301 549, 5.1.3.8).
void ExhibitControl::showPin() {
  const double waits_s = staff_.waitsS(ways_.now_s());
  caption_->setAsked(waits_s > 0
                         ? messageText(said<MessageId::exhibit_pin_waits>(std::lround(waits_s)))
                         : messageText(said<MessageId::exhibit_enter_pin>()),
                     static_cast<int>(staff_.entered()));
}

void ExhibitControl::leave() {
  log("ended by the staff");
  endAtOnce();
  QApplication::exit(0);
}

void ExhibitControl::endAtOnce() {
  saveCounts();
  timer_.stop();
  lock_.letClose();
  window_.endAtOnce();
}

bool ExhibitControl::isQuiet() const {
  return visit_.state() != Visit::State::touching && visit_.state() != Visit::State::help;
}

void ExhibitControl::log(const std::string& words) {
  health_.write(utcNow(), words);
}

void ExhibitControl::saveCounts() {
  saved_s_ = ways_.now_s();
  try {
    counts_.save();
  } catch (const WriteError& error) {
    log(error.what());
  }
}

void ExhibitControl::noteReadout(const TouchReadout& readout) {
  if (readout.device == device_) return;
  device_ = readout.device;
  log("device: " + device_.toStdString());
}

}  // namespace relievo
