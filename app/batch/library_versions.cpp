// SPDX-License-Identifier: BSD-3-Clause
#include "app/batch/library_versions.h"

#include <algorithm>

#include "core/project/zip_target.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/device/hid/hid_devices.h"
#include "ui/figure/picture_libraries.h"

namespace relievo::batch {

std::vector<LibraryVersion> libraryVersions() {
  std::vector<LibraryVersion> all = coreLibraries();
  for (const LibraryVersion& one : pictureLibraries()) all.push_back(one);
  all.push_back({"hidapi", hid::hidapiVersion()});
  all.push_back({"libusb", falcon::libusbVersion()});
  all.push_back({"libzip", libzipVersion()});
  std::sort(all.begin(), all.end(),
            [](const LibraryVersion& a, const LibraryVersion& b) { return a.name < b.name; });
  return all;
}

}  // namespace relievo::batch
