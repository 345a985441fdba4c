// SPDX-License-Identifier: BSD-3-Clause
// Where a fragmented MP4 may be cut.
#include "ui/video/mp4_boxes.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& to, const Bytes& more) {
  to.insert(to.end(), more.begin(), more.end());
}

Bytes number(std::uint64_t value, int bytes) {
  Bytes text;
  for (int i = bytes - 1; i >= 0; --i) text.push_back(static_cast<std::uint8_t>(value >> 8 * i));
  return text;
}

Bytes box(const char* type, const Bytes& content) {
  Bytes made = number(content.size() + 8, 4);
  made.insert(made.end(), type, type + 4);
  append(made, content);
  return made;
}

/// Samples of one track in a fragment.
Bytes track(std::uint32_t id, std::uint32_t samples) {
  Bytes run = number(0x301, 4);
  append(run, number(samples, 4));
  append(run, number(0, 4));
  Bytes head = number(0, 4);
  append(head, number(id, 4));
  Bytes traf = box("tfhd", head);
  append(traf, box("trun", run));
  return box("traf", traf);
}

/// A fragment of so many pictures, and of sound, which is counted otherwise.
Bytes fragment(std::uint32_t pictures) {
  Bytes moof = box("mfhd", number(1, 8));
  append(moof, track(1, pictures));
  append(moof, track(2, 97));
  return box("moof", moof);
}

TEST(Mp4Boxes, MayBeCutAfterTheHeadAndAfterEachFragmentWhateverPiecesItComesIn) {
  Bytes file = box("ftyp", number(1, 8));
  append(file, box("moov", Bytes(100, 7)));
  const std::size_t head = file.size();
  append(file, fragment(30));
  append(file, box("mdat", Bytes(5000, 1)));
  const std::size_t first = file.size();
  append(file, fragment(12));
  Bytes large = number(1, 4);  // With a size of 64 bits.
  append(large, {'m', 'd', 'a', 't'});
  append(large, number(16 + 700, 8));
  append(large, Bytes(700, 2));
  append(file, large);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, file.size()}) {
    Mp4Boxes boxes;
    for (std::size_t at = 0; at < file.size(); at += piece) {
      const std::size_t count = std::min(piece, file.size() - at);
      boxes.add(std::span(file).subspan(at, count));
      if (piece > 1) continue;
      const std::size_t seen = at + 1;
      const std::size_t whole = seen < head          ? 0
                                : seen < first       ? head
                                : seen < file.size() ? first
                                                     : file.size();
      ASSERT_EQ(boxes.wholeBytes(), whole) << seen;
      ASSERT_EQ(boxes.wholeFrames(), whole <= head ? 0U : whole == first ? 30U : 42U);
    }
    EXPECT_EQ(boxes.wholeBytes(), file.size());
    EXPECT_EQ(boxes.wholeFrames(), 42U);
  }
}

TEST(Mp4Boxes, OfNonsenseIsNeverWhole) {
  Mp4Boxes boxes;
  boxes.add(Bytes(1000, 0xff));
  EXPECT_EQ(boxes.wholeBytes(), 0U);
}

}  // namespace
}  // namespace relievo
