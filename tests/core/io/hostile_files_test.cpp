// SPDX-License-Identifier: BSD-3-Clause
// Odd, broken and lying files: each loads as it must, or is refused with a sentence. A crash or a
// hang of the worker would show as the wrong sentence, one of this process as a failed test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/io/import.h"
#include "tests/core/io/file_cases.h"
#include "tests/core/io/sample_files.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

using namespace test;
using namespace std::string_literals;

class HostileFiles : public FileCases {};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// More than any header may have.
std::string manyComments() {
  std::string lines;
  while (lines.size() < (2U << 20U)) lines += "comment\n";
  return lines;
}

const std::string kLe = "binary_little_endian";
const std::string kNanRow = "nan 1 2\n1 inf 2\n";

TEST_F(HostileFiles, PlyHeaders) {
  const std::string rows = textRows(10);
  check({
      loads("good.ply", plyHeader("ascii", "10") + rows, 10),
      refused("magic_only.ply", "ply\n", "no end"),
      refused("cut_header.ply", plyHeader("ascii", "10").substr(0, 60), "no end"),
      refused("huge_count.ply", plyHeader(kLe, "4000000000") + binaryRows<float>(10), "ends at 10"),
      refused("huger_count.ply", plyHeader(kLe, "100000000000000000000") + rows, "usable count"),
      refused("negative_count.ply", plyHeader(kLe, "-5") + rows, "usable count"),
      refused("zero_count.ply", plyHeader("ascii", "0"), "0 points, none finite"),
      refused("no_format.ply", replaced(plyHeader("ascii", "10"), "format ascii 1.0\n", "") + rows,
              "no format"),
      refused("odd_format.ply", plyHeader("binary_middle_endian", "10") + rows, "known format"),
      refused("unknown_type.ply", plyHeader("ascii", "10", "quaternion") + rows, "unknown type"),
      refused("no_xyz.ply",
              replaced(replaced(plyHeader("ascii", "10"), " x\n", " a\n"), " y\n", " b\n") + rows,
              "no x coordinate"),
      refused("list_for_x.ply",
              replaced(plyHeader("ascii", "10"), "float x", "list uchar float x") + rows,
              "no x coordinate"),
      refused("float_list_length.ply",
              plyHeader("ascii", "10", "float",
                        "element face 1\nproperty list float int vertex_indices\n") +
                  rows,
              "whole-number length"),
      refused("two_x.ply", plyHeader("ascii", "10", "float", "property float x\n") + rows,
              "second time"),
      refused("orphan_property.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n1\n",
              "no element"),
      refused("no_vertices.ply", "ply\nformat ascii 1.0\nelement face 0\nend_header\n",
              "no vertices"),
      refused("long_line.ply", "ply\nformat ascii 1.0\ncomment " + std::string(100000, 'x') + "\n",
              "too long"),
      refused("endless_header.ply", "ply\nformat ascii 1.0\n" + manyComments(), "no end"),
      loads("crlf.ply", replaced(plyHeader("ascii", "10") + rows, "\n", "\r\n"), 10),
      loads("cr.ply", replaced(plyHeader("ascii", "10") + rows, "\n", "\r"), 10),
      loads("cr_binary.ply", replaced(plyHeader(kLe, "10"), "\n", "\r") + binaryRows<float>(10),
            10),
      refused("mixed_line_ends.ply",
              replaced(plyHeader(kLe, "10"), " z\n", " z\r") + binaryRows<float>(10),
              "mixes kinds of line ends"),
      loads("crlf_binary.ply", replaced(plyHeader(kLe, "10"), "\n", "\r\n") + binaryRows<float>(10),
            10),
      refused("steers_the_terminal.ply",
              "ply\nformat ascii 1.0\nelement \x1B[2J\xC2\x9B\xFF 10\nelement \x1B[2J\n",
              "(\"element ?[2J\")"),
      loads("comments.ply",
            replaced(plyHeader("ascii", "10"), "comment", "obj_info of a test\ncomment") + rows,
            10),
  });
}

