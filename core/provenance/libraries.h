// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace relievo {

/// An outside library and which of its versions runs here.
struct LibraryVersion {
  std::string name, version;
  friend bool operator==(const LibraryVersion&, const LibraryVersion&) = default;
};

/// Those that decide what is read, computed and written without a picture, by name. As this process
/// has loaded them; PCL and FLANN, which tell no version while they run, as they were built in, and
/// the loader takes no other.
std::vector<LibraryVersion> coreLibraries();

/// What a result came out as (madeText), with these beside its "libraries".
std::string withLibraries(std::string_view made, const std::vector<LibraryVersion>& more);

}  // namespace relievo
