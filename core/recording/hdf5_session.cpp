// SPDX-License-Identifier: BSD-3-Clause
#include "core/recording/hdf5_session.h"

#include "core/base/failure.h"

namespace relievo::hdf5 {

void throwRefused() {
  throw failure<MessageId::hdf5_refused>();
}

void require(herr_t status) {
  if (status < 0) throw failure<MessageId::hdf5_not_written>();
}

}  // namespace relievo::hdf5
