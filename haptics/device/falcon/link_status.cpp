// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/link_status.h"

namespace relievo::falcon {

namespace {
constexpr const char* kHomingHint =
    " It takes long: pull straight out, push straight in, as far as it goes; do not twist.";

std::string missingArms(std::uint8_t homed) {
  constexpr std::array<const char*, kArms> kNames{"top", "right", "left"};
  std::string text;
  for (std::size_t i = 0; i < kArms; ++i) {
    if ((homed >> i & 1U) != 0) continue;
    text += (text.empty() ? "" : ", ") + std::string(kNames[i]);
  }
  return text;
}

template <std::size_t Size>
void put(const std::string& text, std::array<char, Size>& into) {
  into.fill('\0');
  text.copy(into.data(), Size - 1);
}

LinkMessage describeAbsent(const LinkStatus& status) {
  const std::string wanted = status.wanted.data(), others = status.others.data();
  if (status.unplugged > 0) {
    return {"E305",
            others.empty() ? "Falcon unplugged. Forces off. View and recording go on. Plug it in "
                             "again, or choose the mouse as the device."
                           : "Falcon unplugged. Forces off. View and recording go on. Plug it in "
                             "again. There is also " +
                                 others + ", which is not used in its place unless you choose it.",
            "Falcon unplugged. Forces are off."};
  }
  if (wanted.empty()) {
    return {"", "No Falcon is plugged in. Plug in its power supply, then its USB cable.",
            "No Falcon is plugged in."};
  }
  return {"",
          others.empty() ? wanted +
                               " was chosen and is not plugged in. Plug in its power supply, then "
                               "its USB cable."
                         : wanted + " was chosen and is not plugged in. There is " + others +
                               ", which is not used in its place unless you choose it.",
          "The chosen Falcon is not plugged in."};
}
}  // namespace

LinkStatus statusOf(const Opening& opening) {
  constexpr std::array<LinkState, 6> kStates{LinkState::closed,    LinkState::absent,
                                             LinkState::forbidden, LinkState::busy,
                                             LinkState::broken,    LinkState::several};
  LinkStatus status;
  status.state = kStates[static_cast<std::size_t>(opening.presence)];
  take(opening, status);
  return status;
}

void take(const Opening& opening, LinkStatus& status) {
  put(opening.detail, status.detail);
  put(opening.wanted, status.wanted);
  put(opening.others, status.others);
  if (opening.presence != Presence::present) return;
  put(opening.which.serial, status.serial);
  put(opening.which.port, status.port);
}

LinkMessage describe(const LinkStatus& status) {
  const std::string detail = status.detail.data();
  switch (status.state) {
    case LinkState::closed:
      return {"", "The Falcon is not in use.", "The Falcon is not in use."};
    case LinkState::absent:
      return describeAbsent(status);
    case LinkState::several:
      return {"",
              "Several Falcons are plugged in: " + std::string(status.others.data()) +
                  ". None is used until you choose one.",
              "Several Falcons are plugged in. Choose one."};
    case LinkState::forbidden:
      return {"E301",
              "A Falcon is plugged in but this account may not use it. Install the rule that the "
              "device set-up shows and 'relievo devices rule' prints, once (needs an "
              "administrator), then replug.",
              "Falcon found, but not allowed. Ask staff."};
    case LinkState::busy:
      return {"E304", "Another program is using the Falcon. Close it, then try again.",
              "The Falcon is busy."};
    case LinkState::broken:
      return {"", "The Falcon could not be opened: " + detail + ". Replug it, or try another port.",
              "The Falcon could not be opened."};
    case LinkState::checking:
      return {"", "Asking the Falcon whether it is ready.", "Falcon found."};
    case LinkState::no_firmware:
      return {"", detail, "The Falcon needs its firmware file."};
    case LinkState::starting: {
      const std::string count =
          std::to_string(status.attempt) + " of " + std::to_string(status.attempts);
      return {"E302", "Starting the Falcon – attempt " + count + ". This is normal.",
              status.attempt > 3 ? "Still starting." : "Starting the Falcon."};
    }
    case LinkState::not_started:
      if (status.failed_openings > 0) {
        return {"E303",
                "The connection to the Falcon failed " + std::to_string(status.failed_openings) +
                    " times, although it is plugged in. Forces are off; it is tried again every "
                    "10 seconds. Plug it straight into the computer, if you can with another "
                    "cable, or choose Touch > Device set-up > Retry.",
                "The Falcon does not answer. Forces are off."};
      }
      return {"E303",
              "The Falcon did not start after " + std::to_string(status.attempts) +
                  " attempts; it is left alone now. Check its power supply and plug it straight "
                  "into the computer, or choose Touch > Device set-up > Retry." +
                  (detail.empty() ? "" : " (" + detail + ")"),
              "The Falcon did not start. You can continue with the mouse."};
    case LinkState::homing:
      return {"E308",
              "Please pull the grip fully out, then push it fully in. Still missing: " +
                  missingArms(status.homed) + "." + (status.homing_is_long ? kHomingHint : ""),
              status.homing_is_long ? "Straight out, straight in; do not twist the grip."
                                    : "Please pull the grip fully out, then push it fully in."};
    case LinkState::pull_out:
      return {"E308", "All three arms have found their place. Pull the grip fully out once more.",
              "Pull the grip fully out."};
    case LinkState::ready:
      return {"", "Falcon ready.", "Falcon ready."};
    case LinkState::silent:
      if (status.failed_openings > 0) {
        return {"",
                "The connection to the Falcon fails, although it is plugged in. Forces are off; it "
                "is opened anew – " +
                    std::to_string(status.failed_openings) + " of " +
                    std::to_string(status.attempts) + ".",
                "The Falcon does not answer. Forces are off."};
      }
      return {"", "The Falcon does not answer. Forces are off; trying to wake it.",
              "The Falcon does not answer. Forces are off."};
  }
  return {};
}

std::string udevRule() {
  const std::string give = R"(MODE="0660", GROUP="plugdev", TAG+="uaccess")"
                           "\n";
  return R"(SUBSYSTEM=="usb", ENV{DEVTYPE}=="usb_device", ATTR{idVendor}=="0403", )"
         R"(ATTR{idProduct}=="cb48", )" +
         give +
         R"(SUBSYSTEM=="hidraw", KERNELS=="*:256F:*|*:046D:C60[356].*|*:046D:C62[135678B].*", )" +
         give +
         R"(SUBSYSTEM=="hidraw", ACTION!="remove", )"
         R"(PROGRAM="/usr/bin/od -An -tx1 -w8 -N8 /sys%p/device/report_descriptor", )"
         R"(RESULT=="*05 01 09 0[458] *|*05 01 15 00 09 0[458] *", )" +
         give;
}

}  // namespace relievo::falcon
