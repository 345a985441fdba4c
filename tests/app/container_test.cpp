// SPDX-License-Identifier: BSD-3-Clause
// The command line as a container runs it: as process 1, without a home, a terminal or an
// environment, on a file system that is read only but for one folder, with a small /tmp.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <future>

#include "tests/app/command_test.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

int exitOf(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

class Container : public test::CommandTest {
 protected:
  void SetUp() override {
    test::CommandTest::SetUp();
    if (exitOf("unshare --mount --pid --fork --mount-proc mount -t tmpfs none /mnt 2>/dev/null") !=
        0) {
      GTEST_SKIP() << "This system lets nobody here make a container.";
    }
    fs::create_directory(path("out"));
  }
  /// Runs relievo in one, in the folder "out" of the test's folder.
  int contained(const std::string& words) const {
    // The folder of this test may lie in /tmp, which is hidden: it is seen at /mnt. So may the
    // program, which comes back to its own place by way of /srv.
    return exitOf(
        "unshare --mount --pid --fork --mount-proc sh -c '"
        "set -e; mount --make-rprivate /; mount --bind \"" +
        folder_.path().string() +
        "\" /mnt; mount --bind \"" RELIEVO_BINARY_DIR
        "\" /srv; mount -o remount,bind,ro /; mount -t tmpfs -o size=256k none /tmp; "
        "mkdir -p \"" RELIEVO_BINARY_DIR "\"; mount --bind /srv \"" RELIEVO_BINARY_DIR
        "\"; cd /mnt; cd out; exec env -i PATH=/usr/bin:/bin \"" RELIEVO_BINARY_DIR
        "/bin/relievo\" " +
        words + "' </dev/null >" + path("said") + " 2>&1");
  }
  std::string said() const { return test::bytesOf(path("said")); }
};

TEST_F(Container, AMapIsMadeAsOutside) {
  plane();
  ASSERT_EQ(contained("depthmap ../plane.xyz --unit mm -o map.tif"), 0) << said();
  const std::string map = path("out/map.tif"), outside = path("elsewhere.tif");
  ASSERT_EQ(
      test::runRelievo({"depthmap", path("plane.xyz"), "--unit", "mm", "-o", outside}).exit_code,
      0);
  // The files say how they were made, from which folder, too; the heights are the same.
  for (const std::string& file : {map, outside}) {
    ASSERT_EQ(test::runRelievo({"convert", file, file + ".asc"}).exit_code, 0);
  }
  const std::string heights = test::bytesOf(map + ".asc");
  EXPECT_GT(heights.size(), 1000U);
  EXPECT_EQ(heights, test::bytesOf(outside + ".asc"));
}

TEST_F(Container, AFolderThatIsReadOnlyIsToldAndNothingIsLeft) {
  plane();
  EXPECT_EQ(contained("depthmap ../plane.xyz --unit mm -o /usr/map.tif"), 3) << said();
  EXPECT_FALSE(fs::exists("/usr/map.tif"));
}

TEST_F(Container, AStrokeIsTouchedWithoutAHome) {
  plane();
  fs::copy_file(test::kFlatStroke, path("flat.csv"));  // The tree may be hidden, too.
  EXPECT_EQ(contained("touch ../plane.xyz --unit mm --stroke ../flat.csv -o log.csv"), 0) << said();
  EXPECT_TRUE(fs::exists(path("out/log.csv")));
}

/// The screen in memory finds its place in the small /tmp.
TEST_F(Container, APictureIsDrawn) {
  if (!fs::exists(RELIEVO_BINARY_DIR "/bin/relievo-draw")) {
    GTEST_SKIP() << "The command line alone draws nothing.";
  }
  plane();
  ASSERT_EQ(contained("render ../plane.xyz --unit mm --pixels 100 -o plane.png"), 0) << said();
  EXPECT_EQ(test::bytesOf(path("out/plane.png")).substr(1, 3), "PNG");
}

/// The first process of a container hears no signal that it does not wait for.
TEST_F(Container, ItEndsInOrderWhenItIsAsked) {
  plane();
  const std::string ask =
      "for p in /proc/[0-9]*; do case $(cat $p/comm) in relievo*) grep -qa asked_to_end $p/cmdline "
      "&& kill -TERM ${p#/proc/};; esac; done 2>/dev/null";
  auto ended = std::async(std::launch::async, [&] {
    return contained(
        "record ../plane.xyz --unit mm --device virtual --seconds 600 -o "
        "asked_to_end.csv");
  });
  do {
    exitOf(ask);
  } while (ended.wait_for(std::chrono::milliseconds(200)) != std::future_status::ready);
  EXPECT_EQ(ended.get(), 0) << said();
  EXPECT_THAT(said(), testing::HasSubstr("what was recorded is saved"));
  EXPECT_TRUE(fs::exists(path("out/asked_to_end.csv")));
}

}  // namespace
}  // namespace relievo
