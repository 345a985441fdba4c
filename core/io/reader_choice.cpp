// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/reader_choice.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/io/file_check.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMostUnpackedBytes = 2ULL << 30;

bool isLongWhole(ScalarType type) {
  return type == ScalarType::i64 || type == ScalarType::u64;
}

}  // namespace

std::string whyNotPcl(const PlyHeader& header) {
  if (header.encoding == PlyEncoding::ascii) {
    return "it takes words and short rows of text for points at 0 0 0";
  }
  if (header.vertex_element != 0 || header.vertices().hasList()) {
    return "it moves or refuses points behind other records, or with lists";
  }
  const bool alone = std::all_of(header.elements.begin() + 1, header.elements.end(),
                                 [](const PlyElement& element) { return element.count == 0; });
  if (!alone) return "it breaks down on some faces, and keeps no more of them than its own header";
  if (header.vertices().count > kMostPclPlyPoints) {
    return "of more than " + grouped(kMostPclPlyPoints) +
           " points in PLY it takes many times as long";
  }
  return {};
}

std::string whyNotPcl(const PcdHeader& header) {
  if (header.encoding == PcdEncoding::ascii) {
    return "it takes words and short rows of text for points at 0 0 0";
  }
  const bool compressed = header.encoding == PcdEncoding::binary_compressed;
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    const bool used = std::find(header.xyz.begin(), header.xyz.end(), i) != header.xyz.end();
    if ((used || compressed) && isLongWhole(header.fields[i].type)) {
      return "whole numbers of 64 bits are not tried there";
    }
  }
  if (compressed && header.points * header.record_bytes > kMostUnpackedBytes) {
    return "it counts unpacked bytes above 2 GB wrongly";
  }
  return {};
}

std::string whyNotPcl(FileFormat format) {
  switch (format) {
    case FileFormat::obj:
      return "it rounds coordinates of OBJ files to float, half a metre far from zero";
    case FileFormat::stl:
      return "it reads STL through VTK, which takes damaged files without a word";
    default:
      return "it has no reader of this format";
  }
}

bool usesPcl(ReaderChoice choice, const std::string& why_not, const std::filesystem::path& file) {
  if (choice == ReaderChoice::own) return false;
  if (choice == ReaderChoice::pcl && !why_not.empty()) {
    throw ArgumentError("--reader pcl: PCL is not used for " + shownName(file) + ": " + why_not +
                        ". Nothing was loaded. Leave the option out, or give --reader own.");
  }
  return why_not.empty();
}

}  // namespace relievo
