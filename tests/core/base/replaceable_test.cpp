// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/replaceable.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <vector>

#include "core/base/error.h"
#include "core/file/atomic_file.h"
#include "core/io/formats/text_file.h"
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
    EXPECT_THROW(const AtomicFile file(place), WriteError) << place;
  }
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
}

TEST(Replaceable, SaysWhereTheFileIsBehindItsLinks) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  fs::create_directory(folder.path() / "sub");
  fs::create_symlink("../a.txt", folder.path() / "sub/one");
  fs::create_symlink("sub/one", folder.path() / "two");
  fs::create_symlink("circle", folder.path() / "circle");
  EXPECT_TRUE(fs::equivalent(requireReplaceable(folder.path() / "two"), file));
  EXPECT_EQ(requireReplaceable(file), file);
  EXPECT_THROW(requireReplaceable(folder.path() / "circle"), WriteError);
}

TEST(Replaceable, ReadOnlyFilesAndOpenFilesOfAProcessStay) {
  const test::TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  fs::create_symlink("/proc/self/fd/0", folder.path() / "input");
  fs::permissions(file, fs::perms::owner_read);
  EXPECT_THROW(requireReplaceable(file), WriteError);
  EXPECT_THROW(requireReplaceable(folder.path() / "input"), WriteError);
}

TEST(NotAnInput, IsAskedOfTheFileNotOfItsName) {
  const test::TemporaryFolder folder;
  const fs::path scan = folder.write("scan.ply", "points");
  fs::create_directory(folder.path() / "sub");
  fs::create_symlink(scan, folder.path() / "link.ply");
  fs::create_hard_link(scan, folder.path() / "hard.ply");
  fs::create_directory_symlink(folder.path(), folder.path() / "sub" / "up");
  const std::vector<FileRead> inputs{{.file = "", .what = "nothing"}, {.file = scan}};
  for (const char* name :
       {"scan.ply", "link.ply", "hard.ply", "sub/../scan.ply", "sub/up/scan.ply"}) {
    EXPECT_THROW(requireNotAnInput(folder.path() / name, inputs), ArgumentError) << name;
  }
  for (const char* name : {"other.ply", "sub/scan.ply", "no/scan.ply"}) {
    EXPECT_NO_THROW(requireNotAnInput(folder.path() / name, inputs)) << name;
  }
  EXPECT_NO_THROW(requireNotAnInput({}, inputs));
  try {
    requireNotAnInput(scan, {{.file = scan, .what = "the recording that is read"}});
    ADD_FAILURE() << "not refused";
  } catch (const ArgumentError& error) {
    EXPECT_EQ(error.what(), "The output '" + scan.string() +
                                "' is the recording that is read. Nothing was written. Choose "
                                "another name.");
  }
}

TEST(DifferentFiles, AreAlsoToldApartBeforeTheyAreThere) {
  const test::TemporaryFolder folder;
  const fs::path a = folder.path() / "a.csv";
  fs::create_directory(folder.path() / "sub");
  EXPECT_NO_THROW(requireDifferentFiles({a, folder.path() / "b.csv", {}, {}}));
  EXPECT_THROW(requireDifferentFiles({a, folder.path() / "sub" / ".." / "a.csv"}), ArgumentError);
  folder.write("old.csv", "1");
  fs::create_symlink("old.csv", folder.path() / "link.csv");
  EXPECT_THROW(requireDifferentFiles({folder.path() / "old.csv", a, folder.path() / "link.csv"}),
               ArgumentError);
}

}  // namespace
}  // namespace relievo
