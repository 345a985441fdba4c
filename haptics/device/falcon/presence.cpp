// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/presence.h"

namespace relievo::falcon {

LinkMessage describe(const Opening& opening) {
  constexpr std::array<LinkState, 5> kStates{LinkState::closed, LinkState::absent,
                                             LinkState::forbidden, LinkState::busy,
                                             LinkState::broken};
  LinkStatus status;
  status.state = kStates[static_cast<std::size_t>(opening.presence)];
  opening.detail.copy(status.detail.data(), status.detail.size() - 1);
  return describe(status);
}

}  // namespace relievo::falcon
