// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

#include "core/base/vec3.h"
#include "core/message/message.h"
#include "haptics/device/device.h"
#include "haptics/device/falcon/port.h"
#include "haptics/device/falcon/protocol.h"

namespace relievo::falcon {

enum class LinkState : std::uint8_t {
  closed,
  absent,       ///< Not plugged in; waited for.
  forbidden,    ///< E301
  busy,         ///< E304
  broken,       ///< The system refuses it otherwise; `detail` says how.
  several,      ///< More than one could be meant; waited for until it is clear.
  checking,     ///< Does its firmware run already?
  no_firmware,  ///< It does not, and no file was found; `detail` says where was looked.
  starting,     ///< Loading the firmware (E302).
  not_started,  ///< All attempts failed (E303).
  homing,       ///< E308
  pull_out,     ///< Homed; no force until the grip was pulled out once.
  ready,
  silent,  ///< Stopped answering; being woken.
};

/// How evenly answers come.
struct LinkCounts {
  /// Upper edges of the histogram of times from answer to answer, ns; the last bin takes the rest.
  static constexpr std::array<std::int64_t, 7> kGapEdgesNs{
      800'000, 1'000'000, 1'200'000, 2'000'000, 5'000'000, 20'000'000, 100'000'000};

  std::uint64_t frames = 0;        ///< Whole answers.
  std::uint64_t malformed = 0;     ///< Pieces that were none; dropped.
  std::uint64_t hiccups = 0;       ///< No answer for 5 ms: asked again, with zero force.
  std::uint64_t stalls = 0;        ///< None for 20 ms: forces off.
  std::uint64_t purges = 0;        ///< None for 500 ms: buffers emptied.
  std::uint64_t failed_reads = 0;  ///< The USB system broke one off: asked again, with zero force.
  std::uint64_t impossible_poses = 0;
  std::uint64_t held_poses = 0;  ///< The hand cannot have come there; not believed.
  std::uint64_t overruns = 0, framing = 0, parity = 0;  ///< Told by the bridge chip.
  std::int64_t worst_gap_ns = 0;  ///< Since times were last measured anew, or the link runs.
  std::array<std::uint64_t, kGapEdgesNs.size() + 1> gaps{};
};

/// What the set-up assistant, `relievo devices` and the status bar show.
struct LinkStatus {
  LinkState state = LinkState::closed;
  int attempt = 0, attempts = 0;  ///< Of starting.
  std::uint32_t uploaded_bytes = 0, firmware_bytes = 0;
  bool firmware_was_running = false;
  std::uint8_t homed = 0;       ///< Bit i: arm i.
  bool homing_is_long = false;  ///< For 20 s now; a hint may help.
  std::array<std::int16_t, kArms> encoders{};
  std::uint32_t buttons = 0;
  DeviceMm position;
  double rate_hz = 0;  ///< Answers per second, over the last quarter second or so.
  /// From question to answer, since times were last measured anew, or the link runs.
  double mean_answer_ms = 0, worst_answer_ms = 0;
  std::uint64_t unplugged = 0;  ///< How many times it went away while open.
  /// In a row that came to nothing although it is plugged in. In the states `silent` and
  /// `not_started` (E303): why it is in them.
  int failed_openings = 0;
  LinkCounts counts;
  /// A message as bytes (`detailOf`), because it crosses threads without allocation; see the
  /// states.
  std::array<char, 700> detail{};
  std::uint16_t detail_size = 0;  ///< 0: none.
  /// Zero-terminated, as the next ones. Of the one that is open, or was; SeenFalcon.
  std::array<char, 48> serial{}, port{};
  std::array<char, 120> wanted{};  ///< Opening::wanted.
  std::array<char, 300> others{};  ///< Opening::others.
};
static_assert(std::is_trivially_copyable_v<LinkStatus>);

/// Of what was tried to open one.
LinkStatus statusOf(const Opening& opening);
/// What it says in words, into the fields for them.
void take(const Opening& opening, LinkStatus& status);

/// One that is too long for its place goes as its English text, cut.
void putDetail(const Message& detail, LinkStatus& status);
std::optional<Message> detailOf(const LinkStatus& status);

/// What happened, what the program did, what you can do; and at most a dozen words for ears.
Message describe(const LinkStatus& status);

/// The udev rules that let whoever sits at the computer use the Falcon and the HID devices that
/// press its buttons (hid/hid_devices.h): one line each, as the file that is installed has them.
std::string udevRule();

}  // namespace relievo::falcon
