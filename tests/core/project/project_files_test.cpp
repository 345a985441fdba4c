// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/project_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>

#include "core/base/error.h"
#include "core/io/formats/text_file.h"
#include "core/project/autosave.h"
#include "core/project/package.h"
#include "core/provenance/embedded.h"
#include "tests/core/io/temporary_folder.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class OnDisk : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder("work/scans"));
    scan_ = folder_.write("work/scans/coin.ply", "a scan");
    log_ = folder_.write("work/log.csv", "a log");
    project_.file = scan_.generic_string();
    project_.sha256 = sha256OfFile(scan_);
    project_.region = {.x_mm = 1, .y_mm = 2, .side_mm = 3, .level = Level{0}};
    project_.places = {{.name = "eye \u0915", .region = {.side_mm = 0.1, .level = Level{3}}}};
    project_.measurements = {{.name = "rim",
                              .kind = MeasureKind::area,
                              .places = {{0, 0}, {1, 0}, {0, 1}},
                              .plane_mm = 0.1}};
    project_.recordings = {absolute(log_)};
    project_.history = {"Level 2 -> 1", "Gain 2"};
    project_.others = R"({"from_the_future":[1,2]})";
  }
  fs::path folder(const std::string& name) const { return folder_.path() / name; }
  static InputFile absolute(const fs::path& file) {
    InputFile input = inputFile(file, {});
    input.file = file.generic_string();
    return input;
  }

  test::TemporaryFolder folder_;
  fs::path scan_, log_;
  Project project_;
};

TEST_F(OnDisk, AProjectComesBackAsItWas) {
  writeProject(folder("work/p.json"), project_);
  const Project back = readProject(folder("work/p.json"));
  EXPECT_EQ(projectJson(back), projectJson(project_));
  EXPECT_EQ(back.recordings, project_.recordings);
  EXPECT_EQ(back.history, project_.history);
  EXPECT_EQ(back.others, project_.others);
}

TEST_F(OnDisk, AFolderMovedAsAWholeOpensElsewhere) {
  writeProject(folder("work/p.json"), project_);
  EXPECT_THAT(readTextFile(folder("work/p.json"), 1 << 20), HasSubstr("\"scans/coin.ply\""));
  fs::rename(folder("work"), folder("moved"));
  const Project back = readProject(folder("moved/p.json"));
  EXPECT_EQ(back.file, folder("moved/scans/coin.ply").string());
  for (const FileCheck& check : checkFiles(back)) EXPECT_EQ(check.state, FileState::as_before);
}

TEST_F(OnDisk, MissingAndChangedFilesAreToldAndFoundByChecksum) {
  fs::create_directories(folder("elsewhere/deep"));
  fs::rename(scan_, folder("elsewhere/deep/renamed.ply"));
  folder_.write("elsewhere/other.ply", "b scan");  // As long, other bytes.
  folder_.write("work/log.csv", "another log");
  const auto checks = checkFiles(project_);
  ASSERT_EQ(checks.size(), 2U);
  EXPECT_EQ(checks[0].state, FileState::missing);
  EXPECT_EQ(checks[1].state, FileState::changed);
  EXPECT_EQ(
      foundByChecksum(inputFile(folder("elsewhere/deep/renamed.ply"), {}), folder("elsewhere")),
      folder("elsewhere/deep/renamed.ply"));
  EXPECT_EQ(foundByChecksum(project_.recordings[0], folder("elsewhere")), std::nullopt);
  EXPECT_EQ(foundByChecksum(project_.recordings[0], folder("nowhere")), std::nullopt);
}

void expectRefused(const std::string& text) {
  try {
    projectFromJson(text, "p.json");
    ADD_FAILURE() << "accepted: " << text.substr(0, 200);
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("p.json"), HasSubstr("Nothing was changed. "),
                                    Not(HasSubstr("json.exception"))));
  }
}

