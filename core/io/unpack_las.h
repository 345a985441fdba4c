// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/base/task.h"

namespace relievo {

/// An installed program that unpacks LAZ and COPC files.
struct LasUnpacker {
  enum class Kind { laszip, pdal };
  Kind kind = Kind::laszip;
  std::filesystem::path program;
};

/// The first of laszip, laszip64 and pdal that a folder of PATH holds. [any thread]
std::optional<LasUnpacker> findLasUnpacker();

/// A LAZ or COPC file unpacked to LAS, in a folder of its own that is removed with this object,
/// whatever happened. Put where TMPDIR says.
class UnpackedLas {
 public:
  /// Runs the program and waits for it; looks at the stop token every 50 ms and then ends the
  /// program and all it started. [worker]
  /// @throw FileError  no such program is installed, no room for the points, or the program fails
  /// @throw Cancelled
  UnpackedLas(const std::filesystem::path& packed, const Task& task);
  ~UnpackedLas();
  UnpackedLas(const UnpackedLas&) = delete;
  UnpackedLas& operator=(const UnpackedLas&) = delete;

  const std::filesystem::path& file() const noexcept { return file_; }

 private:
  void makeFolder(const std::filesystem::path& packed);
  void unpack(const std::filesystem::path& packed, const LasUnpacker& unpacker, const Task& task);

  std::filesystem::path folder_, file_;
};

}  // namespace relievo
