// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/library_versions.h"

#include <algorithm>
#include <utility>

#include "app/cli/drawing.h"
#include "core/project/zip_target.h"
#include "haptics/device/falcon/usb_bus.h"
#include "haptics/device/hid/hid_devices.h"

namespace relievo::batch {

std::vector<LibraryVersion> libraryVersions() {
  std::vector<LibraryVersion> all = coreLibraries();
  if (drawing() != nullptr) {
    for (LibraryVersion& one : drawing()->libraries()) all.push_back(std::move(one));
  }
  all.push_back({"hidapi", hid::hidapiVersion()});
  all.push_back({"libusb", falcon::libusbVersion()});
  all.push_back({"libzip", libzipVersion()});
  std::sort(all.begin(), all.end(),
            [](const LibraryVersion& a, const LibraryVersion& b) { return a.name < b.name; });
  return all;
}

}  // namespace relievo::batch
