// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/pcl_version.h"

#include <pcl/pcl_config.h>

namespace relievo {

const char* pclVersion() noexcept {
  return PCL_VERSION_PRETTY;
}

}  // namespace relievo
