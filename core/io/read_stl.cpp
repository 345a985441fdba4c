// SPDX-License-Identifier: BSD-3-Clause
// The only file that sees Assimp.
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cstring>
#include <string>

#include "core/base/error.h"
#include "core/io/lines.h"
#include "core/io/read_scan.h"
#include "core/io/scalar.h"
#include "core/io/scan_builder.h"

namespace relievo {
namespace {

constexpr std::size_t kHeader = 84;
constexpr std::size_t kTriangle = 50;

bool looksAscii(std::string_view bytes) {
  if (!trimmed(bytes.substr(0, 512)).starts_with("solid")) return false;
  const std::string_view head = bytes.substr(0, 4096);
  return head.find('\0') == std::string_view::npos;
}

/// The bytes that Assimp gets: for binary files as long as the count says, or the count made to
/// fit a cut file on request.
std::string checkedBinary(const ReadJob& job, ScanInfo& info) {
  if (job.bytes.size() < kHeader) {
    refuseScan(job.file, "it is shorter than the header of an STL file. Copy or export it again.");
  }
  const std::uint64_t promised = loadAs<std::uint32_t>(job.bytes.data() + 80, ByteOrder::little);
  const std::uint64_t found =
      std::min<std::uint64_t>(promised, (job.bytes.size() - kHeader) / kTriangle);
  if (promised == 0) refuseScan(job.file, "it holds 0 triangles. Choose another file.");
  if (found < promised) {
    handleShortfall({"points", 3 * promised, 3 * found, 3 * found}, job, info);
  } else if (job.bytes.size() > kHeader + found * kTriangle) {
    info.warnings.emplace_back("Bytes after the last triangle were ignored.");
  }
  std::string bytes(job.bytes.substr(0, kHeader + found * kTriangle));
  for (std::size_t i = 0; i < 4; ++i) bytes[80 + i] = static_cast<char>(found >> (8 * i) & 0xFFU);
  // Assimp takes "solid" at the start for text in some cases; the title is of no use here.
  std::fill(bytes.begin(), bytes.begin() + 80, ' ');
  return bytes;
}

void checkAscii(const ReadJob& job) {
  const std::string_view tail =
      job.bytes.substr(job.bytes.size() - std::min<std::size_t>(job.bytes.size(), 4096));
  if (tail.find("endsolid") == std::string_view::npos) {
    refuseScan(job.file, "it ends before \"endsolid\". It is incomplete; copy or export it again.");
  }
}

void take(const aiScene& scene, const ReadJob& job, ScanBuilder& builder) {
  std::uint64_t base = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    job.task.check();
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& p = mesh.mVertices[i];
      builder.addPoint(static_cast<double>(p.x), static_cast<double>(p.y),
                       static_cast<double>(p.z));
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      std::array<std::int64_t, 3> corners{};
      if (face.mNumIndices != 3) {
        refuseScan(job.file, "a face of it is no triangle. Export it again.");
      }
      for (std::size_t c = 0; c < 3; ++c) {
        corners[c] = static_cast<std::int64_t>(base + face.mIndices[c]);
      }
      builder.addFace(corners);
    }
    base += mesh.mNumVertices;
  }
}

}  // namespace

Scan readStl(const ReadJob& job) {
  ScanBuilder builder(job.file, job.options.max_points);
  const bool ascii = looksAscii(job.bytes) &&
                     (job.bytes.size() < kHeader ||
                      kHeader + kTriangle * std::uint64_t{loadAs<std::uint32_t>(
                                                job.bytes.data() + 80, ByteOrder::little)} !=
                          job.bytes.size());
  builder.info().format = ascii ? "STL ascii" : "STL binary";
  std::string binary;
  if (ascii) {
    checkAscii(job);
  } else {
    binary = checkedBinary(job, builder.info());
  }
  const std::string_view bytes = ascii ? job.bytes : std::string_view(binary);
  job.task.report("reading mesh", 0);
  Assimp::Importer importer;
  // No post-processing: vertices are not joined, three for each triangle as stored.
  const aiScene* const scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "stl");
  if (scene == nullptr) {
    refuseScan(job.file, std::string("its triangles cannot be read (") + importer.GetErrorString() +
                             "). Export it again.");
  }
  take(*scene, job, builder);
  return builder.finish();
}

}  // namespace relievo
