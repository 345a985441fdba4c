// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "tests/core/io/file_cases.h"
#include "tests/core/io/refusal.h"
#include "tests/core/io/sample_files.h"

namespace relievo {
namespace {

using namespace test;
using namespace std::string_literals;

std::string chunk(std::uint16_t kind, const std::string& body) {
  return bytesOf(kind) + bytesOf(static_cast<std::uint32_t>(body.size() + 6)) + body;
}

std::string vertices(int count) {
  return chunk(0x4110, bytesOf(static_cast<std::uint16_t>(count)) + binaryRows<float>(count));
}

std::string face(std::uint16_t a, std::uint16_t b, std::uint16_t c) {
  return bytesOf(a) + bytesOf(b) + bytesOf(c) + bytesOf(std::uint16_t{7});
}

std::string faces(const std::string& records) {
  const auto count = static_cast<std::uint16_t>(records.size() / 8);
  return chunk(0x4120, bytesOf(count) + records);
}

std::string object(const std::string& mesh) {
  return chunk(0x4000, "tile\0"s + chunk(0x4100, mesh));
}

std::string model(const std::string& objects) {
  return chunk(0x4D4D, chunk(0x0002, bytesOf(std::uint32_t{3})) + chunk(0x3D3D, objects));
}

class Read3ds : public FileCases {
 protected:
  Scan load(const std::string& content, const ImportOptions& options = {}) {
    return importScan(folder_.write("model.3ds", content), options);
  }
};

TEST_F(Read3ds, VerticesAndFacesOfSeveralObjectsComeAsStored) {
  const Scan scan = load(model(object(vertices(4) + faces(face(0, 1, 2) + face(1, 3, 2))) +
                               object(vertices(3) + faces(face(2, 1, 0)))));
  EXPECT_EQ(scan.info.format, "3DS");
  EXPECT_EQ(scan.info.points, 7U);
  EXPECT_EQ(scan.info.faces, 3U);
  EXPECT_TRUE(scan.info.warnings.empty());
  EXPECT_EQ(scan.point(3), (FilePoint{3, 1.5, 0.75}));
  ASSERT_EQ(scan.triangles.size(), 3U);
  EXPECT_EQ(scan.triangles[1], (std::array<std::uint32_t, 3>{1, 3, 2}));
  EXPECT_EQ(scan.triangles[2], (std::array<std::uint32_t, 3>{6, 5, 4}));
}

TEST_F(Read3ds, FacesMayComeBeforeTheirVertices) {
  const Scan scan = load(model(object(faces(face(0, 1, 2)) + vertices(3))));
  ASSERT_EQ(scan.triangles.size(), 1U);
  EXPECT_EQ(scan.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST_F(Read3ds, AFaceMayNotReachIntoTheNextObject) {
  const Scan scan = load(model(object(vertices(3) + faces(face(0, 1, 4))) + object(vertices(3))));
  EXPECT_EQ(scan.info.dropped_faces, 1U);
  EXPECT_TRUE(scan.triangles.empty());
}

TEST_F(Read3ds, OtherChunksAreLeftAside) {
  const std::string content =
      chunk(0x4D4D, chunk(0xB000, std::string(30, 'k')) +
                        chunk(0x3D3D, chunk(0xAFFF, "material") + chunk(0x0100, bytesOf(1.0F)) +
                                          object(chunk(0x4160, std::string(48, '\1')) +
                                                 vertices(3) + chunk(0x4140, "uv"))));
  EXPECT_EQ(load(content).info.points, 3U);
}

TEST_F(Read3ds, ACutMeshLoadsInPartOnRequest) {
  const std::string whole = model(object(vertices(10)));
  const std::string cut = whole.substr(0, whole.size() - 30);
  const Refusal refusal = refusalOf([&] { load(cut); });
  EXPECT_EQ(refusal.code, "E101");
  ImportOptions options;
  options.accept_incomplete = true;
  const Scan scan = load(cut, options);
  EXPECT_EQ(scan.points.size(), 7U);
  EXPECT_EQ(scan.info.warnings.size(), 1U);
}

TEST_F(Read3ds, OddFilesLoadOrAreRefused) {
  const std::string good = model(object(vertices(4) + faces(face(0, 1, 2))));
  std::string zero_length = good;
  zero_length.replace(8, 4, std::string(4, '\0'));
  std::string huge_length = good;
  huge_length.replace(2, 4, bytesOf(std::uint32_t{0xFFFFFFFF}));
  std::string deep = vertices(3);
  for (int i = 0; i < 2000; ++i) deep = chunk(0x3D3D, deep);
  check({
      loads("good.3ds", good, 4),
      loads("good_by_content.bin", good, 4),
      refused("cut_head.3ds", good.substr(0, 9), "bytes, file ends at 9"),
      refused("cut_vertices.3ds", good.substr(0, good.size() - 60), "promises 4 points"),
      refused("cut_faces.3ds", good.substr(0, good.size() - 3), "promises 1 face,"),
      refused("cut_in_name.3ds", good.substr(0, 30), "bytes, file ends at 30"),
      refused("zero_length.3ds", zero_length, "chunks of a 3DS file"),
      refused("huge_length.3ds", huge_length, "promises 4 294 967 295 bytes"),
      refused("vertex_count_lies.3ds",
              model(object(chunk(0x4110, bytesOf(std::uint16_t{65535}) + binaryRows<float>(2)))),
              "promises 65 535 points, file ends at 2"),
      refused("no_mesh.3ds", model(""), "0 points, none finite"),
      refused("deep.3ds", chunk(0x4D4D, deep), "none finite"),
      refused("zeros.3ds", "MM"s + bytesOf(std::uint32_t{40}) + std::string(34, '\0'),
              "chunks of a 3DS file"),
      loads("not_finite.3ds",
            model(object(chunk(0x4110, bytesOf(std::uint16_t{2}) + binaryRows<float>(1) +
                                           bytesOf(0x7FC00000U) + bytesOf(0x7F800000U) +
                                           bytesOf(1.0F)))),
            2),
  });
}

}  // namespace
}  // namespace relievo
