// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/io/format.h"
#include "core/io/formats/pcd_header.h"
#include "core/io/formats/ply_header.h"
#include "core/io/import.h"

namespace relievo {

/// Above it PCL's time for PLY, 4 to 13 times ours, is no longer small.
inline constexpr std::uint64_t kMostPclPlyPoints = 2'000'000;

// Why PCL must not read this file, for a sentence "PCL is not used for FILE: <reason>."; empty
// where it reads it right. docs/adr/0085-pcl-is-the-loader.md
std::string whyNotPcl(const PlyHeader& header);
std::string whyNotPcl(const PcdHeader& header);
std::string whyNotPcl(FileFormat format);  ///< Of formats without such a header.

/// Is it PCL that reads? @throw ArgumentError  PCL was asked for, and there is a reason not to
bool usesPcl(ReaderChoice choice, const std::string& why_not, const std::filesystem::path& file);

}  // namespace relievo
