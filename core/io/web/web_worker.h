// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/io/web/web_protocol.h"

namespace relievo {

/// What a process that fetches has of a file.
struct FetchedBytes {
  WebEnd end = WebEnd::good;
  std::vector<std::byte> bytes;
  std::string why;
};

/// By GDAL's file systems. [worker process, any thread]
FetchedBytes fetched(const std::string& name, std::uint64_t first, std::uint32_t count);
/// Time limits and what GDAL would look for beside files. [worker process, before other threads]
void prepareFetching();

/// main() of relievo-import-web: answers a WebLink until that closes its end. @return exit status
int runWebWorker(int argc, char** argv);

}  // namespace relievo
