// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/replaceable.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "core/base/error.h"
#include "core/io/replaced_file.h"
#include "core/io/text_file.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

TEST(Replaceable, AreFilesAndWhatIsNotThere) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  fs::create_symlink(file, folder.path() / "link.txt");
  fs::create_symlink(folder.path() / "nothing", folder.path() / "dangling.txt");
  for (const char* name : {"a.txt", "link.txt", "dangling.txt", "new.txt", "no/folder.txt"}) {
    EXPECT_NO_THROW(requireReplaceable(folder.path() / name)) << name;
  }
  EXPECT_NO_THROW(requireReplaceable({}));
}

TEST(Replaceable, PipesFoldersAndLinksToThemStay) {
  const test::TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink(pipe, folder.path() / "link");
  for (const fs::path& place : {pipe, folder.path() / "link", folder.path()}) {
    EXPECT_THROW(requireReplaceable(place), WriteError) << place;
    EXPECT_THROW(writeTextFile(place, "new"), WriteError) << place;
    EXPECT_THROW(const ReplacedFile file(place), WriteError) << place;
  }
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
}

}  // namespace
}  // namespace relievo
