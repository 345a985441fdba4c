// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

namespace relievo::foreign {

/// One test of a plug-in; each runs in a host process of its own.
struct Check {
  std::string_view code, title;
  bool with_device = false;  ///< It opens a device, whose id must be given.
};

inline constexpr std::string_view kPushCheck = "C27";

inline constexpr std::array<Check, 16> kChecks{{
    {"C01", "The table of functions is whole and of this version"},
    {"C02", "It begins and ends"},
    {"C03", "A scan says the same twice, and writes no more than there is room for"},
    {"C04", "An unknown id is no device"},
    {"C05", "An unknown extension is none"},
    {"C06", "Descriptors and threads are as before when it has ended"},
    {"C07", "Signal handlers, locale, rounding, umask, folder and scheduling stay as they were"},
    {"C08", "Nothing is written to the standard output"},
    {"C20", "The limits are possible", true},
    {"C21", "A step takes at most 5 ms", true},
    {"C22", "A step allocates nothing", true},
    {"C23", "Places are numbers, within reach, and of a time that goes on", true},
    {"C24", "No place is a jump away from the one before", true},
    {"C25", "The force is cut within 5 ms, also during a step, before opening and after closing",
     true},
    {"C26", "Closing twice is harmless, and it opens again", true},
    {"C27", "A force rises to --newton and falls again without a fault", true},
}};

}  // namespace relievo::foreign
