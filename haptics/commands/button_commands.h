// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/vec3.h"
#include "core/message/message.h"

namespace relievo {

/// What a person can ask for without a screen (paper, sec. 6: scale and place by the device's
/// buttons). The same commands as keys and menus.
enum class ButtonCommand : std::uint8_t {
  none,
  finer,
  coarser,
  whole,
  say_detail,
  where_am_i,
  where_am_i_long,
  toggle_forces,
  stop_forces,
  begin_move,
  confirm_move,
  cancel_move,
  move_left,
  move_right,
  move_up,
  move_down,
  next_place,
  previous_place,
  toggle_beacon,
  switch_pointer,
  help,
  restart_introduction,
  repeat,
  louder,
  softer,
  guide,
  // Where something is chosen, for who has one button: ButtonCommands::setChoosing().
  take,
  next,
  back,
};
/// Object name of the window's command: "finer", "whereAmI".
std::string_view commandName(ButtonCommand command) noexcept;
/// A few words for speech: "Finer detail".
Message messageOf(ButtonCommand command);

struct ButtonOptions {
  /// Any button: the first press starts a scan through a few commands, the next one takes what was
  /// offered last. Held for 1.5 s it stops the forces, and never switches them on.
  bool one_button = false;
  double scan_s = 1.5;  ///< Time for each offer; 0.5 to 5.
};

/// What follows from a press. `offer`: only said, in a scan. `tick`: a button is now held long.
struct ButtonOutcome {
  enum class Kind : std::uint8_t { run, offer, tick } kind = Kind::run;
  ButtonCommand command = ButtonCommand::none;
};

/// Makes commands of presses: short (up to 0.5 s), long (from 0.7 s; centre 1.5 s), plus and minus
/// together (short, 2 s, 5 s), Move mode, one-button scanning. Nothing is ever asked to be pressed
/// twice quickly. No clock: time is an argument. [one thread]
class ButtonCommands {
 public:
  static constexpr std::size_t kButtons = 4;
  static constexpr std::uint8_t kPlus = 0, kForward = 1, kCentre = 2, kMinus = 3;

  explicit ButtonCommands(ButtonOptions options = {});

  /// An edge. Buttons beyond the fourth do nothing. A bounce within 60 ms is none.
  void press(std::uint8_t button, bool down, double time_s);
  /// Where the hand is, while in Move mode: 20 mm away from where it began is one step.
  void hand(DeviceMm position);
  /// What has to be done by now, oldest first. Call it at least ten times a second.
  std::vector<ButtonOutcome> take(double now_s);

  /// Another way of pressing from now on; what is held now does nothing any more.
  void setOptions(const ButtonOptions& options);
  const ButtonOptions& options() const noexcept { return options_; }
  /// Who pressed is gone: what is held is up, and its press does nothing any more.
  void forgetPresses();
  /// As the button Forward: begins Move mode, or confirms and leaves it.
  void toggleMoving();
  /// As Centre in Move mode. Does nothing outside of it.
  void cancelMoving();
  bool moving() const noexcept { return moving_; }
  /// The loop has forces on; a held Centre then stops them, and never switches them on.
  void setForcesOn(bool on) { forces_on_ = on; }
  /// There is a voice whose volume and last words the buttons can change and repeat. Without one
  /// nothing of that is offered.
  void setVoice(bool has_voice) { has_voice_ = has_voice; }
  /// Somebody chooses now, as in an exhibit's list: one button offers to take what was said, to go
  /// on to the next, and back.
  void setChoosing(bool choosing);
  /// Begins help: what the buttons do now, in sentences. After it the four buttons are those of the
  /// voice, if there is one, for kHelpLastsS: Plus louder, Minus softer, Centre repeats, Forward
  /// goes back. Each press begins that time anew; long presses do what they always do.
  std::vector<Message> help(double now_s);
  static constexpr double kHelpLastsS = 20;

 private:
  struct Button {
    bool down = false, raw = false;
    bool used = false;  ///< Its press has had its effect already.
    bool ticked = false;
    double since_s = 0;
    double edge_s = -1;
  };

  void edge(std::size_t index, bool down, double time_s);
  void released(std::size_t index, double held_s);
  void held(std::size_t index, double held_s);
  void heldTogether(double held_s);
  void releasedTogether(double held_s);
  void shortPress(std::size_t index, double time_s);
  void voicePress(std::size_t index, double time_s);
  void longPress(std::size_t index);
  bool anyDown() const;
  void scan(double time_s);
  std::span<const ButtonCommand> scanned() const;
  ButtonCommand offer(int index) const;
  int offers() const;
  void run(ButtonCommand command);

  ButtonOptions options_;
  std::array<Button, kButtons> buttons_;
  std::vector<ButtonOutcome> outcomes_;
  bool moving_ = false;
  bool has_voice_ = true;
  bool choosing_ = false;
  bool forces_on_ = false, forces_on_at_press_ = false;  // Of Centre.
  bool together_ = false;                                // Plus and minus; until both are up.
  int together_said_ = 0;
  double asked_where_s_ = -100;
  double helped_s_ = -100;  // When help was asked for, or a button of the voice was pressed.
  std::optional<DeviceMm> move_from_;
  bool move_armed_ = true;
  int offered_ = -1;  // Of the scan; -1: none.
  double offered_s_ = 0;
};

}  // namespace relievo
