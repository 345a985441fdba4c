// SPDX-License-Identifier: BSD-3-Clause
// Runs every command that README.md, docs/paper.md and docs/user give, as it is written there, in a
// folder with stand-ins for the files that a reader would have.
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/core/io/temporary_folder.h"
#include "tests/core/sphere_figure.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = RELIEVO_SOURCE_DIR;

struct Command {
  std::string words;
  std::string says;  ///< What its output names, if the page says so; else nothing.
};

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::smatch> found(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  return {std::sregex_iterator(text.begin(), text.end(), regex), std::sregex_iterator()};
}

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

/// The indented lines, and what stands in the text and writes a file.
std::vector<Command> commandsOf(const fs::path& page) {
  const std::string text = textOf(page);
  std::vector<Command> commands;
  for (const auto& line : found(text, "\n {4,}(relievo [^\n#]*[^\n# ])")) {
    commands.push_back({line[1], {}});
  }
  for (const auto& inline_one : found(text, "`(relievo [^`]* -o [^`]*)`")) {
    commands.push_back({replaced(inline_one[1], "\n", " "), {}});
  }
  return commands;
}

/// The commands of docs/paper.md's table; T is short for one that the page gives.
std::vector<Command> commandsOfPaper() {
  const std::string text = textOf(kSource / "docs/paper.md");
  const auto shorthand = found(text, "T for `([^`]*)`");
  EXPECT_EQ(shorthand.size(), 1U);
  std::vector<Command> commands;
  for (const auto& row : found(text, "\n\\|[^\n]*\\|([^|\n]*)\\|(?=\n)")) {
    const std::string last = row[1];
    for (const auto& cell : found(last, "`(relievo [^`]*|T(?: [^`]*)?)`(?:: `([^`]*)`)?")) {
      commands.push_back({replaced(cell[1], "^T", shorthand.front()[1]), cell[2]});
    }
  }
  return commands;
}

