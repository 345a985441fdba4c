// SPDX-License-Identifier: BSD-3-Clause
#include "core/file/output_set.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "core/base/error.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using Texts = std::map<std::string, std::string>;

Texts textsIn(const fs::path& folder) {
  Texts texts;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path());
    texts[entry.path().filename().string()] = std::string(std::istreambuf_iterator<char>(in), {});
  }
  return texts;
}

void write(const OutputFile& place, const std::string& text) {
  AtomicFile file(place);
  std::ofstream(file.path()) << text;
  file.commit();
}

TEST(OutputSet, NothingIsReplacedBeforeAllIsWritten) {
  const test::TemporaryFolder folder;
  folder.write("map", "old");
  OutputSet set;
  write(set.file(folder.path() / "origins"), "new");
  write(set.file(folder.path() / "map"), "new");
  const Texts before = textsIn(folder.path());  // Hidden ones, too, where files need names.
  EXPECT_EQ(before.at("map"), "old");
  EXPECT_FALSE(before.contains("origins"));
  set.commit();
  EXPECT_EQ(textsIn(folder.path()), (Texts{{"map", "new"}, {"origins", "new"}}));
}

TEST(OutputSet, ASetThatIsNotCommittedChangesNothing) {
  const test::TemporaryFolder folder;
  folder.write("map", "old");
  folder.write("stale", "old");
  {
    OutputSet set;
    write(set.file(folder.path() / "map"), "new");
    set.removes(folder.path() / "stale");
  }
  EXPECT_EQ(textsIn(folder.path()), (Texts{{"map", "old"}, {"stale", "old"}}));
}

TEST(OutputSet, WhatIsNoPartOfTheSetGoesWithItsCommit) {
  const test::TemporaryFolder folder;
  folder.write("stale", "old");
  OutputSet set;
  write(set.file(folder.path() / "map"), "new");
  set.removes(folder.path() / "stale");
  set.removes(folder.path() / "never was");
  set.commit();
  EXPECT_EQ(textsIn(folder.path()), (Texts{{"map", "new"}}));
}

TEST(OutputSet, TheMainFileIsTheLastThatTakesItsPlace) {
  const test::TemporaryFolder folder;
  folder.write("origins", "old");
  {
    OutputSet set;
    write(set.file(folder.path() / "origins"), "new");
    write(set.file(folder.path() / "map"), "new");
    fs::create_directory(folder.path() / "map");  // Made by somebody meanwhile.
    EXPECT_THROW(set.commit(), WriteError);
  }
  EXPECT_EQ(textsIn(folder.path()), (Texts{{"origins", "new"}}));
}

TEST(OutputSet, WhatFindsNoRoomIsMetBeforeAnythingIsReplaced) {
  const test::TemporaryFolder folder;
  folder.write("map", "old");
  folder.write("origins", "old");
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit most { 4096, 4096 };
    ::setrlimit(RLIMIT_FSIZE, &most);
    try {
      OutputSet set;
      write(set.file(folder.path() / "origins"), "new");
      AtomicFile map(set.file(folder.path() / "map"));
      std::ofstream out(map.path());
      out << std::string(8192, 'x') << std::flush;
      if (!out) cannotWrite(folder.path() / "map", "no room");
      map.commit();
      set.commit();
    } catch (const WriteError&) {
      ::_exit(0);
    }
    ::_exit(1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(textsIn(folder.path()), (Texts{{"map", "old"}, {"origins", "old"}}));
}

}  // namespace
}  // namespace relievo
