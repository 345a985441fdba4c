// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/boot_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/emulator/made_image.h"

namespace relievo::falcon {
namespace {

using testing::HasSubstr;

TEST(BootImage, AStreamWithItsEndAtTheEndOfTheFileIsGood) {
  const BootImage image = inspectBootImage(test::madeImage({1200, 7, 900}));
  EXPECT_TRUE(image.good()) << englishText(image.problem.value());
  EXPECT_EQ(image.blocks, 3U);
  EXPECT_EQ(image.words, 2107U);
  EXPECT_EQ(image.entry, test::kMadeEntry);
}

TEST(BootImage, EveryCutIsNoticed) {
  const std::vector<std::uint8_t> whole = test::madeImage({1200, 7, 900});
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const BootImage image = inspectBootImage(std::span(whole).first(size));
    ASSERT_FALSE(image.good()) << size;
  }
}

TEST(BootImage, SaysWhatIsWrong) {
  std::vector<std::uint8_t> image = test::madeImage({1200, 7, 900});
  EXPECT_THAT(englishText(inspectBootImage({}).problem.value()), HasSubstr("0 bytes"));
  image.push_back(0);
  EXPECT_THAT(englishText(inspectBootImage(image).problem.value()), HasSubstr("odd"));
  image.push_back(0);
  EXPECT_THAT(englishText(inspectBootImage(image).problem.value()), HasSubstr("2 bytes follow"));
  image.resize(image.size() - 4);
  EXPECT_THAT(englishText(inspectBootImage(image).problem.value()), HasSubstr("ends in block 4"));
  image[0] = 0xab;
  EXPECT_THAT(englishText(inspectBootImage(image).problem.value()), HasSubstr("AA 08"));
  EXPECT_THAT(englishText(inspectBootImage(std::vector<std::uint8_t>(70'000)).problem.value()),
              HasSubstr("70000"));
  EXPECT_THAT(englishText(inspectBootImage(test::madeImage({}, 2048)).problem.value()),
              HasSubstr("follow"));
}

TEST(BootImage, RandomAndDamagedBytesAreReadWithoutHarm) {
  std::mt19937 random(20261121);
  const std::vector<std::uint8_t> whole = test::madeImage({600, 7, 900});
  std::uniform_int_distribution<std::size_t> place(0, whole.size() - 1);
  int good = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::vector<std::uint8_t> image = whole;
    for (int hits = 0; hits <= i % 4; ++hits) {
      image[place(random)] = static_cast<std::uint8_t>(random());
    }
    if (i % 3 == 0) image.resize(place(random));
    const BootImage read = inspectBootImage(image);
    if (read.good()) ++good;
    ASSERT_LE(2 * read.words, image.size());
  }
  EXPECT_GT(good, 100) << "damage inside a block cannot be seen";
}

}  // namespace
}  // namespace relievo::falcon
