// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/sha256.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

// FIPS 180-4's own examples.
TEST(Sha256, OfTheStandardsExamples) {
  EXPECT_EQ(sha256OfText(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256OfText("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256OfText("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Sha256, OfAFileIsThatOfItsBytesHoweverLong) {
  const test::TemporaryFolder folder;
  const std::string text(3'000'001, 'a');
  const auto file = folder.path() / "long.bin";
  std::ofstream(file, std::ios::binary) << text;
  EXPECT_EQ(sha256OfFile(file), sha256OfText(text));
  Sha256 pieces;
  pieces.add(std::string_view(text).substr(0, 17));
  pieces.add(std::string_view(text).substr(17));
  EXPECT_EQ(pieces.finish(), sha256OfText(text));
}

TEST(Sha256, OfAFileCanBeStoppedAndTellsHowFarItIs) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "long.bin";
  std::ofstream(file, std::ios::binary) << std::string(2'000'000, 'x');
  std::stop_source stop;
  double last = 0;
  const Task task{.stop = stop.get_token(), .progress = [&](std::string_view, double fraction) {
                    EXPECT_GT(fraction, last);
                    last = fraction;
                    stop.request_stop();
                  }};
  EXPECT_THROW(sha256OfFile(file, task), Cancelled);
  EXPECT_GT(last, 0.1);
  EXPECT_LT(last, 0.9);
}

TEST(Sha256, OfWhatIsNoFileIsRefused) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(sha256OfFile(folder.path() / "missing"), FileError);
  EXPECT_THROW(sha256OfFile(folder.path()), FileError);
}

TEST(InputFile, IsNamedFromTheFolderOfWhatWasMade) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "scans" / "old");
  std::filesystem::create_directories(folder.path() / "figures");
  const auto file = folder.path() / "scans" / "coin.ply";
  std::ofstream(file) << "abc";
  EXPECT_EQ(inputFile(file, folder.path() / "figures").file, "../scans/coin.ply");
  EXPECT_EQ(inputFile(folder.path() / "scans/old/../coin.ply", folder.path()).file,
            "scans/coin.ply");
  const InputFile alone = inputFile(file, {});
  EXPECT_EQ(alone.file, "coin.ply");
  EXPECT_EQ(alone.bytes, 3U);
  EXPECT_EQ(alone.sha256, sha256OfText("abc"));
}

}  // namespace
}  // namespace relievo
