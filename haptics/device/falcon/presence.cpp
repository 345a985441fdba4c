// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/presence.h"

namespace relievo::falcon {

Message describe(const Opening& opening) {
  return describe(statusOf(opening));
}

bool onlyThePlugHelps(Presence presence) {
  return presence == Presence::absent || presence == Presence::several;
}

}  // namespace relievo::falcon
