// SPDX-License-Identifier: BSD-3-Clause
// The process's own side of inputFacts; that of its caller is in import.cpp.
#include "core/io/input_facts.h"

#include <cctype>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/io/file_check.h"
#include "core/io/format.h"
#include "core/io/formats/ply_header.h"
#include "core/io/point_reader.h"
#include "core/io/raster/tiff_head.h"
#include "core/io/worker/reader_guard.h"

namespace relievo {
namespace {

/// The finest level of a map by tiles, and no picture of one.
bool isTiledMap(const TiffHead& head) {
  const auto level = head.facts.find("RELIEVO_LEVEL");
  return level != head.facts.end() && level->second == "0" &&
         head.facts.contains("RELIEVO_LEVELS") && !head.facts.contains("RELIEVO_CONTENT");
}

/// map.json of a published map begins with its mark.
bool isPublishedMap(std::string_view head) {
  constexpr std::size_t kFirst = 64;
  return head.starts_with('{') &&
         head.substr(0, kFirst).find("\"relievo_published_map\"") != std::string_view::npos;
}

void lookIntoPly(std::string_view head, const std::filesystem::path& file, InputFacts& facts) {
  facts.in_blocks = true;
  try {
    const PlyHeader header = parsePlyHeader(head, file);
    facts.in_blocks = bytesBeforePoints(header).has_value();
    facts.has_faces =
        header.face_element.has_value() && header.elements[*header.face_element].count > 0;
  } catch (const FileError&) {  // Whoever reads the points says what is wrong.
  }
}

/// As isHdf5Log of core/recording.
bool isHdf5(std::string_view head) {
  return head.starts_with("\x89HDF") || head.starts_with("relievo HDF5 recording; ");
}

/// A recording among the tables that carry a state: told by its first columns.
bool isLog(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".h5" || ending == ".hdf5") return true;
  if (ending != ".csv") return false;
  std::ifstream in(file, std::ios::binary);
  while (in.peek() == '#') in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  constexpr std::string_view kFirstColumns = "t_s,tick,";  // A stroke has others.
  std::string start(kFirstColumns.size(), '\0');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == kFirstColumns;
}

HostFileKind carrierKind(std::string_view head) {
  if (isHdf5(head) || head.starts_with("# relievo log")) return HostFileKind::recording;
  if (head.starts_with('#')) return HostFileKind::table;
  if (head.starts_with("PK\x03\x04")) return HostFileKind::package;
  if (head.starts_with('{')) return HostFileKind::project;
  const bool picture = head.starts_with("\x89PNG") || head.starts_with("%PDF-") ||
                       head.starts_with("<?xml") || head.starts_with("<svg");
  return picture ? HostFileKind::picture : HostFileKind::none;
}

}  // namespace

InputFacts inputFactsHere(const std::filesystem::path& file) {
  requireReadersAllowed("inputFactsHere");
  const std::uint64_t size = checkedFileSize(file);
  const std::string head = readHead(file, kMaxHeaderBytes);
  const FileFormat format =
      findFormat(std::string_view(head).substr(0, kSniffedBytes), file, size).format;
  InputFacts facts;
  facts.host_file = carrierKind(head);
  facts.is_hdf5 = isHdf5(head);
  facts.is_log = isLog(file);
  if (isReadableRaster(format)) facts.kind = InputKind::raster;
  if (isPublishedMap(head)) {
    facts.host_file = HostFileKind::none;
    facts.kind = InputKind::tiled_map;
    return facts;
  }
  if (const auto tiff = readTiffHead(file)) {
    facts.host_file = tiff->bands == 1 ? HostFileKind::none : HostFileKind::picture;
    if (isTiledMap(*tiff)) facts.kind = InputKind::tiled_map;
  }
  if (format == FileFormat::las || format == FileFormat::laz) facts.in_blocks = true;
  if (format == FileFormat::ply) lookIntoPly(head, file, facts);
  return facts;
}

}  // namespace relievo