class Pages : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = std::make_unique<test::TemporaryFolder>();
    const fs::path samples = kSource / "data/samples";
    fs::create_symlink(samples, here("S"));
    fs::create_symlink(kSource / "data/strokes", here("D"));
    fs::create_symlink(samples / "panel.ply", here("panel.ply"));
    fs::create_symlink(samples / "panel.ply", here("scan.ply"));
    fs::create_symlink(samples / "coin.ply", here("survey.ply"));
    fs::create_symlink(samples / "coin.ply", here("right.ply"));
    writeFigure(here("front.ply"), 1);
    writeFigure(here("back.ply"), 2);
    writeFigure(here("left.ply"), 3);
    writeHeights(here("heights.png"));
    std::ofstream(here("picks.csv")) << "scan,x,y,z,ref_x,ref_y,ref_z\n"
                                        "2,0,0,79,0,0,79\n2,40,0,0,40,0,0\n2,0,40,0,0,40,0\n"
                                        "3,0,0,79,0,0,79\n3,40,0,0,40,0,0\n3,0,40,0,0,40,0\n";
    fs::create_directories(here("scans"));
    fs::create_directories(here("build/release/figures"));
    std::ofstream(here("stroke.csv")) << "t_s,x_mm,y_mm,z_mm\n0,120,85,60\n0.2,120,85,30\n";
    std::ofstream(here("long.csv")) << "t_s,x_mm,y_mm,z_mm\n0,120,85,60\n3.1,120,85,30\n";
    for (const char* command :
         {"relievo touch panel.ply --stroke stroke.csv -o log.csv",
          "relievo touch panel.ply --stroke stroke.csv -o LOG.csv",
          "relievo touch panel.ply --stroke long.csv -o LOG.h5",
          "relievo render panel.ply --region 110,80,60,60 -o fig.png",
          "relievo render panel.ply --region 30,40,130,130 -o build/release/figures/detail_2.png",
          "relievo project new fig.png -o P.relievo.json",
          "relievo project new fig.png -o WORK.relievo.json",
          "relievo project new fig.png --recording LOG.csv -o packed.relievo.json",
          "relievo project package packed.relievo.json -o PACKAGE.zip"}) {
      run({command, {}});
    }
    addPath(here("WORK.relievo.json"));
  }
  static void TearDownTestSuite() { folder.reset(); }

  static fs::path here(const std::string& name) { return folder->path() / name; }

  /// A scan of one closed body; another one for each seed.
  static void writeFigure(const fs::path& file, unsigned seed) {
    const Scan scan = test::sampledFigure(test::sphereFigure(), {.points = 20'000}, seed);
    std::ofstream out(file, std::ios::binary);
    out << "ply\nformat ascii 1.0\ncomment unit mm\nelement vertex " << scan.points.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    for (const auto& p : scan.points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }

  /// A picture of 16 bits that does not say how large it is.
  static void writeHeights(const fs::path& file) {
    GDALAllRegister();
    constexpr int kSide = 60;
    GDALDriver* const memory = GetGDALDriverManager()->GetDriverByName("MEM");
    const std::unique_ptr<GDALDataset> heights(
        memory->Create("", kSide, kSide, 1, GDT_UInt16, nullptr));
    std::vector<std::uint16_t> row(kSide);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        row[static_cast<std::size_t>(x)] = static_cast<std::uint16_t>(500 * (x + y));
      }
      ASSERT_EQ(heights->GetRasterBand(1)->RasterIO(GF_Write, 0, y, kSide, 1, row.data(), kSide, 1,
                                                    GDT_UInt16, 0, 0),
                CE_None);
    }
    GDALDriver* const png = GetGDALDriverManager()->GetDriverByName("PNG");
    const std::unique_ptr<GDALDataset> written(
        png->CreateCopy(file.c_str(), heights.get(), FALSE, nullptr, nullptr, nullptr));
    ASSERT_TRUE(written);
  }

  /// Two key views, a fifth of a second apart.
  static void addPath(const fs::path& file) {
    nlohmann::json project = nlohmann::json::parse(textOf(file));
    nlohmann::json near = project.at("view");
    near["relievo_view"] = 1;
    nlohmann::json far = near;
    far["region_mm"] = {0, 0, 200, 200};
    project["camera_paths"] = {
        {{"name", "walk"},
         {"keys", {{{"t_s", 0}, {"view", far}}, {{"t_s", 0.2}, {"view", near}}}}}};
    std::ofstream(file) << project;
  }

  /// Ends well, names what the page says it does, and leaves what it was to write.
  static void run(const Command& command) {
    const auto output = found(command.words, " -o ([^ ]+)");
    fs::path made;
    if (!output.empty()) made = here(output.front()[1]);
    if (!made.empty()) fs::remove_all(made);
    const std::string line = "cd '" + folder->path().string() +
                             "' && unset DISPLAY && export PATH='" RELIEVO_BINARY_DIR
                             "/bin':$PATH HOME=$PWD XDG_CONFIG_HOME=$PWD/config" +
                             " XDG_DATA_HOME=$PWD/data XDG_STATE_HOME=$PWD/state && { " +
                             command.words + "; } 2>&1";
    FILE* const pipe = ::popen(line.c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::string said;
    std::array<char, 4096> some{};
    for (std::size_t n = 0; (n = std::fread(some.data(), 1, some.size(), pipe)) > 0;) {
      said.append(some.data(), n);
    }
    const int status = ::pclose(pipe);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << command.words << '\n' << said;
    EXPECT_NE(said.find(command.says), std::string::npos) << command.words << '\n' << said;
    if (made.empty()) return;
    // A pyramid writes NAME.L0.tif, ... for NAME.tif.
    const std::string stem = made.stem().string();
    const bool left = std::any_of(
        fs::directory_iterator(made.parent_path()), fs::directory_iterator(), [&](const auto& e) {
          return e.path().stem().string().starts_with(stem) &&
                 e.path().extension() == made.extension() && !fs::is_empty(e.path());
        });
    EXPECT_TRUE(left) << command.words << " left no " << made.filename() << '\n' << said;
  }

  static std::unique_ptr<test::TemporaryFolder> folder;
};

std::unique_ptr<test::TemporaryFolder> Pages::folder;

TEST_F(Pages, ThePapersCommandsDoWhatTheirTableSays) {
  const std::vector<Command> commands = commandsOfPaper();
  EXPECT_GE(commands.size(), 25U);
  std::set<std::string> done;
  for (const Command& command : commands) {
    if (done.insert(command.words + command.says).second) run(command);
  }
}

TEST_F(Pages, TheUsersCommandsWork) {
  std::vector<fs::path> pages{kSource / "README.md"};
  for (const auto& entry : fs::directory_iterator(kSource / "docs/user")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  std::sort(pages.begin(), pages.end());
  std::set<std::string> done;
  for (const fs::path& page : pages) {
    for (Command command : commandsOf(page)) {
      // Novint's file, which nobody may pass on.
      if (command.words.find("nvent_firmware.bin") != std::string::npos) continue;
      // Forms for any file and place.
      command.words = replaced(command.words, "\\bFILE\\b", "panel.ply");
      command.words = replaced(command.words, "X,Y,W,H", "110,80,60,60");
      command.words = replaced(command.words, "X,Y,X,Y", "40,60,90,60");
      if (done.insert(command.words).second) run(command);
    }
  }
  EXPECT_GE(done.size(), 35U);
}

}  // namespace
}  // namespace relievo
