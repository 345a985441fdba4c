// SPDX-License-Identifier: BSD-3-Clause
// WAV files as others read them: sizes, channels, samples and the text inside.
#include "haptics/sound/wav_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <vector>

#include "tests/core/io/temporary_folder.h"

namespace relievo::sound {
namespace {

std::uint32_t number(const std::string& bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i) {
    value |= std::uint32_t{static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)])}
             << (8 * i);
  }
  return value;
}

std::string written(const std::vector<Frame>& frames, const std::string& comment) {
  const relievo::test::TemporaryFolder folder;
  const std::string path = (folder.path() / "touch.wav").string();
  WavFile file(path, frames.size(), comment);
  file.write(frames);
  EXPECT_FALSE(std::filesystem::exists(path)) << "not before it is whole";
  file.commit();
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(WavFile, HasItsChunksAndSamples) {
  const std::vector<Frame> frames{{0, 0}, {1, -1}, {0.5F, -0.25F}, {2, -2}};
  for (const std::string comment : {"odd", "even"}) {
    const std::string bytes = written(frames, comment);
    EXPECT_EQ(bytes.substr(0, 4), "RIFF");
    EXPECT_EQ(number(bytes, 4, 4), bytes.size() - 8);
    EXPECT_EQ(bytes.substr(8, 8), "WAVEfmt ");
    EXPECT_EQ(number(bytes, 16, 4), 16U);
    EXPECT_EQ(number(bytes, 20, 2), 1U) << "PCM";
    EXPECT_EQ(number(bytes, 22, 2), 2U);
    EXPECT_EQ(number(bytes, 24, 4), 48000U);
    EXPECT_EQ(number(bytes, 28, 4), 48000U * 4);
    EXPECT_EQ(number(bytes, 32, 2), 4U);
    EXPECT_EQ(number(bytes, 34, 2), 16U);
    EXPECT_NE(bytes.find(comment), std::string::npos);
    // Chunk after chunk leads to the samples.
    std::size_t at = 12;
    while (bytes.substr(at, 4) != "data") {
      const std::uint32_t size = number(bytes, at + 4, 4);
      at += 8 + size + size % 2;
      ASSERT_LT(at, bytes.size());
    }
    ASSERT_EQ(number(bytes, at + 4, 4), 4 * frames.size());
    ASSERT_EQ(bytes.size(), at + 8 + 4 * frames.size());
    const std::vector<std::int16_t> expected{0, 0, 32767, -32767, 16384, -8192, 32767, -32767};
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(static_cast<std::int16_t>(number(bytes, at + 8 + 2 * i, 2)), expected[i]) << i;
    }
  }
}

TEST(WavFile, HoldsWhatItsSizesCanSay) {
  const std::string comment(1001, 'x');
  const std::uint64_t bytes = 4 * mostWavFrames(comment) + written({}, comment).size();
  EXPECT_LE(bytes - 8, std::numeric_limits<std::uint32_t>::max());
  EXPECT_GT(mostWavFrames(comment), 6ULL * 3600 * kSampleRateHz);
}

}  // namespace
}  // namespace relievo::sound
