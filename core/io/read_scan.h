// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/io/formats/pcl_records.h"
#include "core/io/import.h"
#include "core/io/point_sink.h"
#include "core/message/message.h"

namespace relievo {

/// See texture_file.h.
using LoadTexture = std::optional<Texture> (*)(const std::filesystem::path& file,
                                               std::uint64_t most_texels,
                                               std::optional<Message>& reason);

/// What a program reads by large libraries; null where it has none.
struct ReadLibraries {
  const PclLibrary* pcl = nullptr;  ///< Reads where it may and is not unwanted.
  LoadTexture load_texture = nullptr;
};

/// What every reader gets: the file mapped into memory, and what the caller wants of it.
struct ReadJob {
  const std::filesystem::path& file;
  std::string_view bytes;
  const ImportOptions& options;
  const Task& task;
  const PclLibrary* pcl = nullptr;     ///< Null in programs without it.
  LoadTexture load_texture = nullptr;  ///< The same.
  PointSink* sink = nullptr;           ///< Null: the scan keeps its points.
};

// One function per format, each in its own file; all throw FileError. They run in the worker.
Scan readPly(const ReadJob& job);
Scan readPcd(const ReadJob& job);
Scan readObj(const ReadJob& job);
Scan readStl(const ReadJob& job);
Scan readText(const ReadJob& job);
Scan read3ds(const ReadJob& job);
Scan readLas(const ReadJob& job);
Scan readE57(const ReadJob& job);
Scan readPtx(const ReadJob& job);

/// Chooses the reader by content and name, and reads in this process. importScan does the same in
/// a child with limits. @param sink  takes the points of scans that hold nothing but points; these
/// then have none, though `info` tells of them; null: nobody does @throw FileError
Scan readScanHere(const std::filesystem::path& file, const ImportOptions& options, const Task& task,
                  const ReadLibraries& libraries = {}, PointSink* sink = nullptr);

/// "Cannot read NAME: <reason> <advice>" (cannot_read), of rows of catalogue_read.inc.
[[noreturn]] void throwReadError(const std::filesystem::path& file, Message reason, Message advice);
/// The same for a reason that says itself what to do.
[[noreturn]] void throwReadError(const std::filesystem::path& file, Message reason);

/// Code of the refusal of a choice that the file does not offer; importScan throws an
/// ArgumentError.
inline constexpr const char* kMisuse = "misuse";

/// Does ImportOptions::parts name only scans that a file of so many has? @throw FileError  kMisuse
void checkParts(const ReadJob& job, std::size_t count);
/// Is the scan of this index (from 0) to be read?
bool isWantedPart(const ReadJob& job, std::size_t index);

/// What a header counts.
enum class RecordKind : std::uint8_t { points, faces, bytes };

/// A file that ends before what its header promises.
struct Truncation {
  RecordKind records = RecordKind::points;
  std::uint64_t promised = 0;
  std::uint64_t found = 0;            ///< Complete ones.
  std::uint64_t complete_points = 0;  ///< What can be loaded with accept_incomplete.
};

/// With accept_incomplete a warning in `info`, else E101. @throw FileError
void handleTruncation(const Truncation& shortfall, const ReadJob& job, ScanInfo& info);

}  // namespace relievo
