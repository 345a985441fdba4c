// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/openable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/provenance/sha256.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kHeader =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nend_header\n";

class Openable : public testing::Test {
 protected:
  static std::string refusalOf(const fs::path& file) {
    const std::optional<Message> refusal = openingRefusal(file);
    return refusal ? englishText(*refusal) : "";
  }
  fs::path scan(const char* name, const std::string& points) {
    return folder_.write(name, kHeader + points);
  }

  test::TemporaryFolder folder_;
};

TEST_F(Openable, AScanIsReadToItsEnd) {
  EXPECT_EQ(refusalOf(scan("whole.ply", "0 0 0\n1 0 0\n0 1 0.5\n")), "");
  EXPECT_THAT(refusalOf(scan("cut.ply", "0 0 0\n1 0 0\n")), HasSubstr("cut.ply"));
  EXPECT_THAT(refusalOf(folder_.write("letter.txt", "Dear museum,\n")), HasSubstr("letter.txt"));
  EXPECT_THAT(refusalOf(folder_.path() / "gone.ply"), HasSubstr("gone.ply"));
}

TEST_F(Openable, AProjectWithItsInput) {
  const fs::path input = scan("coin.ply", "0 0 0\n1 0 0\n0 1 0.5\n");
  Project project;
  project.file = "coin.ply";
  project.sha256 = sha256OfFile(input);
  project.region = {.x_mm = 1, .y_mm = 2, .side_mm = 3, .level = Level{0}};
  const fs::path file = folder_.path() / "coin.relievo.json";
  writeProject(file, project);
  EXPECT_EQ(refusalOf(file), "");
  fs::remove(input);
  EXPECT_THAT(refusalOf(file), HasSubstr("coin.ply"));
  EXPECT_THAT(refusalOf(folder_.write("no.relievo.json", "{")), HasSubstr("no.relievo.json"));
}

TEST_F(Openable, IsStopped) {
  std::stop_source source;
  source.request_stop();
  Task task;
  task.stop = source.get_token();
  EXPECT_THROW(openingRefusal(scan("whole.ply", "0 0 0\n1 0 0\n0 1 0.5\n"), task), Cancelled);
}

}  // namespace
}  // namespace relievo
