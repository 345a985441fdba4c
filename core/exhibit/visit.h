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
  help,  ///< Plus held, or Plus and Minus together.
  // Of who has one button only, which takes what is offered.
  take,
  next,
  back,
  repeat,
  louder,
  softer,
  other
};
/// Before the name of a window's command: a button stands for it, and the window is asked whether
/// the press is a visit's. Answered by false, the command is run as ever. Without a name: whether
/// buttons choose now, so that one button offers what can be chosen.
inline constexpr const char* kButtonFirst = "button:";

/// Of the window's command that a button runs: "finer" is Plus. Absent: it stands for no press, as
/// the end of Move mode.
std::optional<VisitPress> visitPress(std::string_view command) noexcept;

/// What belongs to a visit.
struct VisitPlan {
  std::size_t languages = 1, objects = 1;
  bool introduction = false;  ///< Of the first object: how touch and buttons are.
  bool guide = false;         ///< The hand is offered to be led round each object's outline.
};

/// How the device is, as far as a visit depends on it.
enum class VisitDevice : std::uint8_t {
  ready,
  preparing,  ///< It waits for a person to push its grip in, or starts.
  gone        ///< The staff is needed.
};

/// One visitor after the other: language, object, introduction, touch, and the end when nobody is
/// there any more (EN 301 549, clause 5.1: all by four buttons and ear, never two of them at once;
/// a volume that is reset). Where Plus and Minus are not needed they are louder and softer, and
/// Centre says it again. It says what has to be done; somebody else does it. No clock: time is an
/// argument, in seconds from anywhere. [one thread]
class Visit {
 public:
  enum class State : std::uint8_t {
    idle,      ///< Nobody is there; forces are off.
    language,  ///< Plus, Minus: volume; Centre takes the language, Forward offers the next.
    list,      ///< The same of objects; Forward held says it again, Minus held goes back.
    opening,
    homing,        ///< The device wants its grip pushed in.
    introduction,  ///< Two shapes, until introduced(); the device's buttons are theirs.
    buttons,       ///< What each of them does; a press or kButtonS goes on.
    object,        ///< What can be said of it, until it is said or a button passes it over.
    offer,         ///< To be led: Plus takes it.
    guiding,       ///< Until guided().
    touching,      ///< Buttons do what they always do; Minus held at the whole relief goes back.
    help,          ///< Volume and repeating for kHelpS; Forward goes back to touching.
    let_go,        ///< The grip lies there; forces are off until it is taken again.
    still,         ///< "Are you still there?"; any input goes back to where it was asked.
    fault          ///< Nothing can be opened, or no device; tried again each kRetryS.
  };
  enum class Do : std::uint8_t {
    chime,
    welcome,         ///< And the language `index`, if there is a choice.
    offer_language,  ///< `index`.
    offer_object,    ///< `index`.
    open,            ///< Object `index`; opened() or failed() answers.
    say_homing,      ///< What to do with the grip.
    introduce,       ///< Forces on, and the shapes under the hand; introduced() answers.
    next_shape,      ///< Of the introduction.
    end_introduction,
    explain,     ///< What the button number `index` does, of kExplained; `press` was pressed.
    say_object,  ///< What can be said of object `index`; forces on if they are off.
    offer_guide,
    guide,        ///< Round the outline once; guided() answers.
    begin_touch,  ///< Object `index` is open and nothing was said of it: forces on.
    begin_free,   ///< The same, and everything was said.
    say_failed,
    say_needs_help,
    retry_device,
    end_touch,  ///< Forces off; the object may stay open.
    say_let_go,
    touch_again,  ///< Forces on.
    say_forces_off,
    say_help,
    repeat,  ///< What was said last.
    louder,
    softer,
    ask_still_there,
    say_goodbye,
    reset  ///< Language, volume and everything that the visitor changed.
  };
  struct Order {
    Do what;
    std::size_t index = 0;
    VisitPress press = VisitPress::other;  ///< Of `explain`; other: none.
    friend bool operator==(const Order&, const Order&) = default;
  };

