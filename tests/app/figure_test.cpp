// SPDX-License-Identifier: BSD-3-Clause
// Figures by the command line, tried from outside.
#include <sys/resource.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "core/provenance/embedded.h"
#include "core/provenance/provenance.h"
#include "tests/app/command_test.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::bytesOf;
using test::CommandResult;
using test::runRelievo;

class FigureVerb : public test::CommandTest {
 protected:
  void SetUp() override {
    // A step of 5 mm at x = 50, 101 x 101 points, 1 mm apart.
    std::ofstream scan(path("step.xyz"));
    for (int y = 0; y <= 100; ++y) {
      for (int x = 0; x <= 100; ++x) scan << x << ' ' << y << ' ' << (x > 50 ? 5 : 0) << '\n';
    }
  }
  CommandResult figure(const std::vector<std::string>& more) const {
    return runRelievo(test::joined({"figure", path("step.xyz"), "--unit", "mm", "--view", "top",
                                    "--dpi", "100", "--report", "json"},
                                   more),
                      {"DISPLAY"});
  }
};

TEST_F(FigureVerb, ReportsItsSizeAndMeasuresWithoutADisplay) {
  const CommandResult result =
      figure({"--width-mm", "85", "--measure", "edge:depth:20,50;80,50", "--caption", path("c.txt"),
              "--heights", path("h.tif"), "-o", path("a.png")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["pixels"][0], 335);
  EXPECT_EQ(report["layout"], "reference");
  const json edge = report["measurements"][0]["values"][0];
  EXPECT_NEAR(edge["value"].get<double>(), 5, 1e-6);
  EXPECT_EQ(report["input_sha256"].get<std::string>().size(), 64U);
  EXPECT_NE(bytesOf(path("c.txt")).find("step.xyz"), std::string::npos);
  EXPECT_FALSE(bytesOf(path("h.tif")).empty());
}

TEST_F(FigureVerb, WritesTheSameBytesAgainButForThePdfsDate) {
  const auto drawn = [&](const char* name) {
    EXPECT_EQ(figure({"-o", path(name)}).exit_code, 0);
    std::string bytes = bytesOf(path(name));
    constexpr std::string_view kDate = "/CreationDate (D:";
    const std::size_t date = bytes.find(kDate);
    constexpr std::size_t kDigits = 14;
    return date == std::string::npos ? bytes : bytes.erase(date + kDate.size(), kDigits);
  };
  for (const char* ending : {".pdf", ".svg"}) {
    const std::string first = drawn((std::string("a") + ending).c_str());
    // Fonts stood in the order of a hash that is another one in nearly every run.
    for (int i = 0; i < 3; ++i) {
      EXPECT_TRUE(drawn((std::string("b") + ending).c_str()) == first) << ending;
    }
  }
}

TEST_F(FigureVerb, ACaptionToTheScreenIsNoFile) {
  ASSERT_EQ(figure({"--layout", "detail", "--caption", "-", "-o", path("a.png")}).exit_code, 0);
  EXPECT_FALSE(fs::exists("-"));
}

TEST_F(FigureVerb, DrawsASectionAndKeepsItInThePicture) {
  const std::string cut = "rim:section:0,0,1,2.5";
  ASSERT_EQ(figure({"--layout", "detail", "-o", path("plain.png")}).exit_code, 0);
  const CommandResult result =
      figure({"--layout", "detail", "--measure", cut, "-o", path("cut.png")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(bytesOf(path("plain.png")), bytesOf(path("cut.png")));
  const json rim = json::parse(result.out)["measurements"][0];
  EXPECT_EQ(rim["plane"], json({0, 0, 1, 2.5}));
  EXPECT_EQ(rim["values"][0]["what"], "length of the cut");
  const CommandResult again =
      runRelievo({"figure", "--from-image", path("cut.png"), "-o", path("again.png")}, {"DISPLAY"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(bytesOf(path("cut.png")), bytesOf(path("again.png")));
  EXPECT_EQ(figure({"--measure", "rim:section:0,0,1,99", "-o", path("c.png")}).exit_code, 1);
  EXPECT_EQ(figure({"--measure", "rim:section:0,0,1", "-o", path("c.png")}).exit_code, 1);
}

TEST_F(FigureVerb, DrawsTheSamePixelsAgainFromItsPicture) {
  ASSERT_EQ(figure({"--relief", "slope", "--region", "30,30,40,40", "-o", path("a.png")}).exit_code,
            0);
  const CommandResult again =
      runRelievo({"figure", "--from-image", path("a.png"), "-o", path("b.png")}, {"DISPLAY"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(bytesOf(path("a.png")), bytesOf(path("b.png")));
  const CommandResult render =
      runRelievo({"render", "--from-image", path("a.png"), "-o", path("c.png")}, {"DISPLAY"});
  ASSERT_EQ(render.exit_code, 0) << render.err;
  EXPECT_EQ(bytesOf(path("a.png")), bytesOf(path("c.png")));
}

TEST_F(FigureVerb, SaysSoWhenTheInputChanged) {
  ASSERT_EQ(figure({"-o", path("a.png")}).exit_code, 0);
  std::ofstream(path("step.xyz"), std::ios::app) << "50 50 9\n";
  const CommandResult again =
      runRelievo({"figure", "--from-image", path("a.png"), "-o", path("b.png")}, {"DISPLAY"});
  EXPECT_EQ(again.exit_code, 5);
  EXPECT_NE(again.err.find("E501"), std::string::npos) << again.err;
  EXPECT_FALSE(fs::exists(path("b.png"))) << "nothing is drawn from other bytes unasked";
  EXPECT_EQ(
      runRelievo({"figure", "--from-image", path("a.png"), "--changed-input", "-o", path("b.png")},
                 {"DISPLAY"})
          .exit_code,
      0);
  EXPECT_TRUE(fs::exists(path("b.png")));
}

TEST_F(FigureVerb, SaysACodeOnce) {
  ASSERT_EQ(figure({"-o", path("a.png")}).exit_code, 0);
  fs::remove(path("step.xyz"));
  const CommandResult again =
      runRelievo({"figure", "--from-image", path("a.png"), "-o", path("b.png")}, {"DISPLAY"});
  EXPECT_EQ(again.exit_code, 2);
  const std::size_t code = again.err.find("E501");
  ASSERT_NE(code, std::string::npos) << again.err;
  EXPECT_EQ(again.err.find("E501", code + 1), std::string::npos) << again.err;
}

TEST_F(FigureVerb, SaysInOneSentenceThatAPlaceIsBesideTheObject) {
  for (const std::vector<std::string>& marks :
       {std::vector<std::string>{}, {"--without", "measurements"}}) {
    const CommandResult off =
        figure(test::joined({"--measure", "p:point:999,999", "-o", path("a.png")}, marks));
    EXPECT_EQ(off.exit_code, 1);
    EXPECT_NE(off.err.find("There is no surface at"), std::string::npos) << off.err;
    EXPECT_EQ(off.err.find("QPainter"), std::string::npos) << off.err;
    EXPECT_FALSE(fs::exists(path("a.png")));
  }
}

TEST_F(FigureVerb, NamesThePlaneOfWhatIsDrawn) {
  const CommandResult result =
      figure({"--measure", "rim:section:0,0,1,2.5", "--measure", "pit:area:20,20;40,20;40,40@1",
              "--caption", path("c.txt"), "-o", path("a.png")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string caption = bytesOf(path("c.txt"));
  EXPECT_NE(caption.find("Planes: section rim, level at 2.5 mm; volume of pit, level at 1 mm."),
            std::string::npos)
      << caption;
}

TEST_F(FigureVerb, ReplacesNothingThatIsNoFile) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const auto refused = [&](const std::vector<std::string>& words) {
    const CommandResult result = runRelievo(words, {"DISPLAY"});
    EXPECT_EQ(result.exit_code, 3) << words[0] << ": " << result.err;
    EXPECT_NE(result.err.find("no regular file"), std::string::npos) << result.err;
  };
  for (const char* ending : {".png", ".tif", ".pdf", ".svg", ".asc"}) {
    const std::string link = path(std::string("link") + ending);
    fs::create_symlink("pipe", link);
    const std::string scan = path("step.xyz");
    if (ending != std::string(".asc")) refused({"figure", scan, "-o", link});
    if (ending == std::string(".png") || ending == std::string(".tif")) {
      refused({"render", scan, "-o", link});
    }
    if (ending == std::string(".asc") || ending == std::string(".tif")) {
      refused({"convert", scan, link});
    }
    refused({"figure", scan, "--caption", link, "-o", path("a.png")});
    refused({"render", scan, "--caption", link, "-o", path("a.png")});
    EXPECT_TRUE(fs::is_symlink(link));
  }
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
  EXPECT_FALSE(fs::exists(path("a.png"))) << "nothing is drawn that could not be written";
}

TEST_F(FigureVerb, RefusesWhatItCannotDrawInWords) {
  EXPECT_EQ(figure({"--relief", "rainbow", "-o", path("a.png")}).exit_code, 1);
  EXPECT_EQ(figure({"--dpi", "9", "-o", path("a.png")}).exit_code, 1);
  EXPECT_EQ(figure({"--without", "sense", "-o", path("a.png")}).exit_code, 1);
  EXPECT_EQ(figure({"-o", path("a.jpg")}).exit_code, 1);
  EXPECT_EQ(
      figure({"--layout", "plot", "--recording", path("none.csv"), "-o", path("a.png")}).exit_code,
      2);
  EXPECT_EQ(runRelievo({"figure", "-o", path("a.png")}).exit_code, 1);
  std::ofstream(path("no.png")) << "no picture";
  EXPECT_EQ(runRelievo({"figure", "--from-image", path("no.png"), "-o", path("a.png")}).exit_code,
            2);
  for (const std::vector<std::string>& wrong : {
           std::vector<std::string>{"--range", "5,1"},
           {"--radius", "-1"},
           {"--light", "0,-20"},
           {"--scale", "2", "--width-mm", "85"},
           {"--heights", path("h.png")},
           {"--caption", path("a.png")},
           {"--stereo", "grey", "--zero-plane", "1e9"},
       }) {
    EXPECT_EQ(figure(test::joined(wrong, {"-o", path("a.png")})).exit_code, 1) << wrong[0];
  }
  EXPECT_FALSE(fs::exists(path("a.png")));
}

TEST_F(FigureVerb, SaysHowFarApartTheEyesOfItsFilesAre) {
  const CommandResult result = figure({"--layout", "detail", "--both-eyes", "-o", path("a.png")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_GT(report["eye_angle_deg"], 0);
  EXPECT_GT(report["parallax_deg"], 0);
  EXPECT_TRUE(fs::exists(path("a.left.png")));
  // Both verbs know both words.
  ASSERT_EQ(figure({"--stereo", "grey", "-o", path("grey.png")}).exit_code, 0);
  ASSERT_EQ(figure({"--stereo", "anaglyph", "-o", path("anaglyph.png")}).exit_code, 0);
  EXPECT_EQ(bytesOf(path("grey.png")), bytesOf(path("anaglyph.png")));
}

/// While it lives, what this process starts has no more address space.
class AddressSpace {
 public:
  explicit AddressSpace(rlim_t kilobytes) {
    ::getrlimit(RLIMIT_AS, &before_);
    const rlimit limit{.rlim_cur = kilobytes * 1024, .rlim_max = before_.rlim_max};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  ~AddressSpace() { ::setrlimit(RLIMIT_AS, &before_); }
  AddressSpace(const AddressSpace&) = delete;
  AddressSpace& operator=(const AddressSpace&) = delete;

 private:
  rlimit before_{};
};

class RenderVerb : public test::CommandTest {
 protected:
  CommandResult render(const std::vector<std::string>& more) const {
    return runRelievo(
        test::joined({"render", plane_, "--unit", "mm", "--view", "top", "--pixels", "64"}, more),
        {"DISPLAY"});
  }
  const std::string plane_ = plane();
};

TEST_F(RenderVerb, PaintsReliefImages) {
  ASSERT_EQ(render({"-o", path("lit.png")}).exit_code, 0);
  const CommandResult painted = render({"--relief", "slope", "--colours", "cividis", "--range",
                                        "0,20", "--caption", "-", "-o", path("a.png")});
  ASSERT_EQ(painted.exit_code, 0) << painted.err;
  EXPECT_NE(painted.out.find("Slope in cividis"), std::string::npos) << painted.out;
  EXPECT_NE(bytesOf(path("a.png")), bytesOf(path("lit.png")));
  ASSERT_EQ(runRelievo({"render", "--from-image", path("a.png"), "-o", path("b.png")}, {"DISPLAY"})
                .exit_code,
            0);
  EXPECT_EQ(bytesOf(path("a.png")), bytesOf(path("b.png")));
}

TEST_F(RenderVerb, WritesWhatTheEndingSaysOrNothing) {
  ASSERT_EQ(render({"-o", path("a.png")}).exit_code, 0);
  ASSERT_EQ(render({"-o", path("a.tif")}).exit_code, 0);
  EXPECT_EQ(bytesOf(path("a.tif")).substr(0, 2), "II");
  ASSERT_EQ(runRelievo({"render", "--from-image", path("a.tif"), "-o", path("b.png")}, {"DISPLAY"})
                .exit_code,
            0);
  EXPECT_EQ(bytesOf(path("a.png")), bytesOf(path("b.png")));
  EXPECT_EQ(render({"-o", path("a.jpg")}).exit_code, 1);
  EXPECT_FALSE(fs::exists(path("a.jpg")));
  EXPECT_EQ(render({"--stereo", "sidebyside", "-o", path("c.pdf")}).exit_code, 1);
  EXPECT_EQ(render({"--stereo", "beside", "-o", path("c.png")}).exit_code, 1);
  EXPECT_EQ(render({"--stereo", "grey", "--zero-plane", "1e9", "-o", path("c.png")}).exit_code, 1);
  EXPECT_FALSE(fs::exists(path("c.png")));
}

TEST_F(RenderVerb, DrawsTwoEyesPicturesOfTheSizeAskedFor) {
  const auto sizeOf = [&](const std::string& stereo, const std::string& pixels) {
    const CommandResult result =
        runRelievo({"render", plane_, "--unit", "mm", "--view", "top", "--stereo", stereo,
                    "--pixels", pixels, "--report", "json", "-o", path(stereo + ".png")},
                   {"DISPLAY"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const json report = json::parse(result.out, nullptr, false);
    EXPECT_EQ(report.value("stereo", ""), stereo);
    return report.value("pixels", std::vector<int>{});
  };
  EXPECT_EQ(sizeOf("sidebyside", "64"), (std::vector<int>{128, 64}));
  EXPECT_EQ(sizeOf("overunder", "64"), (std::vector<int>{64, 128}));
  EXPECT_EQ(sizeOf("sidebyside", "501"), (std::vector<int>{1002, 501}));
  EXPECT_EQ(sizeOf("overunder", "501"), (std::vector<int>{501, 1002}));
  const CommandResult again = runRelievo(
      {"render", "--from-image", path("overunder.png"), "-o", path("again.png")}, {"DISPLAY"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(bytesOf(path("again.png")), bytesOf(path("overunder.png")));
  ASSERT_EQ(render({"--stereo", "sidebyside", "-o", path("pair.png")}).exit_code, 0);
  ASSERT_EQ(render({"--stereo", "sidebyside", "--swap-eyes", "-o", path("swapped.png")}).exit_code,
            0);
  EXPECT_NE(bytesOf(path("pair.png")), bytesOf(path("swapped.png")));
  EXPECT_EQ(
      render({"--stereo", "sidebyside", "--zero-plane", "1e9", "-o", path("c.png")}).exit_code, 1);
  EXPECT_FALSE(fs::exists(path("c.png")));
}

TEST_F(RenderVerb, ValuesOfAReliefImageSayWhereTheyComeFrom) {
  for (const char* file : {"slope.tif", "map.tif"}) {
    std::vector<std::string> words{"convert", plane_, path(file), "--unit", "mm", "--view", "top"};
    const bool slope = file == std::string("slope.tif");
    if (slope) words.insert(words.end(), {"--relief", "slope"});
    ASSERT_EQ(runRelievo(words).exit_code, 0);
    const auto state = embeddedState(path(file));
    ASSERT_TRUE(state) << file;
    const Provenance from = provenanceFromJson(*state, file);
    EXPECT_EQ(from.input.sha256, sha256OfFile(plane_));
    EXPECT_EQ(from.version, RELIEVO_VERSION_STRING);
    ASSERT_EQ(from.values.has_value(), slope);
    if (slope) {
      EXPECT_EQ(from.values->kind, ReliefKind::slope);
    }
    const CommandResult drawn =
        runRelievo({"render", "--from-image", path(file), "-o", path("a.png")}, {"DISPLAY"});
    EXPECT_EQ(drawn.exit_code, 2);
    EXPECT_NE(drawn.err.find("shows no region"), std::string::npos) << drawn.err;
  }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // They reserve terabytes.
TEST_F(RenderVerb, SaysSoWhenMemoryIsTooLittleToDraw) {
  for (const char* verb : {"render", "figure"}) {
    for (const rlim_t kilobytes : {320000, 500000, 600000}) {
      const AddressSpace limit(kilobytes);
      const CommandResult result = runRelievo({verb, plane_, "-o", path("a.png")}, {"DISPLAY"});
      EXPECT_TRUE(result.exit_code == 7 || result.exit_code == 2) << result.exit_code;
      EXPECT_NE(result.err.find("not enough memory"), std::string::npos) << result.err;
      EXPECT_FALSE(fs::exists(path("a.png")));
    }
  }
}
#endif

TEST_F(RenderVerb, ConvertWritesTheValuesOfAReliefImage) {
  const auto convert = [this](const std::vector<std::string>& more) {
    return runRelievo(test::joined({"convert", plane_}, more)).exit_code;
  };
  ASSERT_EQ(convert({path("slope.asc"), "--unit", "mm", "--view", "top", "--relief", "slope"}), 0);
  std::istringstream values(bytesOf(path("slope.asc")));
  std::string word;
  for (int i = 0; i < 12; ++i) values >> word;  // Its head.
  double slope = 0;
  values >> slope;
  EXPECT_NEAR(slope, 5.7106, 1e-3) << "the arc tangent of 1/10";
  EXPECT_EQ(convert({path("slope.tif"), "--relief", "slope"}), 0);
  EXPECT_EQ(convert({path("slope.ply"), "--relief", "slope"}), 1);
  EXPECT_EQ(convert({path("lit.tif"), "--relief", "lit"}), 1);
  EXPECT_EQ(convert({path("lit.tif"), "--radius", "3"}), 1);
}

}  // namespace
}  // namespace relievo
