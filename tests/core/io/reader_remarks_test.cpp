// SPDX-License-Identifier: BSD-3-Clause
// What readers remark on a file: its English to the letter, which reports and terminals of every
// version have; and the way of such a remark out of the process that reads.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/io/worker/answer_text.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

template <MessageId id, class... Arguments>
std::string english(Arguments&&... arguments) {
  return englishText(said<id>(std::forward<Arguments>(arguments)...));
}

CountArgument many(std::int64_t count) {
  return CountArgument::grouped(count);
}

TEST(ReaderRemarks, OfAnyFormat) {
  EXPECT_EQ(english<MessageId::incomplete_points>(many(1200), many(1000)),
            "The file is incomplete: its header promises 1 200 points, it ends at 1 000. What is "
            "there was loaded.");
  EXPECT_EQ(english<MessageId::incomplete_faces>(many(1), many(0)),
            "The file is incomplete: its header promises 1 face, it ends at 0. What is there was "
            "loaded.");
  EXPECT_EQ(english<MessageId::faces_cut_without_dents>(many(3)),
            "3 faces have dents and more than 4096 corners; they were cut into triangles without "
            "regard to these. Split them where they were made.");
  EXPECT_EQ(english<MessageId::faces_left_out>(many(4), many(5)),
            "4 of 5 faces were left out: they name points that are not there or not finite, or "
            "have fewer than three corners.");
  EXPECT_EQ(english<MessageId::faces_left_out>(many(1), many(5)),
            "1 of 5 faces was left out: they name points that are not there or not finite, or "
            "have fewer than three corners.");
  EXPECT_EQ(english<MessageId::one_point_in_several>(many(4), many(2500), many(10000)),
            "One point in 4 was taken: 2 500 of 10 000.");
  EXPECT_EQ(english<MessageId::points_too_far>(many(12)),
            "12 points beyond 1e38 were left out; they are no measurements.");
  EXPECT_EQ(english<MessageId::remark_on_file>("b.las", said<MessageId::scan_of_one_point>()),
            "In b.las: The scan has one point only.");
  EXPECT_EQ(english<MessageId::more_remarks_on_files>(7), "And 7 more such remarks on the files.");
}

TEST(ReaderRemarks, OfTextAndMeshes) {
  EXPECT_EQ(english<MessageId::columns_without_xyz>(3),
            "Line 3 names no columns x, y, z; the first three columns were taken.");
  EXPECT_EQ(english<MessageId::header_line_not_of_ply>(2, "made by nobody"),
            "Header line 2 (\"made by nobody\") is not of PLY; it was passed over.");
  EXPECT_EQ(english<MessageId::faces_not_read>("tristrips"),
            "Its \"tristrips\" records are of a kind that is not read; the points were loaded "
            "without faces.");
  EXPECT_EQ(english<MessageId::loaded_without_picture>(
                "stone.jpg", said<MessageId::texture_too_large>(30000, 20000)),
            "\"stone.jpg\", which it names, has 30000 x 20000 pixels, more than are taken; the "
            "mesh was loaded without it.");
}

TEST(ReaderRemarks, OfScansOfOneFile) {
  const auto fault = [](Message sentence) { return WordsArgument::clause(std::move(sentence)); };
  std::vector<Message> left{
      said<MessageId::e57_scan>(1, fault(said<MessageId::e57_packet>())),
      said<MessageId::e57_named_scan>(3, "Tower", fault(said<MessageId::e57_place_outside>()))};
  EXPECT_EQ(english<MessageId::e57_scans_left_out>(2, 4, left),
            "2 of 4 scans were left out: scan 1 (a packet of its points makes no sense), scan 3 "
            "\"Tower\" (it names a place outside itself).");
  EXPECT_EQ(english<MessageId::e57_scans_and_others_left_out>(5, 9, left),
            "5 of 9 scans were left out: scan 1 (a packet of its points makes no sense), scan 3 "
            "\"Tower\" (it names a place outside itself) and others.");
}

TEST(ReaderRemarks, OfLasAndRasters) {
  EXPECT_EQ(english<MessageId::withheld_left_out>(many(1500)),
            "1 500 of its points are marked as withheld (not to be used) and were left out. "
            "They can be taken, too (--keep-withheld).");
  EXPECT_EQ(english<MessageId::heights_converted_to_unit_of_plane>("ft", "m"),
            "Its heights are in ft, its x and y in m; heights were converted to m.");
  EXPECT_EQ(english<MessageId::system_unit_unknown>(2222, "0.9144"),
            "It names its coordinate system, EPSG:2222, whose unit of 0.9144 m is not known here; "
            "state it (--unit).");
  EXPECT_EQ(english<MessageId::raster_heights_converted>("ft", "m"),
            "Heights in ft were converted to m, the unit of the coordinates.");
  EXPECT_EQ(english<MessageId::companion_of_another_map>("a.origin.tif"),
            "a.origin.tif belongs to another map and was left aside.");
}

TEST(ReaderRemarks, ComeOutOfTheProcessThatReadsOrTheAnswerIsRefused) {
  ScanInfo info;
  info.warnings = {said<MessageId::raster_bands>(4), said<MessageId::colours_of_faces>()};
  Packer packer;
  pack(info, packer);
  const std::string bytes = packer.bytes();
  Unpacker unpacker(bytes);
  ScanInfo back;
  ASSERT_TRUE(unpack(unpacker, back));
  EXPECT_EQ(englishTexts(back.warnings), englishTexts(info.warnings));
  // Of the first message's number.
  const std::string message = messageBytes(info.warnings[0]);
  std::string other = bytes;
  other.replace(other.find(message), 2, "\xff\xff");
  Unpacker of_other(other);
  ScanInfo none;
  EXPECT_FALSE(unpack(of_other, none));
}

}  // namespace
}  // namespace relievo