  static constexpr double kLanguageAgainS = 12, kLanguageEndS = 30;
  static constexpr double kRetryS = 60, kHelpAgainS = 30;
  static constexpr double kGoneS = 2;  ///< A device that answers late once is not lost.
  static constexpr double kHomingAgainS = 10, kHomingEndS = 30;
  static constexpr std::size_t kExplained = 5;  ///< Middle, Plus, Minus, Forward, middle held.
  static constexpr double kButtonS = 12, kOfferS = 10, kHelpS = 20;
  static constexpr double kPauseS = 0.7;      ///< After speech, before what nobody asked for.
  static constexpr double kBeginsS = 1;       ///< So long a voice may take to begin.
  static constexpr double kMostObjectS = 60;  ///< A voice that never ends is none.

  Visit(const VisitPlan& plan, const ExhibitTimes& times, double now_s);

  /// @param at_whole  the whole relief is shown
  /// @return false: it is not about the visit; the window does what it always does
  bool press(VisitPress press, bool at_whole, double now_s);
  /// The hand, the mouse or any key moved.
  void stir(double now_s);
  void opened(double now_s);
  void failed(double now_s);
  /// The introduction is over, or there is none.
  void introduced(double now_s);
  /// The guide has ended, or there is no outline.
  void guided(double now_s);
  /// Somebody, or the loop, has switched the forces off.
  void stopped(double now_s);
  /// Nobody holds the grip.
  void letGo(double now_s);
  /// Something is being said now. Call it as often as take().
  void speaking(double now_s) { spoke_s_ = now_s; }
  /// How the device is now; what is gone for kGoneS is lost. Call it at least once a second.
  void device(VisitDevice device, double now_s);
  /// What has to be done by now, oldest first. Call it at least ten times a second.
  std::vector<Order> take(double now_s);

  /// Buttons choose now, and do not touch.
  bool chooses() const noexcept;
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
  /// What is the same in every state but touching: volume and repeating by their own names.
  bool pressOfVoice(VisitPress press);
  void pressInLanguage(VisitPress press, double now_s);
  void pressInList(VisitPress press, double now_s);
  bool pressInIntroduction(VisitPress press);
  void pressInButtons(VisitPress press, double now_s);
  void pressInObject(VisitPress press, double now_s);
  void pressInOffer(VisitPress press, double now_s);
  void pressInHelp(VisitPress press, double now_s);
  bool pressInTouch(VisitPress press, bool at_whole, double now_s);
  bool pressWithVolume(VisitPress press);
  void beginObject(double now_s);
  void explain(double now_s, VisitPress pressed = VisitPress::other);
  void sayObject(double now_s);
  void beginOffer(double now_s);
  void touchFreely(double now_s);
  void goBack(double now_s);
  void loseDevice(double now_s);
  void takeOfObject(double now_s);
  void retry(double now_s);
  bool isLost(double now_s) const {
    return device_ == VisitDevice::gone && now_s - gone_s_ >= kGoneS;
  }
  static bool isOfObject(State state);  // From the introduction until the hand is free.
  bool isQuiet(double now_s) const { return now_s - spoke_s_ >= kPauseS; }
  void offerNext();
  void askForHelp(double now_s);

  VisitPlan plan_;
  ExhibitTimes times_;
  State state_ = State::idle, before_ = State::idle;
  std::size_t language_ = 0, object_ = 0;
  std::vector<bool> broken_;
  std::vector<Order> orders_;
  double since_s_ = 0, input_s_ = 0, chimed_s_ = 0, helped_s_ = 0, spoke_s_ = 0;
  bool said_again_ = false, is_retry_ = false;
  bool introduced_ = false;    // This visitor.
  bool free_is_due_ = false;   // To say that the guide is over, once it has said why.
  std::size_t explained_ = 0;  // Buttons so far.
  VisitDevice device_ = VisitDevice::ready;
  double gone_s_ = 0;       // Since when it is.
  bool no_device_ = false;  // In `fault`: that is why.
};

}  // namespace relievo