TEST_F(HostileFiles, PlyBodies) {
  const std::string header = plyHeader("ascii", "10");
  const std::string mesh = plyHeader(kLe, "10", "float", kPlyFaces) + binaryRows<float>(10);
  check({
      refused("cut_body.ply", plyHeader(kLe, "10") + binaryRows<float>(10).substr(0, 50),
              "header promises 10 points, file ends at 4"),
      refused("short_text.ply", header + textRows(7), "file ends at 7"),
      refused("cut_text_row.ply", header + textRows(6) + "6 3.0", "file ends at 6"),
      refused("word.ply", header + textRows(5) + "five 1 2\n" + textRows(4), "line 14"),
      refused("comma.ply", header + replaced(textRows(10), ".", ","), "three coordinates"),
      refused("short_row.ply", header + textRows(5) + "1 2\n" + textRows(4), "too few numbers"),
      loads("nan_rows.ply", header + textRows(8) + kNanRow, 10),
      loads("integers.ply", plyHeader(kLe, "10", "short") + binaryRows<std::int16_t>(10), 10),
      loads("vertex_list.ply",
            plyHeader(kLe, "2", "float", "property list uchar int neighbours\n") +
                binaryRows<float>(1) + "\2"s + bytesOf(7) + bytesOf(8) + binaryRows<float>(1) +
                "\0"s,
            2),
      refused("vertex_list_huge.ply",
              plyHeader(kLe, "2", "float", "property list int int neighbours\n") +
                  binaryRows<float>(1) + bytesOf(2147483647),
              "file ends at 0"),
      refused("vertex_list_negative.ply",
              plyHeader(kLe, "2", "float", "property list int int neighbours\n") +
                  binaryRows<float>(1) + bytesOf(-2),
              "length -2"),
      loads("faces.ply", mesh + plyTriangles({0, 1, 2, 2, 3, 4}), 10),
      loads("faces_out_of_range.ply", mesh + plyTriangles({0, 1, 999999, -1, 3, 4}), 10),
      refused("faces_count_255.ply", mesh + "\xFF"s + plyTriangles({0, 1, 2, 2, 3, 4}),
              "promises 2 faces, file ends at 0"),
      refused("faces_missing.ply", mesh, "promises 2 faces, file ends at 0"),
      refused("faces_huge.ply",
              plyHeader(kLe, "10", "float",
                        "element face 1000000000000\nproperty list uchar int vertex_indices\n") +
                  binaryRows<float>(10) + plyTriangles({0, 1, 2, 2, 3, 4}),
              "promises 1 000 000 000 000 faces, file ends at 2"),
      loads("camera_first.ply",
            "ply\nformat ascii 1.0\nelement camera 1\nproperty float f\nelement vertex 2\n"
            "property float x\nproperty float y\nproperty float z\nend_header\n9\n1 2 3\n4 5 6\n",
            2),
      loads("trailing_bytes.ply", plyHeader(kLe, "10") + binaryRows<float>(10) + "rest", 10),
  });
}

