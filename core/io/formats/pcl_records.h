// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "core/io/formats/pcd_header.h"
#include "core/io/formats/ply_header.h"
#include "core/io/point_columns.h"

namespace relievo {

/// What PCL read: so many points, valid until it returns. May throw.
using TakeColumns = std::function<void(const PointColumns& columns, std::uint64_t count)>;

/// PCL's readers, called on bodies only: our headers say what is in them, because those of PCL go
/// astray. Null in programs that do not link them.
struct PclLibrary {
  const char* name = nullptr;  ///< "PCL 1.13.0"

  /// Complete binary records of a PCD file, block by block.
  /// @return  false if PCL gave up; what was given before is of no use
  bool (*pcd_records)(const PcdHeader& header, std::string_view records, std::uint64_t count,
                      const TakeColumns& take) = nullptr;
  /// A compressed body whose two sizes were checked: against its bytes, and header.points records.
  /// @return  false if it cannot be unpacked
  bool (*pcd_compressed)(const PcdHeader& header, std::string_view body,
                         const TakeColumns& take) = nullptr;
  /// Complete binary records of PLY points. @return  as of pcd_records
  bool (*ply_records)(const PlyHeader& header, std::string_view records, std::uint64_t count,
                      const TakeColumns& take) = nullptr;
};

/// All of it; only in the program that loads PCL whole.
const PclLibrary& pclLibrary();
/// Its parser of PLY, a library of its own that needs no other; null for PCD.
const PclLibrary& pclPlyLibrary();

}  // namespace relievo