TEST_F(OnDisk, HostileProjectsAreRefusedWithASentence) {
  const std::string text = projectJson(project_);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string copy = text;
    const std::size_t at = copy.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) copy.replace(at, from.size(), to);
    return copy;
  };
  expectRefused("");
  expectRefused("[]");
  expectRefused("{}");
  expectRefused(changed("\"relievo_project\": 2", "\"relievo_project\": 3"));
  expectRefused(changed("\"relievo_project\": 2", "\"relievo_project\": \"2\""));
  expectRefused(changed("\"kind\": \"area\"", "\"kind\": \"guess\""));
  expectRefused(changed("\"input\"", "\"output\""));
  expectRefused(changed("\"recordings\": [", "\"recordings\": [7,"));
  expectRefused(changed("\"plane_mm\": 0.1", "\"plane_mm\": 1e999"));
  expectRefused(changed("[\n    \"Level 2", "[[[\n    \"Level 2"));
  expectRefused("{\"relievo_project\":1,\"z\":" + std::string(200'000, '[') +
                std::string(200'000, ']') + "}");
  for (std::size_t end = 0; end + 2 < text.size(); end += 7) expectRefused(text.substr(0, end));
}

TEST_F(OnDisk, DamagedBytesNeverCrash) {
  const std::string text = projectJson(project_);
  std::mt19937 random(5);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string copy = text;
    for (int k = 0; k < 3; ++k) copy[random() % copy.size()] = static_cast<char>(random() & 0xffU);
    try {
      projectFromJson(copy, "p.json");
    } catch (const FileError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 500);
}

TEST_F(OnDisk, AHugeOrMissingProjectIsRefused) {
  const fs::path huge = folder("huge.json");
  folder_.write("huge.json", "{");
  fs::resize_file(huge, std::uintmax_t{1} << 32U);  // Sparse.
  EXPECT_THROW(readProject(huge), FileError);
  EXPECT_THROW(readProject(folder("missing.json")), FileError);
  EXPECT_THROW(readProject(folder("work")), FileError);
  EXPECT_THROW(writeProject(folder("none/p.json"), project_), WriteError);
}

TEST_F(OnDisk, WorkOfACrashedProgramIsFoundAndThatOfALivingOneIsNot) {
  const fs::path copies = folder("state/autosave");
  const pid_t child = ::fork();
  if (child == 0) {
    auto* autosave = new Autosave(copies);  // Never destroyed: the program dies.
    project_.saved_as = "p.json";
    project_.others = R"({"another":"key"})";
    autosave->save(project_);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  {
    const Autosave living(copies);
    living.save(project_);
    const auto left = leftAutosaves(copies);
    ASSERT_EQ(left.size(), 1U);
    const Project recovered = readProject(left[0]);
    EXPECT_EQ(recovered.saved_as, "p.json");
    EXPECT_EQ(recovered.others, R"({"another":"key"})");
    EXPECT_EQ(recovered.file, project_.file);
    removeAutosave(left[0]);
    EXPECT_TRUE(leftAutosaves(copies).empty());
  }
  EXPECT_TRUE(fs::is_empty(copies)) << "a program that ends well leaves nothing";
}

TEST_F(OnDisk, ACopyThatCannotBeReadIsKeptButNotFoundAgain) {
  const fs::path copy = folder("autosave-abc.json");
  folder_.write("autosave-abc.json", "{\"relievo_project\": 99}");
  folder_.write("autosave-abc.lock", "");
  ASSERT_EQ(leftAutosaves(copy.parent_path()).size(), 1U);
  setAutosaveAside(copy);
  EXPECT_TRUE(leftAutosaves(copy.parent_path()).empty());
  EXPECT_TRUE(fs::exists(copy.string() + ".unreadable"));
}

TEST_F(OnDisk, FilesElsewhereAreForeignUnlessTheyAreWhatTheProjectWasMadeFrom) {
  const auto foreign = [&](const Project& project) {
    writeProject(folder("work/p.json"), project);
    return foreignFiles(folder("work/p.json"), readProject(folder("work/p.json")));
  };
  const fs::path secret = folder_.write("secret.txt", "a password");
  project_.bytes = fs::file_size(scan_);
  EXPECT_THAT(foreign(project_), IsEmpty()) << "all of it lies in the project's folder";

  fs::rename(scan_, folder("coin.ply"));
  project_.file = folder("coin.ply").generic_string();
  EXPECT_THAT(foreign(project_), IsEmpty()) << "elsewhere, with the bytes that the project states";
  Project hostile = project_;
  hostile.file = secret.generic_string();
  EXPECT_THAT(foreign(hostile), ElementsAre(secret));
  hostile.bytes = 0;
  EXPECT_THAT(foreign(hostile), ElementsAre(secret)) << "of a size that is not stated";
  hostile.sha256.clear();
  EXPECT_THAT(foreign(hostile), ElementsAre(secret)) << "nor a checksum";
  hostile.file = "/proc/version";
  EXPECT_THAT(foreign(hostile), ElementsAre(fs::path("/proc/version")));
  hostile.file = "/dev/zero";
  EXPECT_THAT(foreign(hostile), ElementsAre(fs::path("/dev/zero")));
  hostile.file = folder("not_there.ply").generic_string();
  EXPECT_THAT(foreign(hostile), IsEmpty()) << "nothing is read";

  hostile = project_;
  hostile.recordings.push_back({.file = secret.generic_string(), .sha256 = std::string(64, '0')});
  hostile.figures = {secret.generic_string()};
  hostile.figure.recording = secret.generic_string();
  EXPECT_THAT(foreign(hostile), ElementsAre(secret)) << "once, though it is named three times";
}

TEST_F(OnDisk, LinksOutOfTheProjectsFolderAreForeign) {
  const fs::path secret = folder_.write("secret.txt", "a password");
  fs::remove(scan_);
  fs::create_symlink(secret, scan_);
  writeProject(folder("work/p.json"), project_);
  // As somebody else's program might write it: by the name of the link.
  std::string text = readTextFile(folder("work/p.json"), 1 << 20);
  text.replace(text.find("../secret.txt"), 13, "scans/coin.ply");
  folder_.write("work/p.json", text);
  const Project project = readProject(folder("work/p.json"));
  EXPECT_EQ(project.file, scan_.generic_string());
  EXPECT_THAT(foreignFiles(folder("work/p.json"), project), ElementsAre(scan_));
  fs::remove(scan_);
  fs::create_directory_symlink(folder_.path(), folder("work/up"));
  Project through = project;
  through.file = folder("work/up/secret.txt").generic_string();
  EXPECT_THAT(foreignFiles(folder("work/p.json"), through),
              ElementsAre(folder("work/up/secret.txt")));
}

TEST_F(OnDisk, AFigureElsewhereBelongsToTheWorkIfItSaysSo) {
  fs::create_directories(folder("pictures"));
  const auto figureOf = [&](const Project& shown, const std::string& name) {
    std::string state = projectJson(shown);
    std::erase(state, '\n');
    return folder_.write("pictures/" + name, "# " + stateLine(state) + "\nt_s\n0\n");
  };
  Project other = project_;
  other.sha256 = std::string(64, 'a');
  const fs::path own = figureOf(project_, "own.csv"), foreign = figureOf(other, "other.csv");
  project_.figures = {own.generic_string(), foreign.generic_string()};
  writeProject(folder("work/p.json"), project_);
  EXPECT_THAT(foreignFiles(folder("work/p.json"), readProject(folder("work/p.json"))),
              ElementsAre(foreign));
}

TEST_F(OnDisk, APackageIsWholeAndTheSameEachTime) {
  const fs::path figure = folder_.write("fig.png", "a figure");
  fs::create_directories(folder("b"));
  const fs::path same_name = folder_.write("b/fig.png", "another");
  PackageContents contents;
  contents.figures = {figure, same_name};
  writePackage(folder("one.zip"), project_, contents);
  writePackage(folder("two.zip"), project_, contents);
  EXPECT_EQ(sha256OfFile(folder("one.zip")), sha256OfFile(folder("two.zip")));
  const PackageCheck check = verifyPackage(folder("one.zip"));
  EXPECT_EQ(check.problems, std::vector<std::string>{});
  EXPECT_EQ(check.files, 6U);
  writePackage(folder("bare.zip"), project_, {.with_input = false});
  EXPECT_EQ(verifyPackage(folder("bare.zip")).files, 3U);
}

/// A zip with one entry more: a folder, or an empty file.
std::string withEntry(const std::string& zip, const std::string& name) {
  const auto number = [](std::size_t value, int bytes) {
    std::string text;
    for (; bytes > 0; --bytes, value >>= 8) text += static_cast<char>(value & 0xff);
    return text;
  };
  const auto at = [&](std::size_t place, int bytes) {
    std::size_t value = 0;
    for (int i = bytes; i-- > 0;) {
      value = value << 8 | static_cast<unsigned char>(zip[place + static_cast<std::size_t>(i)]);
    }
    return value;
  };
  // As APPNOTE.TXT 4.3 has them; the end of the list is its last 22 bytes.
  const std::size_t end = zip.size() - 22, list = at(end + 16, 4), entries = at(end + 10, 2);
  const std::string about =
      number(20, 2) + std::string(20, '\0') + number(name.size(), 2) + number(0, 2);
  const std::string local = "PK\3\4" + about + name;
  const std::string listed =
      "PK\1\2" + number(20, 2) + about + std::string(10, '\0') + number(list, 4) + name;
  return zip.substr(0, list) + local + zip.substr(list, end - list) + listed + zip.substr(end, 8) +
         number(entries + 1, 2) + number(entries + 1, 2) + number(end - list + listed.size(), 4) +
         number(list + local.size(), 4) + number(0, 2);
}

TEST_F(OnDisk, APackageThatWasZippedAnewWithItsFoldersIsAsBefore) {
  writePackage(folder("one.zip"), project_, {});
  const std::string bytes = readTextFile(folder("one.zip"), 1 << 20);
  const PackageCheck check = verifyPackage(folder_.write("folder.zip", withEntry(bytes, "input/")));
  EXPECT_EQ(check.problems, std::vector<std::string>{});
  fs::create_directories(folder("unpacked"));
  unpackPackage(folder("folder.zip"), folder("unpacked"));
  EXPECT_EQ(verifyPackage(folder_.write("file.zip", withEntry(bytes, "input"))).problems,
            std::vector<std::string>{"'input' was added after packing."});
}

TEST_F(OnDisk, NamesOfSeveralLinesArePackedAndUnpacked) {
  PackageContents contents;
  for (const char* name : {"two\nlines.png", "a\\n.png", "back\\slash.png", "re\rturn.png",
                           "\\.png", "quote\"' and\ttab.png"}) {
    contents.figures.push_back(folder_.write(name, name));
  }
  writePackage(folder("one.zip"), project_, contents);
  const PackageCheck check = verifyPackage(folder("one.zip"));
  EXPECT_EQ(check.problems, std::vector<std::string>{});
  EXPECT_EQ(check.files, 4U + contents.figures.size());
  fs::create_directories(folder("unpacked"));
  unpackPackage(folder("one.zip"), folder("unpacked"));
  for (const fs::path& figure : contents.figures) {
    const fs::path unpacked = folder("unpacked/figures") / figure.filename();
    ASSERT_TRUE(fs::exists(unpacked)) << unpacked;
    EXPECT_EQ(sha256OfFile(unpacked), sha256OfFile(figure)) << figure;
  }
}

TEST_F(OnDisk, WhatARecordingNeedsIsPackedBesideItOnce) {
  const fs::path raster = folder_.write("firm.tif", "where it is firm");
  const std::string sha256 = sha256OfFile(raster);
  PackageContents contents;
  contents.dependencies = [&](const fs::path& recording, const Task&) {
    EXPECT_EQ(recording.filename(), "log.csv");
    const InputFile one{.file = raster.string(), .sha256 = sha256};
    const InputFile scan{.file = project_.file, .sha256 = project_.sha256};
    return std::vector<InputFile>{one, one, scan};
  };
  writePackage(folder("one.zip"), project_, contents);
  EXPECT_EQ(verifyPackage(folder("one.zip")).files, 5U) << "four, and the raster";
  fs::create_directories(folder("unpacked"));
  unpackPackage(folder("one.zip"), folder("unpacked"));
  EXPECT_EQ(sha256OfFile(folder("unpacked/recordings/firm.tif")), sha256);

  folder_.write("firm.tif", "where it is not");
  fs::remove(folder("one.zip"));
  try {
    writePackage(folder("one.zip"), project_, contents);
    ADD_FAILURE() << "another raster was packed";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("needed to repeat 'log.csv'"), std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(fs::exists(folder("one.zip")));
}

TEST_F(OnDisk, ADamagedPackageIsTold) {
  writePackage(folder("one.zip"), project_, {});
  std::string bytes = readTextFile(folder("one.zip"), 1 << 20);
  // Every byte of the stored names, sizes and contents: never quietly accepted, never a crash.
  int told = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 11) {
    std::string copy = bytes;
    copy[i] = static_cast<char>(copy[i] ^ 0x55);
    const fs::path file = folder_.write("bad.zip", copy);
    try {
      if (!verifyPackage(file).problems.empty()) ++told;
    } catch (const FileError&) {
      ++told;
    }
  }
  EXPECT_GT(told, static_cast<int>(bytes.size() / 11 / 2));
  EXPECT_THROW(verifyPackage(folder_.write("cut.zip", bytes.substr(0, bytes.size() / 2))),
               FileError);
  EXPECT_THROW(verifyPackage(scan_), FileError);
}

TEST_F(OnDisk, APackageIsNotMadeFromChangedFiles) {
  folder_.write("work/log.csv", "another log");
  EXPECT_THROW(writePackage(folder("one.zip"), project_, {}), FileError);
  project_.recordings.clear();
  fs::remove(scan_);
  EXPECT_THROW(writePackage(folder("one.zip"), project_, {}), FileError);
  EXPECT_FALSE(fs::exists(folder("one.zip")));
  writePackage(folder("one.zip"), project_, {.with_input = false});
  EXPECT_TRUE(fs::exists(folder("one.zip")));
  EXPECT_THROW(writePackage(folder("none/one.zip"), project_, {.with_input = false}), WriteError);
}

}  // namespace
}  // namespace relievo