TEST_F(HostileFiles, Pcd) {
  const std::string rows = textRows(10);
  const std::string binary = binaryRows<float>(10);
  const auto with_words = [](auto change) {
    PcdWords words;
    change(words);
    return pcdHeader(words);
  };
  const std::string good = pcdHeader({});
  check({
      loads("good.pcd", good + rows, 10),
      loads("crlf.pcd", replaced(good + rows, "\n", "\r\n"), 10),
      loads("binary.pcd", with_words([](PcdWords& w) { w.data = "binary"; }) + binary, 10),
      loads("crlf_binary.pcd",
            replaced(with_words([](PcdWords& w) { w.data = "binary"; }), "\n", "\r\n") + binary,
            10),
      refused("cr_binary.pcd",
              replaced(with_words([](PcdWords& w) { w.data = "binary"; }), "\n", "\r") + binary,
              "CR alone"),
      refused("header_only.pcd", good, "file ends at 0"),
      refused("cut_header.pcd", good.substr(0, 100), "no end"),
      refused("cut_binary.pcd",
              with_words([](PcdWords& w) { w.data = "binary"; }) + binary.substr(0, 65),
              "promises 10 points, file ends at 5"),
      refused("huge_count.pcd", with_words([](PcdWords& w) {
                                  w.data = "binary";
                                  w.points = "4000000000";
                                }) + binary,
              "file ends at 10"),
      refused("size_and_points.pcd", with_words([](PcdWords& w) { w.width = "7"; }) + rows,
              "7 x 1"),
      refused("negative_width.pcd", with_words([](PcdWords& w) { w.width = "-10"; }) + rows,
              "usable WIDTH"),
      refused("overflow.pcd", with_words([](PcdWords& w) {
                                w.width = "1099511627776";
                                w.height = "1099511627776";
                              }) + rows,
              "impossible number of points"),
      loads("nan_rows.pcd", good + textRows(8) + kNanRow, 10),
      refused("word.pcd", good + "zero 1 2\n" + textRows(9), "three coordinates"),
      refused("short_row.pcd", good + "1 2\n" + textRows(9), "fewer numbers"),
      refused("size_missing.pcd", with_words([](PcdWords& w) { w.size = "4 4"; }) + rows,
              "SIZE, TYPE and COUNT"),
      refused("size_three.pcd", with_words([](PcdWords& w) { w.size = "3 4 4"; }) + rows,
              "impossible SIZE"),
      refused("count_huge.pcd", with_words([](PcdWords& w) { w.count = "1 1 4000000000"; }) + rows,
              "impossible COUNT"),
      refused("count_negative.pcd", with_words([](PcdWords& w) { w.count = "1 1 -1"; }) + rows,
              "impossible COUNT"),
      refused("zero_points.pcd", with_words([](PcdWords& w) { w.points = "0"; }), "none finite"),
      refused("zero_points_binary.pcd", with_words([](PcdWords& w) {
                w.points = "0";
                w.data = "binary";
              }),
              "none finite"),
      refused("no_z.pcd", with_words([](PcdWords& w) { w.fields = "x y i"; }) + rows,
              "no single field z"),
      refused("no_data.pcd", replaced(good, "DATA ascii\n", "") + rows, "has no end"),
      refused("compressed_noise.pcd", with_words([](PcdWords& w) {
                                        w.data = "binary_compressed";
                                      }) + std::string(300, '\x5A'),
              "compressed data hold"),
      refused("compressed_cut.pcd",
              with_words([](PcdWords& w) { w.data = "binary_compressed"; }) +
                  bytesOf(std::uint32_t{1000}) + bytesOf(std::uint32_t{120}) + binary,
              "compressed data are cut"),
      refused("compressed_lie.pcd",
              with_words([](PcdWords& w) { w.data = "binary_compressed"; }) +
                  bytesOf(std::uint32_t{120}) + bytesOf(std::uint32_t{120}) +
                  std::string(120, '\xFF'),
              "cannot be decoded"),
      loads("header_words_as_points.pcd",
            with_words([](PcdWords& w) {
              w.data = "binary";
              w.points = "6";
            }) + "# .7 - Points\nFIELDS  \nxz y\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
                std::string(20, '9'),
            6),
      refused("compressed_beyond_lzf.pcd",
              with_words([](PcdWords& w) {
                w.data = "binary_compressed";
                w.points = "1000000";
              }) + bytesOf(std::uint32_t{1000}) +
                  bytesOf(std::uint32_t{12000000}) + std::string(1000, 'A'),
              "compressed data hold"),
      refused("noise.pcd", std::string("# .PCD v0.7\n") + std::string(200, '\xF3'), "header"),
      loads("wide_numbers.pcd",
            with_words([](PcdWords& w) {
              w.data = "binary";
              w.points = "1";
              w.fields = "t x y z";
              w.size = "8 4 4 4";
              w.type = "U F F F";
              w.count = "1 1 1 1";
            }) + bytesOf(std::uint64_t{1} << 60U) +
                bytesOf(1.0F) + bytesOf(2.0F) + bytesOf(3.0F),
            1),
  });
}

