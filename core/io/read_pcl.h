// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

namespace relievo {

class ScanBuilder;

/// Points of a binary PLY file whose header and size were checked. @throw FileError
void readPlyPointsByPcl(const std::filesystem::path& file, std::uint64_t expected,
                        ScanBuilder& builder);

/// Points of a binary or compressed PCD file whose header and size were checked.
/// @throw FileError
void readPcdPointsByPcl(const std::filesystem::path& file, std::uint64_t expected,
                        ScanBuilder& builder);

}  // namespace relievo
