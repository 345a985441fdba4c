// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/commands/button_commands.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/message/catalogue.h"

namespace relievo {

namespace {
constexpr double kBounceS = 0.06, kShortS = 0.5, kLongS = 0.7, kLongCentreS = 1.5;
constexpr double kHelpS = 2, kIntroductionS = 5, kAgainS = 5;
constexpr double kStepMm = 20, kBackMm = 10;

constexpr bool isOfPair(std::size_t button) {
  return button == ButtonCommands::kPlus || button == ButtonCommands::kMinus;
}

struct Word {
  std::string_view name;
  MessageId words;
};
constexpr std::array<Word, 29> kWords{
    {{"", MessageId::command_none},
     {"finer", MessageId::command_finer},
     {"coarser", MessageId::command_coarser},
     {"whole", MessageId::command_whole},
     {"sayDetail", MessageId::command_say_detail},
     {"whereAmI", MessageId::command_where_am_i},
     {"whereAmILong", MessageId::command_where_am_i_long},
     {"forces", MessageId::command_toggle_forces},
     {"forcesOff", MessageId::command_stop_forces},
     {"moveMode", MessageId::command_begin_move},
     {"moveDone", MessageId::command_confirm_move},
     {"moveBack", MessageId::command_cancel_move},
     {"move_left", MessageId::command_move_left},
     {"move_right", MessageId::command_move_right},
     {"move_up", MessageId::command_move_up},
     {"move_down", MessageId::command_move_down},
     {"next_place", MessageId::command_next_place},
     {"previous_place", MessageId::command_previous_place},
     {"beacon", MessageId::command_toggle_beacon},
     {"pointer_switch", MessageId::command_switch_pointer},
     {"buttonHelp", MessageId::command_help},
     {"touchIntroduction", MessageId::command_restart_introduction},
     {"repeatSpeech", MessageId::command_repeat},
     {"louderSpeech", MessageId::command_louder},
     {"softerSpeech", MessageId::command_softer},
     {"guide", MessageId::command_guide},
     {"take", MessageId::command_take},
     {"next", MessageId::command_next},
     {"back", MessageId::command_back}}};

/// One-button scanning goes round in these: what is touched, then what is said (EN 301
/// 549, 5.1.3.4, 5.1.3.11 and 5.9: repeat and volume by hand, and nothing that needs two buttons at
/// once).
constexpr std::array<ButtonCommand, 11> kScan{
    ButtonCommand::where_am_i,    ButtonCommand::finer,      ButtonCommand::coarser,
    ButtonCommand::whole,         ButtonCommand::begin_move, ButtonCommand::guide,
    ButtonCommand::toggle_forces, ButtonCommand::repeat,     ButtonCommand::louder,
    ButtonCommand::softer,        ButtonCommand::help};
/// The same where something is chosen.
constexpr std::array<ButtonCommand, 7> kScanChoosing{
    ButtonCommand::take,   ButtonCommand::next,   ButtonCommand::back, ButtonCommand::repeat,
    ButtonCommand::louder, ButtonCommand::softer, ButtonCommand::help};
/// The same in Move mode.
constexpr std::array<ButtonCommand, 9> kScanMoving{
    ButtonCommand::confirm_move, ButtonCommand::next_place,    ButtonCommand::previous_place,
    ButtonCommand::cancel_move,  ButtonCommand::toggle_forces, ButtonCommand::repeat,
    ButtonCommand::louder,       ButtonCommand::softer,        ButtonCommand::help};
}  // namespace

std::string_view commandName(ButtonCommand command) noexcept {
  return kWords[static_cast<std::size_t>(command)].name;
}

Message messageOf(ButtonCommand command) {
  return {kWords[static_cast<std::size_t>(command)].words, {}};
}

ButtonCommands::ButtonCommands(ButtonOptions options) : options_(options) {
  options_.scan_s = std::clamp(options_.scan_s, 0.5, 5.0);
}

void ButtonCommands::setOptions(const ButtonOptions& options) {
  if (options.one_button != options_.one_button) {
    for (Button& button : buttons_) button.used = true;
    offered_ = -1;
  }
  options_ = ButtonCommands(options).options_;
}

void ButtonCommands::forgetPresses() {
  for (Button& button : buttons_) button = {};
  together_ = false;
}

void ButtonCommands::toggleMoving() {
  moving_ = !moving_;
  move_from_.reset();
  run(moving_ ? ButtonCommand::begin_move : ButtonCommand::confirm_move);
}

void ButtonCommands::cancelMoving() {
  if (!moving_) return;
  moving_ = false;
  run(ButtonCommand::cancel_move);
}

void ButtonCommands::press(std::uint8_t button, bool down, double time_s) {
  if (button >= kButtons) return;
  Button& b = buttons_[button];
  // What was taken for a bounce and stayed was none, also where nobody asked meanwhile.
  const double settled_s = b.edge_s + kBounceS;
  if (b.raw != b.down && time_s >= settled_s) edge(button, b.raw, settled_s);
  b.raw = down;
  if (down != b.down && time_s - b.edge_s >= kBounceS) edge(button, down, time_s);
}

void ButtonCommands::edge(std::size_t index, bool down, double time_s) {
  Button& b = buttons_[index];
  const bool another = anyDown();
  b.down = down;
  b.edge_s = time_s;
  if (down) {
    b.since_s = time_s;
    b.used = b.ticked = false;
    if (index == kCentre) forces_on_at_press_ = forces_on_;
    if (options_.one_button) {
      b.used = another;  // A hand that comes down on two of them has pressed once.
    } else if (buttons_[kPlus].down && buttons_[kMinus].down) {
      together_ = true;
      together_said_ = 0;
      buttons_[kPlus].used = buttons_[kMinus].used = true;
      b.since_s = time_s;
    }
    return;
  }
  if (!b.used) released(index, time_s - b.since_s);
  // The first of the two to go up ends it. A SpaceMouse has no other two buttons.
  if (together_ && buttons_[kPlus].down != buttons_[kMinus].down && isOfPair(index)) {
    releasedTogether(time_s - std::max(buttons_[kPlus].since_s, buttons_[kMinus].since_s));
  }
  if (!buttons_[kPlus].down && !buttons_[kMinus].down) together_ = false;
}

void ButtonCommands::released(std::size_t index, double held_s) {
  // However slowly a finger leaves the button: all that is no stop is a press.
  if (options_.one_button) return scan(buttons_[index].edge_s);
  if (held_s <= kShortS) shortPress(index, buttons_[index].edge_s);
}

void ButtonCommands::releasedTogether(double held_s) {
  if (together_said_ == 0 && held_s <= kShortS) run(ButtonCommand::switch_pointer);
}

void ButtonCommands::run(ButtonCommand command) {
  outcomes_.push_back({ButtonOutcome::Kind::run, command});
}

void ButtonCommands::voicePress(std::size_t index, double time_s) {
  constexpr std::array<ButtonCommand, kButtons> kVoice{
      ButtonCommand::louder, ButtonCommand::none, ButtonCommand::repeat, ButtonCommand::softer};
  helped_s_ = index == kForward ? -100 : time_s;
  if (index != kForward) run(kVoice[index]);
}

void ButtonCommands::shortPress(std::size_t index, double time_s) {
  if (has_voice_ && time_s - helped_s_ <= kHelpLastsS) return voicePress(index, time_s);
  switch (index) {
    case kPlus:
      run(moving_ ? ButtonCommand::next_place : ButtonCommand::finer);
      break;
    case kMinus:
      run(moving_ ? ButtonCommand::previous_place : ButtonCommand::coarser);
      break;
    case kForward:
      toggleMoving();
      break;
    case kCentre:
      if (moving_) {
        cancelMoving();
        break;
      }
      run(time_s - asked_where_s_ <= kAgainS ? ButtonCommand::where_am_i_long
                                             : ButtonCommand::where_am_i);
      asked_where_s_ = time_s;
      break;
    default:
      break;
  }
}

void ButtonCommands::longPress(std::size_t index) {
  constexpr std::array<ButtonCommand, kButtons> kLong{
      ButtonCommand::say_detail, ButtonCommand::toggle_beacon, ButtonCommand::toggle_forces,
      ButtonCommand::whole};
  if (index == kCentre && forces_on_at_press_) return run(ButtonCommand::stop_forces);
  // In Move mode only stopping the forces has a long press, and Forward, which leaves it.
  if (moving_ && index == kForward) {
    toggleMoving();
    return run(ButtonCommand::guide);
  }
  if (!moving_ || index == kCentre) run(kLong[index]);
}

void ButtonCommands::held(std::size_t index, double held_s) {
  Button& b = buttons_[index];
  if (!b.ticked && held_s >= kLongS) {
    b.ticked = true;
    outcomes_.push_back({ButtonOutcome::Kind::tick, ButtonCommand::none});
  }
  if (held_s < (index == kCentre || options_.one_button ? kLongCentreS : kLongS)) return;
  b.used = true;
  if (options_.one_button) {
    offered_ = -1;
    run(ButtonCommand::stop_forces);
    return;
  }
  longPress(index);
}

void ButtonCommands::heldTogether(double held_s) {
  if (together_said_ == 0 && held_s >= kHelpS) {
    together_said_ = 1;
    run(ButtonCommand::help);
  }
  if (together_said_ == 1 && held_s >= kIntroductionS) {
    together_said_ = 2;
    run(ButtonCommand::restart_introduction);
  }
}

std::span<const ButtonCommand> ButtonCommands::scanned() const {
  if (moving_) return kScanMoving;
  if (choosing_) return kScanChoosing;
  return kScan;
}

ButtonCommand ButtonCommands::offer(int index) const {
  const std::span<const ButtonCommand> all = scanned();
  return index + 1 == offers() ? all.back() : all[static_cast<std::size_t>(index)];
}

/// The three of the voice stand before the last.
int ButtonCommands::offers() const {
  constexpr std::size_t kOfVoice = 3;
  return static_cast<int>(scanned().size() - (has_voice_ ? 0 : kOfVoice));
}

void ButtonCommands::setChoosing(bool choosing) {
  if (choosing == choosing_) return;
  choosing_ = choosing;
  offered_ = -1;  // What was offered is not there any more.
}

bool ButtonCommands::anyDown() const {
  return std::any_of(buttons_.begin(), buttons_.end(),
                     [](const Button& button) { return button.down; });
}

void ButtonCommands::scan(double time_s) {
  if (offered_ < 0) {
    offered_ = 0;
    offered_s_ = time_s;
    outcomes_.push_back({ButtonOutcome::Kind::offer, offer(0)});
    return;
  }
  const ButtonCommand chosen = offer(std::exchange(offered_, -1));
  if (chosen == ButtonCommand::begin_move || chosen == ButtonCommand::confirm_move) {
    toggleMoving();
  } else if (chosen == ButtonCommand::cancel_move) {
    cancelMoving();
  } else {
    run(chosen);
  }
}

void ButtonCommands::hand(DeviceMm position) {
  if (!moving_) return;
  if (!move_from_) {
    move_from_ = position;
    move_armed_ = true;
  }
  const double x = position.x - move_from_->x, y = position.y - move_from_->y;
  const double away = std::max(std::abs(x), std::abs(y));
  if (away < kBackMm) move_armed_ = true;
  if (!move_armed_ || away <= kStepMm) return;
  move_armed_ = false;  // One step, one way back.
  if (std::abs(x) > std::abs(y)) {
    run(x > 0 ? ButtonCommand::move_right : ButtonCommand::move_left);
  } else {
    run(y > 0 ? ButtonCommand::move_up : ButtonCommand::move_down);
  }
}

std::vector<ButtonOutcome> ButtonCommands::take(double now_s) {
  for (std::size_t i = 0; i < kButtons; ++i) {
    Button& b = buttons_[i];
    // What was taken for a bounce and stayed was none.
    if (b.raw != b.down && now_s - b.edge_s >= kBounceS) edge(i, b.raw, now_s);
    if (b.down && !b.used) held(i, now_s - b.since_s);
  }
  if (together_ && buttons_[kPlus].down && buttons_[kMinus].down) {
    heldTogether(now_s - std::max(buttons_[kPlus].since_s, buttons_[kMinus].since_s));
  }
  // The offer that is taken is the one that was said when the button went down.
  if (offered_ >= 0 && !anyDown() && now_s - offered_s_ >= options_.scan_s) {
    offered_s_ = now_s;
    ++offered_;
    if (offered_ == offers()) {
      offered_ = -1;  // Once round: the scan ends by itself.
    } else {
      outcomes_.push_back({ButtonOutcome::Kind::offer, offer(offered_)});
    }
  }
  return std::exchange(outcomes_, {});
}

std::vector<Message> ButtonCommands::help(double now_s) {
  if (options_.one_button) {
    return {moving_ ? said<MessageId::one_button_help_moving>()
                    : said<MessageId::one_button_help>()};
  }
  std::vector<Message> help{moving_ ? said<MessageId::buttons_help_moving>()
                                    : said<MessageId::buttons_help>()};
  if (!has_voice_) return help;
  helped_s_ = now_s;
  help.push_back(said<MessageId::buttons_help_speech>());
  return help;
}

}  // namespace relievo