TEST_F(HostileFiles, Obj) {
  const std::string v = "v 0 0 0\nv 1 0 0.5\nv 0 1 0.25\nv 1 1 1\n";
  check({
      loads("good.obj", v + "f 1 2 3\nf 2 4 3\n", 4),
      loads("cut.obj", v.substr(0, v.size() - 1), 4),
      refused("short_v.obj", "v 0 0 0\nv 1 2\n", "line 2"),
      refused("word_v.obj", "v 0 0 0\nv one 2 3\n", "line 2"),
      refused("comma.obj", "v 0,5 1,5 2,5\n", "line 1"),
      loads("face_out_of_range.obj",
            v + "f 1 2 99\nf 0 1 2\nf -1 -2 -9\nf 1 2 1" + std::string(30, '0') + "\nf 1 2 3\n", 4),
      refused("face_words.obj", v + "f a b c\n", "no number"),
      loads("face_slashes.obj", v + "f 1/1/1 2/1/1 3/1/1\nf 2//9 3//9 4//9\n", 4),
      loads("face_degenerate.obj", v + "f 1 1 1\nf 1 2\nf\n", 4),
      loads("not_finite.obj", v + "v nan 1 2\nv 1e400 1 2\n", 6),
      loads("missing_library.obj", "mtllib absent.mtl\nusemtl none\n" + v, 4),
      loads("colours.obj", "v 0 0 0 0.5 0.5 0.5\nv 1 1 1 0.1 0.2 0.3\n", 2),
      loads("crlf.obj", replaced(v + "f 1 2 3\n", "\n", "\r\n"), 4),
      loads("continued.obj", "v 0 0 \\\n0\nv 1 \\\n2 \\\n3\nf 1 \\\n 2 1\n", 2),
      loads("backslash_at_end.obj", v + "f 1 2 3 \\", 4),
      refused("long_line.obj", v + "f" + std::string(2 << 20U, ' ') + "1 2 3\n", "1 MB"),
      refused("normals_only.obj", "vn 0 0 1\nvn 0 1 0\n", "no vertices"),
      refused("noise.obj", "v \x01\x02\x03 zzz\n"s, "neither text"),
  });
}

TEST_F(HostileFiles, Stl) {
  check({
      loads("good.stl", binaryStl(2, 2), 6),
      loads("ascii.stl", asciiStl(), 6),
      loads("solid_binary.stl", binaryStl(2, 2, "solid but binary"), 6),
      loads("trailing_bytes.stl", binaryStl(2, 2) + "rest", 6),
      loads("wrong_name.ply", binaryStl(2, 2), 6),
      refused("cut.stl", binaryStl(4, 4).substr(0, 84 + 170), "promises 12 points, file ends at 9"),
      refused("huge_count.stl", binaryStl(4000000000U, 2), "file ends at 6"),
      refused("zero.stl", binaryStl(0, 0), "0 triangles"),
      refused("cut_ascii.stl", asciiStl().substr(0, 150), "endsolid"),
      refused("short.stl", std::string(40, 'x'), "shorter than the header"),
      refused("words.stl", "solid\n" + std::string(200, 'x') + "\nendsolid\n", "line 2"),
      refused("no_facets.stl", "solid tile\nendsolid tile\n", "0 triangles"),
      refused("two_corners.stl", replaced(asciiStl(), "   vertex 0 1 0.25\n", ""), "line 6"),
      refused("word.stl", replaced(asciiStl(), "0.75", "three"), "line 12"),
      loads("capitals.stl",
            "SOLID A\rFACET NORMAL 0 0 1 OUTER LOOP\rVERTEX 0 0 0 VERTEX\r1 0 0 "
            "VERTEX 0 1 0 ENDLOOP ENDFACET\rENDSOLID solid facet\r",
            3),
      loads("two_solids.stl", asciiStl() + "\n" + asciiStl(), 12),
  });
}

