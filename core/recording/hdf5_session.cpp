// SPDX-License-Identifier: BSD-3-Clause
#include "core/recording/hdf5_session.h"

#include "core/base/failure.h"
#include "core/recording/hdf5_version.h"

namespace relievo::hdf5 {

void throwRefused() {
  throw failure<MessageId::hdf5_refused>();
}

void require(herr_t status) {
  if (status < 0) throw failure<MessageId::hdf5_not_written>();
}

}  // namespace relievo::hdf5

namespace relievo {

std::string hdf5Version() {
  const std::scoped_lock lock(hdf5::library());
  unsigned major = 0, minor = 0, release = 0;
  if (H5get_libversion(&major, &minor, &release) < 0) return "unknown";
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(release);
}

}  // namespace relievo
