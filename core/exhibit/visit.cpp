// SPDX-License-Identifier: BSD-3-Clause
#include "core/exhibit/visit.h"

#include <algorithm>
#include <array>

namespace relievo {

std::optional<VisitPress> visitPress(std::string_view command) noexcept {
  constexpr std::array<std::pair<std::string_view, VisitPress>, 8> kPresses{
      {{"finer", VisitPress::plus},
       {"coarser", VisitPress::minus},
       {"whereAmI", VisitPress::centre},
       {"whereAmILong", VisitPress::centre},
       {"moveMode", VisitPress::forward},
       {"beacon", VisitPress::forward_held},
       {"whole", VisitPress::minus_held},
       {"buttonHelp", VisitPress::help}}};
  if (command == "moveBack" || command == "moveDone") return std::nullopt;
  for (const auto& [name, press] : kPresses) {
    if (name == command) return press;
  }
  return VisitPress::other;
}

Visit::Visit(std::size_t languages, std::size_t objects, const ExhibitTimes& times, double now_s)
    : languages_(languages),
      objects_(objects),
      times_(times),
      broken_(objects, false),
      since_s_(now_s),
      input_s_(now_s),
      chimed_s_(now_s),
      helped_s_(now_s - kHelpAgainS) {}

void Visit::enter(State state, double now_s) {
  state_ = state;
  since_s_ = input_s_ = now_s;
  said_again_ = false;
}

void Visit::begin(double now_s) {
  language_ = object_ = 0;
  if (std::all_of(broken_.begin(), broken_.end(), [](bool is) { return is; })) {
    enter(State::fault, now_s);
    return askForHelp(now_s);
  }
  order(Do::welcome, language_);
  if (languages_ > 1) return enter(State::language, now_s);
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
  if (objects_ == 1) return openObject(now_s);
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
    object_ = (object_ + 1) % objects_;
  } while (broken_[object_]);
  order(Do::offer_object, object_);
}

bool Visit::pressInLanguage(VisitPress press, double now_s) {
  switch (press) {
    case VisitPress::plus:
      order(Do::louder);
      break;
    case VisitPress::minus:
      order(Do::softer);
      break;
    case VisitPress::centre:
      takeLanguage(now_s);
      break;
    case VisitPress::forward:
      language_ = (language_ + 1) % languages_;
      order(Do::offer_language, language_);
      break;
    case VisitPress::forward_held:
    case VisitPress::minus_held:
    case VisitPress::help:
      order(Do::welcome, language_);
      break;
    case VisitPress::other:
      break;
  }
  return true;
}

bool Visit::pressInList(VisitPress press, double now_s) {
  switch (press) {
    case VisitPress::plus:
      order(Do::louder);
      break;
    case VisitPress::minus:
      order(Do::softer);
      break;
    case VisitPress::centre:
      openObject(now_s);
      break;
    case VisitPress::forward:
      offerNext();
      break;
    case VisitPress::forward_held:
    case VisitPress::help:
      order(Do::offer_object, object_);
      break;
    case VisitPress::minus_held:
      if (languages_ > 1) {
        enter(State::language, now_s);
        order(Do::welcome, language_);
      } else {
        order(Do::offer_object, object_);
      }
      break;
    case VisitPress::other:
      break;
  }
  return true;
}

bool Visit::press(VisitPress press, bool at_whole, double now_s) {
  const State was = state_;
  stir(now_s);
  switch (was) {
    case State::idle:   // The press has begun a visit ...
    case State::still:  // ... or said that somebody is there; no more than that.
    case State::opening:
    case State::fault:
      return true;
    case State::language:
      return pressInLanguage(press, now_s);
    case State::list:
      return pressInList(press, now_s);
    case State::touching:
      break;
  }
  if (press != VisitPress::minus_held || !at_whole) return false;
  order(Do::end_touch);
  enter(State::list, now_s);
  order(Do::offer_object, object_);
  return true;
}

void Visit::stir(double now_s) {
  input_s_ = now_s;
  if (state_ == State::idle) return begin(now_s);
  if (state_ == State::fault) return askForHelp(now_s);
  if (state_ == State::still) enter(before_, now_s);
}

void Visit::opened(double now_s) {
  if (state_ != State::opening && state_ != State::fault) return;
  broken_[object_] = false;
  if (std::exchange(is_retry_, false)) return end(now_s);
  enter(State::touching, now_s);
  order(Do::begin_touch, object_);
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
      if (!is_retry_ && now_s - since_s_ >= kRetryS) {
        is_retry_ = true;
        object_ = (object_ + 1) % objects_;
        order(Do::open, object_);
      }
      break;
    case State::opening:
      break;
  }
  return std::exchange(orders_, {});
}

}  // namespace relievo
