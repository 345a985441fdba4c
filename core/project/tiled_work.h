// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "core/io/import.h"
#include "core/session/large/large_map.h"

namespace relievo {

/// A map by tiles as it is asked for. `relievo depthmap --memory` and the window make it by this
/// one function, so that both write the same bytes.
struct TiledWork {
  std::vector<std::filesystem::path> names;  ///< As filesNamed() takes them; at least one.
  std::filesystem::path out;                 ///< Of the finest level.
  SurfaceOptions options = {};
  ImportOptions import = {};
  std::uint64_t memory_bytes = 2'000'000'000;  ///< For all but the program itself.
  int threads = 0;                             ///< 0: as many as there are usable cores.
  std::filesystem::path job_folder = {};       ///< What is finished is kept there; empty: nowhere.
  Exchange* processes = nullptr;               ///< As LargeMapOptions::processes.
  std::function<void(const Surface& view)> on_view = {};  ///< As LargeMapOptions::on_view. [worker]
  std::function<void(const ReadyMap& ready)> on_ready = {};  ///< Likewise.
};

/// Makes the map with all its levels; each file says where it comes from, with the checksum of
/// every file that was read. What is in the folder of the job is taken over if the files, the
/// options and the program are the same. [worker]
/// @throw FileError, ArgumentError, WriteError, Cancelled, OtherProcessStopped  as filesNamed and
/// makeLargeMap
LargeMap makeTiledMap(const TiledWork& work, const Task& task = {});

}  // namespace relievo
