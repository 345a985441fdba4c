// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Only for the .cpp files of core/project that read and write packages: what both need of libzip.
#include <zip.h>

#include <memory>

namespace relievo {

struct DiscardZip {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Zip = std::unique_ptr<zip_t, DiscardZip>;

}  // namespace relievo
