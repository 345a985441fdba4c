// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/exhibit/exhibit.h"

namespace relievo {

/// What a visitor presses: the device's four buttons, short and held, or the keys that stand for
/// them.
enum class VisitPress : std::uint8_t {
  plus,
  minus,
  centre,
  forward,
  forward_held,
  minus_held,
  help,  ///< Plus and Minus together.
  other
};
/// Before the name of a window's command: a button stands for it, and the window is asked whether
/// the press is a visit's. Answered by false, the command is run as ever.
inline constexpr const char* kButtonFirst = "button:";

/// Of the window's command that a button runs: "finer" is Plus. Absent: it stands for no press, as
/// the end of Move mode.
std::optional<VisitPress> visitPress(std::string_view command) noexcept;

/// One visitor after the other: language, object, touch, and the end when nobody is there any more
/// (EN 301 549, clause 5.1: all by four buttons and ear; a volume that is reset). It says what has
/// to be done; somebody else does it. No clock: time is an argument, in seconds from anywhere. [one
/// thread]
class Visit {
 public:
  enum class State : std::uint8_t {
    idle,      ///< Nobody is there; forces are off.
    language,  ///< Plus, Minus: volume; Centre takes the language, Forward offers the next.
    list,      ///< The same of objects; Forward held says it again, Minus held goes back.
    opening,
    touching,  ///< Buttons do what they always do; Minus held at the whole relief goes back.
    still,     ///< "Are you still there?"; any input goes back to where it was asked.
    fault      ///< Nothing can be opened; tried again each kRetryS.
  };
  enum class Do : std::uint8_t {
    chime,
    welcome,         ///< And the language `index`, if there is a choice.
    offer_language,  ///< `index`.
    offer_object,    ///< `index`.
    open,            ///< Object `index`; opened() or failed() answers.
    begin_touch,     ///< Object `index` is open: forces on.
    say_failed,
    say_needs_help,
    end_touch,  ///< Forces off; the object may stay open.
    louder,
    softer,
    ask_still_there,
    say_goodbye,
    reset  ///< Language, volume and everything that the visitor changed.
  };
  struct Order {
    Do what;
    std::size_t index = 0;
    friend bool operator==(const Order&, const Order&) = default;
  };

  static constexpr double kLanguageAgainS = 12, kLanguageEndS = 30;
  static constexpr double kRetryS = 60, kHelpAgainS = 30;

  Visit(std::size_t languages, std::size_t objects, const ExhibitTimes& times, double now_s);

  /// @param at_whole  the whole relief is shown
  /// @return false: it is not about the visit; the window does what it always does
  bool press(VisitPress press, bool at_whole, double now_s);
  /// The hand, the mouse or any key moved.
  void stir(double now_s);
  void opened(double now_s);
  void failed(double now_s);
  /// What has to be done by now, oldest first. Call it at least ten times a second.
  std::vector<Order> take(double now_s);

  State state() const noexcept { return state_; }
  std::size_t language() const noexcept { return language_; }
  std::size_t object() const noexcept { return object_; }

 private:
  void order(Do what, std::size_t index = 0) { orders_.push_back({what, index}); }
  void enter(State state, double now_s);
  void begin(double now_s);
  void end(double now_s);
  void takeLanguage(double now_s);
  void openObject(double now_s);
  bool pressInLanguage(VisitPress press, double now_s);
  bool pressInList(VisitPress press, double now_s);
  void offerNext();
  void askForHelp(double now_s);

  std::size_t languages_, objects_;
  ExhibitTimes times_;
  State state_ = State::idle, before_ = State::idle;
  std::size_t language_ = 0, object_ = 0;
  std::vector<bool> broken_;
  std::vector<Order> orders_;
  double since_s_ = 0, input_s_ = 0, chimed_s_ = 0, helped_s_ = 0;
  bool said_again_ = false, is_retry_ = false;
};

}  // namespace relievo
