// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/export/write_cloud.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "core/file/atomic_file.h"
#include "core/io/file_check.h"

namespace relievo {
namespace {

static_assert(std::endian::native == std::endian::little, "records are written as stored");

constexpr std::size_t kPointsAtOnce = 1U << 15U;  ///< Between two looks at the stop token.
constexpr std::size_t kStatePiece = 200;

class CloudWriter {
 public:
  CloudWriter(const OutputFile& file, const Scan& scan, const CloudNotes& notes, const Task& task)
      : shown_(file.path),
        scan_(scan),
        notes_(notes),
        task_(task),
        file_(file),
        out_(file_.path(), std::ios::binary | std::ios::trunc),
        exact_(scan.origin == FilePoint{}),
        some_without_colour_(std::any_of(scan.colours.begin(), scan.colours.end(),
                                         [](const Rgba& c) { return c[3] != 255; })),
        intensities_(!scan.intensities.empty() && scan.info.intensity),
        parts_(!scan.parts.empty() && scan.info.parts.size() > 1) {
    if (!out_) cannotWrite(shown_, std::strerror(errno));
  }

  void write() {
    flush(header());
    std::string block;
    for (std::size_t i = 0; i < scan_.points.size(); ++i) {
      addPoint(i, block);
      if ((i + 1) % kPointsAtOnce == 0) flush(block);
    }
    for (std::size_t t = 0; t < scan_.triangles.size(); ++t) {
      add(std::uint8_t{3}, block);
      for (const std::uint32_t corner : scan_.triangles[t]) {
        add(static_cast<std::int32_t>(corner), block);
      }
      if ((t + 1) % kPointsAtOnce == 0) flush(block);
    }
    flush(block);
    out_.close();
    if (!out_) cannotWrite(shown_, "the disk is full or failed");
    file_.commit();
  }

 private:
  std::string header() const {
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    if (scan_.info.unit) text.append("comment unit ").append(name(*scan_.info.unit)) += "\n";
    if (parts_) {
      for (std::size_t i = 0; i < scan_.info.parts.size(); ++i) {
        text += "comment part " + std::to_string(i) + " " +
                printable(scan_.info.parts[i].name).substr(0, kStatePiece) + "\n";
      }
    }
    for (std::size_t at = 0; at < notes_.state.size(); at += kStatePiece) {
      text.append(kCloudStateWords).append(notes_.state, at, kStatePiece) += "\n";
    }
    text += "element vertex " + std::to_string(scan_.points.size()) + "\n";
    const std::string type = exact_ ? "float" : "double";
    for (const char* axis : {" x", " y", " z"}) text += "property " + type + axis + "\n";
    const auto properties = [&text](bool there, std::initializer_list<const char*> lines) {
      for (const char* line : lines) {
        if (there) text.append("property ").append(line) += "\n";
      }
    };
    properties(!notes_.normals.empty(), {"float nx", "float ny", "float nz"});
    properties(!scan_.colours.empty(), {"uchar red", "uchar green", "uchar blue"});
    properties(some_without_colour_, {"uchar alpha"});
    properties(intensities_, {"float intensity"});
    properties(!scan_.classes.empty(), {"uchar classification"});
    properties(!scan_.returns.empty(), {"uchar return_number", "uchar number_of_returns"});
    properties(parts_, {"uchar part"});
    if (!scan_.triangles.empty()) {
      text += "element face " + std::to_string(scan_.triangles.size()) +
              "\nproperty list uchar int vertex_indices\n";
    }
    return text + "end_header\n";
  }

  template <class T>
  static void add(const T& value, std::string& block) {
    block.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }

  void addPoint(std::size_t i, std::string& block) const {
    if (exact_) {
      add(scan_.points[i], block);
    } else {
      add(scan_.point(i), block);
    }
    if (!notes_.normals.empty()) add(notes_.normals[i], block);
    if (!scan_.colours.empty()) {
      const Rgba& colour = scan_.colours[i];
      for (std::size_t c = 0; c < (some_without_colour_ ? 4U : 3U); ++c) add(colour[c], block);
    }
    if (intensities_) {
      const auto [low, high] = *scan_.info.intensity;
      add(static_cast<float>(low + (high - low) * scan_.intensities[i] / 65535), block);
    }
    if (!scan_.classes.empty()) add(scan_.classes[i], block);
    if (!scan_.returns.empty()) {
      const unsigned packed = scan_.returns[i];
      add(static_cast<std::uint8_t>(packed & 15U), block);
      add(static_cast<std::uint8_t>(packed >> 4U), block);
    }
    if (parts_) add(scan_.parts[i], block);
  }

  void flush(const std::string& block) {
    task_.check();
    out_.write(block.data(), static_cast<std::streamsize>(block.size()));
    if (!out_) cannotWrite(shown_, std::strerror(errno));
  }
  void flush(std::string& block) {
    flush(static_cast<const std::string&>(block));
    block.clear();
  }

  std::filesystem::path shown_;
  const Scan& scan_;
  const CloudNotes& notes_;
  const Task& task_;
  AtomicFile file_;
  std::ofstream out_;
  bool exact_, some_without_colour_, intensities_, parts_;
};
static_assert(sizeof(FilePoint) == 3 * sizeof(double));

}  // namespace

void writeCloud(const OutputFile& file, const Scan& scan, const CloudNotes& notes,
                const Task& task) {
  CloudWriter(file, scan, notes, task).write();
}

}  // namespace relievo
