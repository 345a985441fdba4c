// SPDX-License-Identifier: BSD-3-Clause
// Aligning as the program does it: in the child, from scans to one scan.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/prepare/prepare.h"
#include "tests/core/prepare/align_objects.h"
#include "tests/core/scan_fixtures.h"

namespace relievo::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Scan scanOf(const Part& part, Rgba colour) {
  Scan scan;
  scan.origin = part.origin;
  scan.points = part.points;
  scan.colours.assign(scan.points.size(), colour);
  finishScan(scan);
  return scan;
}

std::vector<Part> halves(const MadeObject& object) {
  return {
      makePart(object, {half(object, true, 0.6), 12000, 0.05, {}, {}, 1}),
      makePart(object,
               {half(object, false, 0.6), 8000, 0.05, motion(60, {1, 2, 3}, {30, 9, -70}), {}, 2})};
}

TEST(AlignChild, TwoColouredPartsBecomeOne) {
  const MadeObject object = gargoyle();
  const std::vector<Part> parts = halves(object);
  const Scan red = scanOf(parts[0], {200, 0, 0, 255});
  const Scan blue = scanOf(parts[1], {0, 0, 200, 255});
  Align how{.method = AlignMethod::points};
  how.pairs = picksOn(parts[1], parts[0], 1, 2, 1);
  const Prepared prepared = prepare({&red, &blue}, {.scans = {}, .steps = {how}});
  EXPECT_THAT(prepared.notDone(), IsEmpty());
  ASSERT_TRUE(prepared.answer.align);
  const PoseError error = errorOf(prepared.answer.align->scans[1].pose, parts[1], parts[0]);
  EXPECT_LE(error.deg, 0.05);
  ASSERT_EQ(prepared.scan.points.size(), 20000U);
  ASSERT_EQ(prepared.scan.info.parts.size(), 2U);
  // The reference keeps its bytes, the other's first point is where the object has it.
  EXPECT_EQ(prepared.scan.points[7], red.points[7]);
  EXPECT_EQ(prepared.scan.colours[12000], (Rgba{0, 0, 200, 255}));
  const FilePoint truth = parts[1].object_from_part(blue.point(0));
  EXPECT_LT(norm(prepared.scan.point(12000) - truth), 0.3);
}

TEST(AlignChild, WhatIsRefusedIsLeftOutAndNamed) {
  const std::vector<Part> parts = halves(relief(0));
  Scan one = scanOf(parts[0], {});
  Scan two = scanOf(parts[1], {});
  two.info.file = "plate.ply";
  const Prepared prepared =
      prepare({&one, &two}, {.scans = {}, .steps = {Align{.method = AlignMethod::automatic}}});
  ASSERT_EQ(prepared.notDone().size(), 1U);
  EXPECT_THAT(englishText(prepared.notDone()[0]), HasSubstr("plate.ply was left out"));
  EXPECT_EQ(prepared.scan.points.size(), 12000U);
}

}  // namespace
}  // namespace relievo::test
