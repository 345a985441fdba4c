// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace relievo::test {

/// Bytes of a number, lowest first (or last, for files of the other byte order).
template <class T>
std::string bytesOf(T value, bool big_endian = false) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

/// `count` points (i, i / 2, i / 4): i from 0.
template <class T>
std::string binaryRows(int count, bool big_endian = false) {
  std::string rows;
  for (int i = 0; i < count; ++i) {
    for (const double divisor : {1.0, 2.0, 4.0}) {
      rows += bytesOf(static_cast<T>(i / divisor), big_endian);
    }
  }
  return rows;
}

inline std::string textRows(int count, const std::string& separator = " ") {
  std::string rows;
  for (int i = 0; i < count; ++i) {
    rows.append(std::to_string(i)).append(separator).append(std::to_string(i / 2.0));
    rows.append(separator).append(std::to_string(i / 4.0)).append("\n");
  }
  return rows;
}

inline std::string plyHeader(const std::string& encoding, const std::string& count,
                             const std::string& type = "float", const std::string& more = "") {
  return "ply\nformat " + encoding + " 1.0\ncomment made by a test\nelement vertex " + count +
         "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type + " z\n" + more +
         "end_header\n";
}

inline const std::string kPlyFaces = "element face 2\nproperty list uchar int vertex_indices\n";

/// Two triangles as binary PLY faces.
inline std::string plyTriangles(const std::array<std::int32_t, 6>& corners) {
  std::string bytes;
  for (std::size_t face = 0; face < 2; ++face) {
    bytes += '\3';
    for (std::size_t i = 0; i < 3; ++i) bytes += bytesOf(corners[3 * face + i]);
  }
  return bytes;
}

struct PcdWords {
  std::string data = "ascii";
  std::string points = "10";
  std::string fields = "x y z";
  std::string size = "4 4 4";
  std::string type = "F F F";
  std::string count = "1 1 1";
  std::string width = {};  ///< Empty: as points.
  std::string height = "1";
};

inline std::string pcdHeader(const PcdWords& words) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + words.fields +
         "\nSIZE " + words.size + "\nTYPE " + words.type + "\nCOUNT " + words.count + "\nWIDTH " +
         (words.width.empty() ? words.points : words.width) + "\nHEIGHT " + words.height +
         "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + words.points + "\nDATA " + words.data + "\n";
}

/// Binary STL of triangles that climb along x.
inline std::string binaryStl(std::uint32_t promised, int triangles,
                             const std::string& title = "made by a test") {
  std::string bytes = title;
  bytes.resize(80, ' ');
  bytes += bytesOf(promised);
  for (int i = 0; i < triangles; ++i) {
    for (int n = 0; n < 3; ++n) bytes += bytesOf(n == 2 ? 1.0F : 0.0F);
    for (int corner = 0; corner < 3; ++corner) {
      bytes += bytesOf(static_cast<float>(i + (corner == 1 ? 1 : 0)));
      bytes += bytesOf(corner == 2 ? 1.0F : 0.0F);
      bytes += bytesOf(0.25F);
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

inline std::string asciiStl() {
  return "solid tile\n"
         " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0.5\n"
         "   vertex 0 1 0.25\n  endloop\n endfacet\n"
         " facet normal 0 0 1\n  outer loop\n   vertex 1 0 0.5\n   vertex 1 1 0.75\n"
         "   vertex 0 1 0.25\n  endloop\n endfacet\n"
         "endsolid tile\n";
}

}  // namespace relievo::test
