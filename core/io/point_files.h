// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/io/import.h"
#include "core/io/point_stream.h"

namespace relievo {

/// The points of one file or of several as one source: a PointStream for each, under one numbering.
/// Of several files few are open at once, so that thousands do not take thousands of processes; who
/// opens them is a thread that lives as long as this object (docs/adr/0187).
class PointFiles {
 public:
  /// Reads the headers. @param files  in the order in which their points are counted
  /// @throw FileError  as PointStream; or two of them differ in unit or reference system
  explicit PointFiles(std::vector<std::filesystem::path> files, const ImportOptions& options = {},
                      const Task& task = {}, StreamedParts parts = StreamedParts::places);
  ~PointFiles();
  PointFiles(const PointFiles&) = delete;
  PointFiles& operator=(const PointFiles&) = delete;

  const std::vector<std::filesystem::path>& files() const noexcept;
  /// Of all together; of several, `file` is the first, and `parts` says how many points each has.
  const ScanInfo& info() const noexcept;

  // As those of PointStream, by the numbers of all files. Ranges may cross from one to the next.
  std::size_t read(std::uint64_t first, std::span<FilePoint> block) const;
  std::size_t read(std::uint64_t first, std::span<FilePoint> block,
                   std::span<StoredValues> values) const;
  void read(std::span<const PointRange> ranges, std::span<FilePoint> block) const;
  std::vector<PointRange> cheapSample(std::uint64_t points) const;

  /// Memory that the files which are open keep for so many threads that read.
  std::size_t keptBytes(int threads) const noexcept;

  /// Of several files only what all have in the same form.
  std::optional<ScalarType> colourType() const noexcept;
  std::optional<ScalarType> intensityType() const noexcept;
  bool hasWordIntensities() const noexcept;
  const std::string& colourSource() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