TEST_F(HostileFiles, ThingsThatAreNoScan) {
  const std::string binary("\0\1\2\3\4\5\6\7", 8);
  check({
      refused("picture.ply", "\xFF\xD8\xFF\xE0"s + std::string(100, '\0'), "JPEG picture"),
      refused("pointer.ply", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n",
              "Git LFS pointer"),
      refused("page.xyz", "<!DOCTYPE html><html><body>404</body></html>", "web page"),
      refused("map.tif", "II*\0\x08\0\0\0"s + std::string(60, '\0'), "TIFF raster"),
      refused("grid.asc", "ncols 4\nnrows 4\n1 2 3 4\n", "ESRI ASCII grid"),
      refused("archive.xyz", "PK\x03\x04"s + binary, "ZIP archive"),
      refused("wide.xyz", "\xFF\xFE"s + "1\0 \0"s, "UTF-16"),
      refused("noise.xyz", binary + binary, "neither text"),
      refused("noise.las", binary + binary, "damaged"),
      refused("empty.ply", "", "empty"),
      refused("one_byte.ply", "p", "start with"),
      refused("prose.txt", "The quick brown fox\njumps over the lazy dog\n", "line 2"),
      refused("one_number.txt", "7\n", "promises 7 points"),
      refused("comments.txt", "# nothing\n// here\n\n", "no rows of numbers"),
      refused("nan_only.xyz", "nan nan nan\nnan 1 2\n", "2 points, none finite"),
      loads("one_point.xyz", "1 2 3\n", 1),
      loads("all_equal.xyz", "1 2 3\n1 2 3\n1 2 3\n", 3),
      loads("huge_numbers.xyz", "1e30 -1e30 5\n1e308 0 0\n1e999 0 0\n1 2 3\n", 4),
  });
}

/// Cuts, flips, deletes and inserts bytes of good files: anything may come out of it but a crash
/// of this process, a hang, or a message without words.
TEST_F(HostileFiles, RandomDamageIsLoadedOrRefused) {
  PcdWords binary_pcd;
  binary_pcd.data = "binary";
  const std::vector<std::pair<std::string, std::string>> seeds{
      {"mutant.ply", plyHeader(kLe, "10", "float", kPlyFaces) + binaryRows<float>(10) +
                         plyTriangles({0, 1, 2, 2, 3, 4})},
      {"mutant.pcd", pcdHeader(binary_pcd) + binaryRows<float>(10)},
      {"mutant.obj", "v 0 0 0\nv 1 0 0.5\nv 0 1 0.25\nf 1 2 3\nf 1/1/1 2//2 -1\n"},
      {"mutant.stl", binaryStl(3, 3)},
      {"mutant.xyz", textRows(10)},
      {"mutant.ptx",
       "5\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n" + textRows(10)},
      {"mutant.3ds", "MM"s + bytesOf(151U) + "==" + bytesOf(145U) + "\0@"s + bytesOf(139U) + "\0"s +
                         "\0A"s + bytesOf(132U) + "\x10\x41"s + bytesOf(126U) + "\x0A\0"s +
                         binaryRows<float>(10)},
  };
  constexpr unsigned kSeed = 2026;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  for (int round = 0; round < 140; ++round) {
    auto [name, bytes] = seeds[static_cast<std::size_t>(round) % seeds.size()];
    for (auto n = 1 + random() % 3; n > 0 && bytes.size() > 1; --n) {
      const std::size_t at = random() % bytes.size();
      switch (random() % 4) {
        case 0:
          bytes.resize(at + 1);
          break;
        case 1:
          bytes[at] = static_cast<char>(random());
          break;
        case 2:
          bytes.erase(at, 1 + random() % 4);
          break;
        default:
          bytes.insert(at, 1 + random() % 4, static_cast<char>(random()));
      }
    }
    if (bytes.empty()) continue;
    const std::filesystem::path file = folder_.write(name, bytes);
    try {
      const Scan scan = importScan(file);
      EXPECT_GT(scan.points.size(), 0U);
    } catch (const FileError& error) {
      EXPECT_THAT(error.what(), ::testing::StartsWith("Cannot read mutant"));
    }
  }
}

}  // namespace
}  // namespace relievo
