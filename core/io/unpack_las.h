// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "core/base/task.h"
#include "core/io/owned_fd.h"
#include "core/io/spawn.h"

namespace relievo {

struct LasHeader;

/// What the header of a LAZ or COPC file says of the LAS file it unpacks to.
/// @throw FileError  as parseLasHeader
LasHeader packedLasHeader(const std::filesystem::path& packed);

/// An installed program that unpacks LAZ and COPC files.
struct LasUnpacker {
  enum class Kind { laszip, pdal };
  Kind kind = Kind::laszip;
  std::filesystem::path program;
};

/// The first of laszip, laszip64 and pdal that a folder of PATH holds. [any thread]
std::optional<LasUnpacker> findLasUnpacker();

/// A LAZ or COPC file that is being unpacked to LAS, in a folder of its own that is removed with
/// this object, whatever happened; the program is ended then if it still runs. Put where TMPDIR
/// says. The file grows from its beginning, so that its first points can be read while the last are
/// unpacked; only counts and bounds of its header may come last: take the packed file's.
class UnpackedLas {
 public:
  /// Starts the program. [worker]
  /// @param task  whose stop token every wait looks at, also later ones, at least every 50 ms
  /// @throw FileError  no such program is installed, or no room for the points
  /// @throw Cancelled
  UnpackedLas(const std::filesystem::path& packed, const Task& task);
  ~UnpackedLas();
  UnpackedLas(const UnpackedLas&) = delete;
  UnpackedLas& operator=(const UnpackedLas&) = delete;

  /// It exists after the first wait.
  const std::filesystem::path& file() const noexcept { return file_; }

  /// Waits until the file has its first `bytes` bytes, or is whole and has fewer. [any thread]
  /// @return  false: it has fewer
  /// @throw FileError  the program fails; Cancelled: it is ended
  bool waitFor(std::uint64_t bytes);
  /// Waits until the file is whole, and says how far it is. [worker] @throw FileError, Cancelled
  void waitForAll(const Task& task);

 private:
  void makeFolder();
  void start(const LasUnpacker& unpacker);
  /// Looks at the program for at most 50 ms. @return  whether it has ended well
  bool hasEnded();
  void end();
  std::uint64_t bytesNow() const;

  std::filesystem::path packed_, folder_, file_, program_;
  Task task_;                         ///< Stops, but tells no progress.
  std::uint64_t expected_bytes_ = 0;  ///< 0: not known.
  std::mutex mutex_;                  ///< Of all below.
  ChildProcess child_;
  OwnedFd words_;     ///< What the program says.
  std::string said_;  ///< The last of it.
  bool ended_ = false;
  std::string failure_;  ///< Why it is not whole, once it has ended.
};

}  // namespace relievo
