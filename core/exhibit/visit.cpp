// SPDX-License-Identifier: BSD-3-Clause
#include "core/exhibit/visit.h"

#include <algorithm>
#include <array>

namespace relievo {

std::optional<VisitPress> visitPress(std::string_view command) noexcept {
  constexpr std::array<std::pair<std::string_view, VisitPress>, 15> kPresses{
      {{"finer", VisitPress::plus},
       {"coarser", VisitPress::minus},
       {"whereAmI", VisitPress::centre},
       {"whereAmILong", VisitPress::centre},
       {"moveMode", VisitPress::forward},
       {"beacon", VisitPress::forward_held},
       {"whole", VisitPress::minus_held},
       {"sayDetail", VisitPress::help},
       {"buttonHelp", VisitPress::help},
       {"take", VisitPress::take},
       {"next", VisitPress::next},
       {"back", VisitPress::back},
       {"repeatSpeech", VisitPress::repeat},
       {"louderSpeech", VisitPress::louder},
       {"softerSpeech", VisitPress::softer}}};
  if (command == "moveBack" || command == "moveDone") return std::nullopt;
  for (const auto& [name, press] : kPresses) {
    if (name == command) return press;
  }
  return VisitPress::other;
}

Visit::Visit(const VisitPlan& plan, const ExhibitTimes& times, double now_s)
    : plan_(plan),
      times_(times),
      broken_(plan.objects, false),
      since_s_(now_s),
      input_s_(now_s),
      chimed_s_(now_s),
      helped_s_(now_s - kHelpAgainS) {}

void Visit::enter(State state, double now_s) {
  state_ = state;
  since_s_ = input_s_ = now_s;
  said_again_ = free_is_due_ = false;
}

void Visit::begin(double now_s) {
  language_ = object_ = 0;
  introduced_ = false;
  if (isLost(now_s)) return loseDevice(now_s);
  if (std::all_of(broken_.begin(), broken_.end(), [](bool is) { return is; })) {
    enter(State::fault, now_s);
    return askForHelp(now_s);
  }
  order(Do::welcome, language_);
  if (plan_.languages > 1) return enter(State::language, now_s);
  enter(State::list, now_s);
  if (broken_[object_]) return offerNext();
  order(Do::offer_object, object_);
}

void Visit::end(double now_s) {
  order(Do::end_touch);
  order(Do::reset);
  language_ = object_ = 0;
  enter(State::idle, now_s);
  chimed_s_ = now_s;
}

void Visit::askForHelp(double now_s) {
  if (now_s - helped_s_ < kHelpAgainS) return;  // Not without end.
  helped_s_ = now_s;
  order(Do::say_needs_help);
}

void Visit::takeLanguage(double now_s) {
  enter(State::list, now_s);
  if (plan_.objects == 1) return openObject(now_s);
  if (broken_[object_]) return offerNext();
  order(Do::offer_object, object_);
}

void Visit::openObject(double now_s) {
  enter(State::opening, now_s);
  order(Do::open, object_);
}

/// The next one that can be opened; there is one.
void Visit::offerNext() {
  do {
    object_ = (object_ + 1) % plan_.objects;
  } while (broken_[object_]);
  order(Do::offer_object, object_);
}

bool Visit::pressOfVoice(VisitPress press) {
  switch (press) {
    case VisitPress::louder:
      order(Do::louder);
      return true;
    case VisitPress::softer:
      order(Do::softer);
      return true;
    case VisitPress::repeat:
      order(Do::repeat);
      return true;
    default:
      return false;
  }
}

/// Plus, Minus and Centre where they are not needed for anything else.
bool Visit::pressWithVolume(VisitPress press) {
  switch (press) {
    case VisitPress::plus:
      return pressOfVoice(VisitPress::louder);
    case VisitPress::minus:
      return pressOfVoice(VisitPress::softer);
    case VisitPress::centre:
    case VisitPress::help:
      return pressOfVoice(VisitPress::repeat);
    default:
      return false;
  }
}

void Visit::pressInLanguage(VisitPress press, double now_s) {
  switch (press) {
    case VisitPress::centre:
    case VisitPress::take:
      return takeLanguage(now_s);
    case VisitPress::forward:
    case VisitPress::next:
      language_ = (language_ + 1) % plan_.languages;
      return order(Do::offer_language, language_);
    case VisitPress::forward_held:
    case VisitPress::minus_held:
    case VisitPress::help:
    case VisitPress::back:
      return order(Do::welcome, language_);
    default:
      pressWithVolume(press);
  }
}

void Visit::pressInList(VisitPress press, double now_s) {
  switch (press) {
    case VisitPress::centre:
    case VisitPress::take:
      return openObject(now_s);
    case VisitPress::forward:
    case VisitPress::next:
      return offerNext();
    case VisitPress::forward_held:
    case VisitPress::help:
      return order(Do::offer_object, object_);
    case VisitPress::minus_held:
    case VisitPress::back:
      if (plan_.languages == 1) return order(Do::offer_object, object_);
      enter(State::language, now_s);
      return order(Do::welcome, language_);
    default:
      pressWithVolume(press);
  }
}

/// By keys; the device's buttons are the shapes' own.
bool Visit::pressInIntroduction(VisitPress press) {
  switch (press) {
    case VisitPress::forward:
    case VisitPress::next:
      order(Do::next_shape);
      return true;
    case VisitPress::forward_held:
      order(Do::end_introduction);
      return true;
    case VisitPress::centre:
    case VisitPress::take:
      return false;  // "Where am I" says the task again.
    default:
      pressWithVolume(press);
      return true;
  }
}

void Visit::pressInButtons(VisitPress press, double now_s) {
  if (press == VisitPress::forward_held) return sayObject(now_s);
  explain(now_s, press);
}

void Visit::pressInObject(VisitPress press, double now_s) {
  if (!pressWithVolume(press)) beginOffer(now_s);
}

void Visit::pressInOffer(VisitPress press, double now_s) {
  switch (press) {
    case VisitPress::plus:
    case VisitPress::take:
      enter(State::guiding, now_s);
      return order(Do::guide);
    case VisitPress::minus:
    case VisitPress::next:
    case VisitPress::back:
      return touchFreely(now_s);
    default:
      order(Do::repeat);
  }
}

void Visit::pressInHelp(VisitPress press, double now_s) {
  if (press == VisitPress::forward || press == VisitPress::back || press == VisitPress::next) {
    enter(State::touching, now_s);
  } else if (pressWithVolume(press)) {
    since_s_ = now_s;
  }
}

bool Visit::pressInTouch(VisitPress press, bool at_whole, double now_s) {
  if (press == VisitPress::help) {
    enter(State::help, now_s);
    order(Do::say_help);
    return true;
  }
  if (press != VisitPress::minus_held || !at_whole) return false;
  goBack(now_s);
  return true;
}

/// To the list of objects.
void Visit::goBack(double now_s) {
  order(Do::end_touch);
  enter(State::list, now_s);
  order(Do::offer_object, object_);
}

bool Visit::press(VisitPress press, bool at_whole, double now_s) {
  const State was = state_;
  stir(now_s);
  if (was == State::touching) return pressInTouch(press, at_whole, now_s);
  // The press has begun a visit, or said that somebody is there; no more than that.
  if (was == State::idle || was == State::still || was == State::let_go) return true;
  if (pressOfVoice(press)) return true;
  // What was chosen is left; where the hand is led a button lets it go, and that is the plugin's.
  if (press == VisitPress::minus_held && isOfObject(was)) {
    goBack(now_s);
    return true;
  }
  switch (was) {
    case State::language:
      pressInLanguage(press, now_s);
      break;
    case State::list:
      pressInList(press, now_s);
      break;
    case State::homing:
      pressWithVolume(press);
      break;
    case State::introduction:
      return pressInIntroduction(press);
    case State::buttons:
      pressInButtons(press, now_s);
      break;
    case State::object:
      pressInObject(press, now_s);
      break;
    case State::offer:
      pressInOffer(press, now_s);
      break;
    case State::guiding:
      return false;
    case State::help:
      pressInHelp(press, now_s);
      break;
    default:
      break;
  }
  return true;
}

void Visit::stir(double now_s) {
  input_s_ = now_s;
  if (state_ == State::idle) return begin(now_s);
  if (state_ == State::fault) return askForHelp(now_s);
  if (state_ == State::still) return enter(before_, now_s);
  if (state_ == State::let_go) {
    enter(State::touching, now_s);
    order(Do::touch_again);
  }
}

void Visit::opened(double now_s) {
  if (state_ != State::opening && state_ != State::fault) return;
  broken_[object_] = false;
  if (std::exchange(is_retry_, false)) return end(now_s);
  if (device_ == VisitDevice::ready) return beginObject(now_s);
  enter(State::homing, now_s);
  order(Do::say_homing);
}

/// The object is open, and the device is ready.
void Visit::beginObject(double now_s) {
  if (plan_.introduction && !std::exchange(introduced_, true)) {
    enter(State::introduction, now_s);
    return order(Do::introduce);
  }
  if (plan_.introduction || plan_.guide) return sayObject(now_s);
  enter(State::touching, now_s);
  order(Do::begin_touch, object_);
}

void Visit::introduced(double now_s) {
  if (state_ != State::introduction) return;
  enter(State::buttons, now_s);
  explained_ = 0;
  spoke_s_ = now_s;  // What the introduction says last is heard to its end.
}

/// The next one; after the last, what can be said of the object.
void Visit::explain(double now_s, VisitPress pressed) {
  if (explained_ == kExplained) return sayObject(now_s);
  orders_.push_back({Do::explain, explained_++, pressed});
  since_s_ = now_s;
}

void Visit::sayObject(double now_s) {
  enter(State::object, now_s);
  spoke_s_ = now_s + kBeginsS;
  order(Do::say_object, object_);
}

void Visit::beginOffer(double now_s) {
  if (!plan_.guide) return touchFreely(now_s);
  enter(State::offer, now_s);
  spoke_s_ = now_s + kBeginsS;
  order(Do::offer_guide);
}

void Visit::touchFreely(double now_s) {
  enter(State::touching, now_s);
  order(Do::begin_free, object_);
}

void Visit::guided(double now_s) {
  if (state_ != State::guiding) return;
  enter(State::touching, now_s);
  free_is_due_ = true;
  spoke_s_ = now_s;  // What the guide says last is heard to its end.
}

void Visit::stopped(double now_s) {
  if (!isOfObject(state_)) return;
  if (state_ == State::introduction) order(Do::end_introduction);
  enter(State::touching, now_s);
  order(Do::say_forces_off);
}

void Visit::letGo(double now_s) {
  if (state_ != State::touching) return;
  order(Do::end_touch);
  enter(State::let_go, now_s);
  order(Do::say_let_go);
}

void Visit::loseDevice(double now_s) {
  if (state_ != State::idle) {
    order(Do::end_touch);
    order(Do::reset);
  }
  const bool is_asked = state_ != State::idle || input_s_ == now_s;
  no_device_ = true;
  enter(State::fault, now_s);
  if (is_asked) askForHelp(now_s);
}

void Visit::device(VisitDevice device, double now_s) {
  const VisitDevice before = std::exchange(device_, device);
  const bool is_back = device == VisitDevice::ready || before == VisitDevice::gone;
  if (device == VisitDevice::gone) {
    if (before != VisitDevice::gone) gone_s_ = now_s;
    if (state_ != State::fault && isLost(now_s)) loseDevice(now_s);
  } else if (state_ == State::fault && no_device_ && is_back) {
    no_device_ = false;
    end(now_s);
  } else if (state_ == State::homing && device == VisitDevice::ready) {
    beginObject(now_s);
  }
}

void Visit::failed(double now_s) {
  if (state_ != State::opening && state_ != State::fault) return;
  broken_[object_] = true;
  if (std::exchange(is_retry_, false)) return enter(State::fault, now_s);
  if (std::all_of(broken_.begin(), broken_.end(), [](bool is) { return is; })) {
    enter(State::fault, now_s);
    return askForHelp(now_s);
  }
  enter(State::list, now_s);
  order(Do::say_failed, object_);
  offerNext();
}

bool Visit::isOfObject(State state) {
  switch (state) {
    case State::introduction:
    case State::buttons:
    case State::object:
    case State::offer:
    case State::guiding:
      return true;
    default:
      return false;
  }
}

bool Visit::chooses() const noexcept {
  return state_ != State::touching && state_ != State::introduction && state_ != State::guiding;
}

/// What comes by itself between the opening of an object and touching it.
void Visit::takeOfObject(double now_s) {
  const double lasts_s = now_s - since_s_;
  switch (state_) {
    case State::homing:
      if (lasts_s >= kHomingEndS) {
        loseDevice(now_s);
      } else if (lasts_s >= kHomingAgainS && !std::exchange(said_again_, true)) {
        order(Do::say_homing);
      }
      break;
    case State::buttons:
      if (explained_ == 0 ? isQuiet(now_s) : lasts_s >= kButtonS) explain(now_s);
      break;
    case State::object:
      if (isQuiet(now_s) || lasts_s >= kMostObjectS) beginOffer(now_s);
      break;
    case State::offer:
      // Ten seconds to answer, from when it is said.
      if (now_s - spoke_s_ >= kOfferS || lasts_s >= kMostObjectS) touchFreely(now_s);
      break;
    case State::help:
      if (lasts_s >= kHelpS) enter(State::touching, now_s);
      break;
    default:
      break;
  }
}

std::vector<Visit::Order> Visit::take(double now_s) {
  const double quiet_s = now_s - input_s_;
  switch (state_) {
    case State::idle:
      if (times_.chime_s > 0 && now_s - chimed_s_ >= times_.chime_s) {
        chimed_s_ = now_s;
        order(Do::chime);
      }
      break;
    case State::language:
      if (quiet_s >= kLanguageEndS) {
        end(now_s);
      } else if (quiet_s >= kLanguageAgainS && !std::exchange(said_again_, true)) {
        order(Do::offer_language, language_);
      }
      break;
    case State::list:
    case State::touching:
    case State::let_go:
      if (free_is_due_ && isQuiet(now_s)) {
        free_is_due_ = false;
        order(Do::begin_free, object_);
      }
      if (quiet_s >= times_.still_there_s) {
        before_ = state_;
        enter(State::still, now_s);
        order(Do::ask_still_there);
      }
      break;
    case State::still:
      if (now_s - since_s_ >= times_.goodbye_s) {
        order(Do::say_goodbye);
        end(now_s);
      }
      break;
    case State::fault:
      if (!is_retry_ && now_s - since_s_ >= kRetryS) retry(now_s);
      break;
    default:
      takeOfObject(now_s);
      break;
  }
  return std::exchange(orders_, {});
}

void Visit::retry(double now_s) {
  if (no_device_) {
    since_s_ = now_s;
    return order(Do::retry_device);
  }
  is_retry_ = true;
  object_ = (object_ + 1) % plan_.objects;
  order(Do::open, object_);
}

}  // namespace relievo
