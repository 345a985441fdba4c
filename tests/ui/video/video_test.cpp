// SPDX-License-Identifier: BSD-3-Clause
// A video shows each frame's own time, loses nothing where it says so, and ends whole.
#include "ui/video/video.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "core/base/error.h"
#include "core/depth/rules/rasterize.h"
#include "core/io/raster/raster.h"
#include "core/provenance/embedded.h"
#include "ui/figure/figure.h"
#include "ui/video/live_video.h"
#include "ui/video/video_file.h"
#include "ui/video/video_frames.h"
#include "ui/vtk/files/picture_file.h"
#include "ui/vtk/files/read_picture.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

Scan makeScan() {
  Scan scan;
  for (int row = 0; row <= 160; ++row) {
    for (int col = 0; col <= 240; ++col) {
      const double x = 0.5 * col, y = 0.5 * row, d = std::hypot(x - 30, y - 35);
      const double dome = d < 20 ? 8 * (1 - d * d / 400) : 0;
      scan.points.push_back(
          {static_cast<float>(x), static_cast<float>(y), static_cast<float>(dome)});
    }
  }
  scan.info.points = scan.info.finite_points = scan.points.size();
  scan.info.format = "PLY";
  return scan;
}

/// One second over the dome; after half of it in another window.
TouchRecording makeRecording() {
  TouchRecording recording;
  recording.name = "touch.csv";
  for (int i = 0; i <= 1000; ++i) {
    TouchRow row;
    row.t_s = 3 + 0.001 * i;
    row.proxy = {15 + 0.03 * i, 35, 8};
    row.hip = row.proxy - ViewMm{0, 0, 0.5};
    row.force = {0, 0, 0.001 * i};
    row.contact = true;
    row.window_id = i < 500 ? 1 : 2;
    recording.rows.push_back(row);
  }
  recording.windows = {{1, {0, 5, 60, {0}}, 1, true}, {2, {20, 20, 30, {0}}, 1, true}};
  return recording;
}

std::string outputOf(const std::string& command) {
  std::string text;
  FILE* const pipe = ::popen(command.c_str(), "r");
  std::array<char, 65536> bytes{};
  for (std::size_t got = 0; (got = std::fread(bytes.data(), 1, bytes.size(), pipe)) > 0;) {
    text.append(bytes.data(), got);
  }
  EXPECT_EQ(::pclose(pipe), 0) << command;
  return text;
}

std::string textOf(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class VideoTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    SurfaceOptions options;
    options.unit = LengthUnit::mm;
    options.view = ViewChoice{"top", {}};
    options.spacing_mm = 0.5;
    surface_ = std::make_unique<Surface>(makeSurface(makeScan(), options, rasterize));
  }
  static void TearDownTestSuite() { surface_.reset(); }
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("relievo_video_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    request_.width_px = 240;
    request_.height_px = 160;
    request_.fps = 10;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path path(const std::string& name) const { return folder_ / name; }
  VideoFacts write(const std::string& name, const Task& task = {}) {
    return writeVideo(*surface_, &recording_, request_, R"({"made":"from this"})", path(name),
                      task);
  }
  std::string probed(const std::string& name, const std::string& entry) {
    return outputOf("ffprobe -v error -select_streams v -count_frames -show_entries " + entry +
                    " -of csv=p=0 '" + path(name).string() + "'");
  }
  std::string decoded(const std::string& name) {
    return outputOf("ffmpeg -v error -nostdin -i '" + path(name).string() +
                    "' -f rawvideo -pix_fmt rgb24 pipe:1");
  }
  std::vector<std::string> left() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  static std::string rgbOf(const RgbaImage& image) {
    std::string rgb;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
      if (i % 4 != 3) rgb += static_cast<char>(image.rgba[i]);
    }
    return rgb;
  }

  static std::unique_ptr<Surface> surface_;
  fs::path folder_;
  TouchRecording recording_ = makeRecording();
  VideoRequest request_;
};
std::unique_ptr<Surface> VideoTest::surface_;

TEST_F(VideoTest, FrameIShowsTheRecordingAtItsOwnTime) {
  const VideoTimes times = timesOf(request_, &recording_);
  EXPECT_EQ(times.frames, 11U) << "0, 0.1 ... 1 s";
  EXPECT_DOUBLE_EQ(times.ofFrame(7), 0.7);
  request_.speed = 0.25;
  request_.from_s = 0.5;
  EXPECT_EQ(timesOf(request_, &recording_).frames, 21U);
  EXPECT_DOUBLE_EQ(timesOf(request_, &recording_).ofFrame(4), 0.6);
  request_.from_s = 2;
  EXPECT_THROW(timesOf(request_, &recording_), ArgumentError);
}

TEST_F(VideoTest, AFrameDependsOnItsNumberAlone) {
  VideoFrames all(*surface_, &recording_, request_);
  std::vector<std::string> drawn;
  for (std::uint64_t i = 0; i < all.times().frames; ++i) drawn.push_back(rgbOf(all.draw(i)));
  VideoFrames one(*surface_, &recording_, request_);
  for (const std::uint64_t i : {8U, 2U, 5U, 4U}) {
    EXPECT_EQ(rgbOf(one.draw(i)), drawn[i]) << i;
  }
  for (std::size_t i = 1; i < drawn.size(); ++i) EXPECT_NE(drawn[i], drawn[i - 1]) << i;
}

TEST_F(VideoTest, TheProxyIsDrawnWhereItWas) {
  request_.plots = request_.overview = request_.scale_bar = false;
  request_.width_px = request_.height_px = 200;
  VideoFrames frames(*surface_, &recording_, request_);
  for (const std::uint64_t i : {0U, 3U, 7U}) {
    const RgbaImage& image = frames.draw(i);
    double x = 0, count = 0;
    for (std::size_t p = 0; p < image.rgba.size(); p += 4) {  // Red and blue, not stone.
      const int r = image.rgba[p], g = image.rgba[p + 1], b = image.rgba[p + 2];
      if (std::abs(r - g) < 60 && std::abs(b - g) < 60) continue;
      x += static_cast<double>(p / 4 % 200) + 0.5;
      ++count;
    }
    ASSERT_GT(count, 20) << i;
    const Region& r = recording_.windows[i < 5 ? 0 : 1].region;
    const double proxy_x = rowAt(recording_, 3 + 0.1 * static_cast<double>(i)).proxy.x;
    EXPECT_NEAR(x / count, (proxy_x - r.x_mm) / r.side_mm * 200, 3) << i;
  }
}

TEST_F(VideoTest, AnArchiveGivesEveryPixelBack) {
  request_.profile = VideoProfile::archive;
  const VideoFacts facts = write("archive.mp4");
  EXPECT_EQ(facts.frames, 11U);
  EXPECT_DOUBLE_EQ(facts.seconds, 1.1);
  std::string expected;
  VideoFrames frames(*surface_, &recording_, request_);
  for (std::uint64_t i = 0; i < 11; ++i) expected += rgbOf(frames.draw(i));
  EXPECT_EQ(decoded("archive.mp4"), expected);
  EXPECT_EQ(left(), (std::vector<std::string>{"archive.mp4", "archive.mp4.json"}));
}

TEST_F(VideoTest, EachProfileIsPackedForItsUse) {
  write("talk.mp4");
  EXPECT_EQ(probed("talk.mp4", "stream=codec_name,pix_fmt,color_space,nb_read_frames"),
            "h264,yuv420p,bt709,11\n");
  request_.profile = VideoProfile::anaglyph;
  request_.stereo = StereoPrint::half_colour;
  write("glasses.mp4");
  EXPECT_EQ(probed("glasses.mp4", "stream=pix_fmt,nb_read_frames"), "yuv444p,11\n");
  EXPECT_NE(outputOf("ffprobe -v error -show_entries format_tags=comment -of csv=p=0 '" +
                     path("glasses.mp4").string() + "'")
                .find("from this"),
            std::string::npos);
  request_.profile = VideoProfile::talk;
  EXPECT_THROW(check(request_), ArgumentError) << "an anaglyph with halved colours";
}

TEST_F(VideoTest, PairsAreOfTheWholeFrameAndGoIntoEveryProfileButRows) {
  request_.stereo = StereoPrint::side_by_side;
  request_.eye_angle_deg = 12;
  VideoFrames frames(*surface_, &recording_, request_);
  const RgbaImage pair = frames.draw(5);
  EXPECT_EQ(pair.width, request_.width_px);
  EXPECT_EQ(pair.height, request_.height_px);
  const auto at = [&pair](int x, int y) {
    return pair.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(pair.width) +
                          static_cast<std::size_t>(x)) +
                     1];
  };
  const int half = pair.width / 2;
  int in_relief = 0, beside = 0;
  for (int y = 0; y < pair.height; ++y) {
    for (int x = 0; x < half; ++x) {
      // The detail is square and stands at the left.
      const bool is_relief = 2 * x < pair.height;
      if (at(x, y) != at(x + half, y)) ++(is_relief ? in_relief : beside);
    }
  }
  EXPECT_GT(in_relief, 50) << "two eyes";
  EXPECT_EQ(beside, 0) << "plots lie in the plane of the screen";
  write("screen.mp4");
  EXPECT_EQ(probed("screen.mp4", "stream=pix_fmt,nb_read_frames"), "yuv420p,11\n");
  request_.stereo = StereoPrint::interlaced;
  EXPECT_THROW(check(request_), ArgumentError) << "halved colours mix the rows";
  request_.profile = VideoProfile::archive;
  EXPECT_NO_THROW(check(request_));
}

TEST_F(VideoTest, EachEyeHasItsHalfAboveTheOthersOrItsRows) {
  const auto at = [](const RgbaImage& image, int x, int y) {
    return image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x)) +
                      1];
  };
  request_.profile = VideoProfile::archive;
  request_.eye_angle_deg = 12;
  request_.stereo = StereoPrint::interlaced;
  VideoFrames rows(*surface_, &recording_, request_);
  rows.keepEyes();
  const RgbaImage woven = rows.draw(5);
  const RgbaImage left = rows.ofEye(FigureEye::left);
  const RgbaImage right = rows.ofEye(FigureEye::right);
  ASSERT_EQ(woven.height, left.height);
  int not_its_eyes = 0, two_eyes = 0;
  for (int y = 0; y < woven.height; ++y) {
    for (int x = 0; x < woven.width; ++x) {
      not_its_eyes += at(woven, x, y) != at(y % 2 == 0 ? left : right, x, y) ? 1 : 0;
      two_eyes += at(left, x, y) != at(right, x, y) ? 1 : 0;
    }
  }
  EXPECT_EQ(not_its_eyes, 0);
  EXPECT_GT(two_eyes, 100);
  write("rows.mp4");
  EXPECT_EQ(probed("rows.mp4", "stream=nb_read_frames"), "11\n");

  request_.stereo = StereoPrint::over_under;
  VideoFrames halves(*surface_, &recording_, request_);
  const RgbaImage pair = halves.draw(5);
  EXPECT_EQ(pair.height, request_.height_px);
  const int half = pair.height / 2;
  int in_relief = 0, beside = 0, far_apart = 0;
  for (int y = 0; y < half; ++y) {
    for (int x = 0; x < pair.width; ++x) {
      const int apart = std::abs(at(pair, x, y) - at(pair, x, y + half));
      if (apart > 0) ++(x < pair.height ? in_relief : beside);
      far_apart += apart > 100 ? 1 : 0;
    }
  }
  EXPECT_GT(in_relief, 50) << "two eyes";
  EXPECT_EQ(beside, 0) << "plots lie in the plane of the screen";
  EXPECT_LT(far_apart, half * pair.width / 20) << "the same place";
}

TEST_F(VideoTest, BothEyesAreFilesOfTheirOwnOfWhichTheGreyVideoIsMixed) {
  request_.profile = VideoProfile::images;
  request_.stereo = StereoPrint::grey;
  request_.eye_angle_deg = 12;
  const VideoFiles files{.video = path("both"), .both_eyes = true};
  ASSERT_EQ(namesOf(files), (std::vector{path("both.left"), path("both.right"), path("both")}));
  const auto state = [](const VideoRequest& one) {
    return R"({"eye":")" + std::string(name(one.eye)) + "\"}";
  };
  const VideoFacts facts = writeVideo(*surface_, &recording_, request_, state, files);
  EXPECT_EQ(facts.frames, 11U);
  const auto frame = [&](const char* folder) {
    return readPixelsHere(path(folder) / "frame_000004.png").value();
  };
  const StoredPixels left = frame("both.left"), right = frame("both.right"), mixed = frame("both");
  EXPECT_NE(left.bytes, right.bytes);
  for (const auto& [eye, file] :
       {std::pair{FigureEye::left, &left}, std::pair{FigureEye::right, &right}}) {
    VideoRequest one = request_;
    one.eye = eye;
    VideoFrames alone(*surface_, &recording_, one);
    const std::string rgb = rgbOf(alone.draw(3));
    EXPECT_EQ(std::string(file->bytes.begin(), file->bytes.end()), rgb) << name(eye);
  }
  // Below the legend the detail, square and at the left, is exactly the two mixed; the rest is the
  // same in all.
  std::vector<std::uint8_t> made(left.bytes.begin(), left.bytes.end());
  const std::vector<std::uint8_t> other(right.bytes.begin(), right.bytes.end());
  mixAnaglyph(request_.stereo, made, other, 3);
  const auto row_bytes = static_cast<std::size_t>(3 * mixed.width);
  const auto detail_bytes = static_cast<std::size_t>(3 * mixed.height);
  int different = 0;
  for (std::size_t y = 0; y < static_cast<std::size_t>(mixed.height); ++y) {
    for (std::size_t i = y * row_bytes; i < (y + 1) * row_bytes; ++i) {
      const bool is_detail = i - y * row_bytes < detail_bytes;
      if (is_detail && y < 40) continue;
      const int expected = is_detail ? made[i] : left.bytes[i];
      if (mixed.bytes[i] != expected) ++different;
    }
  }
  EXPECT_EQ(different, 0);
  EXPECT_EQ(textOf(path("both.left.json")), "{\"eye\":\"left\"}\n");
  EXPECT_EQ(textOf(path("both.json")), "{\"eye\":\"both\"}\n");
}

TEST_F(VideoTest, CancelLeavesNoVideoOfAnyEye) {
  request_.profile = VideoProfile::images;
  std::stop_source stop;
  Task task{stop.get_token(), [&](std::string_view, double fraction) {
              if (fraction > 0.3) stop.request_stop();
            }};
  EXPECT_THROW(writeVideo(
                   *surface_, &recording_, request_, [](const VideoRequest&) { return "{}"; },
                   VideoFiles{.video = path("both"), .both_eyes = true}, task),
               Cancelled);
  EXPECT_EQ(left(), std::vector<std::string>{});
}

TEST_F(VideoTest, AGreyVideoSaysWhichMarkIsTheHand) {
  request_.profile = VideoProfile::images;
  request_.width_px = 640;
  request_.height_px = 480;
  request_.stereo = StereoPrint::grey;
  request_.plots = request_.overview = false;
  const auto paper = [](const RgbaImage& image) {  // Nearly white pixels of the upper right corner.
    int found = 0;
    for (int y = 0; y < 60; ++y) {
      for (int x = 400; x < 640; ++x) {
        const auto at = 4 * (static_cast<std::size_t>(y) * 640 + static_cast<std::size_t>(x));
        if (image.rgba[at] > 225 && image.rgba[at + 1] > 225) ++found;
      }
    }
    return found;
  };
  VideoFrames grey(*surface_, &recording_, request_);
  const RgbaImage with = grey.draw(2);
  const fs::path folder = RELIEVO_BINARY_DIR "/screenshots";
  fs::create_directories(folder);
  writePng(folder / "video_hand_legend.png", with, 96, {});
  request_.stereo = StereoPrint::half_colour;
  VideoFrames coloured(*surface_, &recording_, request_);
  EXPECT_GT(paper(with), paper(coloured.draw(2)) + 2000);
}

TEST_F(VideoTest, ImagesNeedNoOtherProgramAndCarryTheirState) {
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", path("nothing").c_str(), 1);
  try {
    write("talk.mp4");
    ADD_FAILURE() << "without ffmpeg";
  } catch (const WriteError& error) {
    EXPECT_NE(std::string(error.what()).find("profile images"), std::string::npos);
  }
  EXPECT_FALSE(haveFfmpeg());
  request_.profile = VideoProfile::images;
  EXPECT_EQ(write("frames").frames, 11U);
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_TRUE(fs::exists(path("frames") / "frame_000011.png"));
  EXPECT_EQ(embeddedState(path("frames") / "frame_000003.png"), R"({"made":"from this"})");
  EXPECT_THROW(write("frames"), WriteError) << "nothing is written over";
}

TEST_F(VideoTest, CancelLeavesNothing) {
  for (const VideoProfile profile : {VideoProfile::talk, VideoProfile::images}) {
    request_.profile = profile;
    std::stop_source stop;
    const Task task{stop.get_token(), [&](std::string_view, double part) {
                      if (part > 0.3) stop.request_stop();
                    }};
    EXPECT_THROW(write("cancelled.mp4", task), Cancelled);
    EXPECT_TRUE(left().empty()) << left().front();
  }
}

/// A file that may not grow beyond a size is as good as a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, old_handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_{};
  void (*old_handler_)(int);
};

TEST_F(VideoTest, CancelNeedsNotWaitForTheScenesNorForAFrame) {
  std::stop_source stop;
  const Task task{stop.get_token(), {}};
  VideoFrames frames(*surface_, &recording_, request_, task);
  frames.draw(0);
  stop.request_stop();
  EXPECT_THROW(frames.draw(1), Cancelled);
  EXPECT_THROW(VideoFrames(*surface_, &recording_, request_, task), Cancelled);
}

TEST_F(VideoTest, AFullDiskEndsInACompleteFile) {
  request_.profile = VideoProfile::archive;
  std::string said;
  {
    const SmallDisk disk(60'000);
    try {
      request_.speed = 0.05;
      write("full.mp4");
    } catch (const WriteError& error) {
      said = error.what();
      EXPECT_EQ(error.code, "E401");
    }
  }
  ASSERT_NE(said.find("saved and complete"), std::string::npos) << said;
  EXPECT_EQ(left(), (std::vector<std::string>{"full.mp4", "full.mp4.json"}));
  const std::string pixels = decoded("full.mp4");
  const std::size_t frame = 240 * 160 * 3;
  ASSERT_EQ(pixels.size() % frame, 0U);
  EXPECT_NE(said.find("(" + std::to_string(pixels.size() / frame) + " frames)"), std::string::npos)
      << said;
  VideoFrames frames(*surface_, &recording_, request_);
  EXPECT_EQ(pixels.substr(0, frame), rgbOf(frames.draw(0)));
  EXPECT_EQ(pixels.substr(pixels.size() - frame), rgbOf(frames.draw(pixels.size() / frame - 1)));
}

TEST_F(VideoTest, AFullDiskKeepsTheImagesThatAreWhole) {
  request_.profile = VideoProfile::images;
  const SmallDisk disk(3000);
  EXPECT_THROW(write("frames"), WriteError);
}

RgbaImage plain(int width, int height, std::uint8_t grey) {
  RgbaImage image{width, height, {}};
  image.rgba.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), grey);
  return image;
}

TEST_F(VideoTest, LivePicturesNeverWaitAreCountedIfDroppedAndKeepTheirTime) {
  LiveVideo live(path("live.mp4"), {VideoProfile::archive, 640, 480, 10, "{}", "live"});
  live.offer(plain(640, 480, 10), 0);
  live.offer(plain(640, 480, 20), 0.01);  // Of the same frame.
  live.offer(plain(640, 480, 30), 0.35);
  for (int i = 0; i < 40; ++i) live.offer(plain(640, 480, 40), 0.4 + 0.1 * i);
  live.finish();
  while (!live.report().ended) std::this_thread::yield();
  const LiveVideo::Report report = live.report();
  EXPECT_EQ(report.error, "");
  EXPECT_GT(report.dropped, 0U) << "40 pictures at once";
  const std::string pixels = decoded("live.mp4");
  ASSERT_EQ(pixels.size(), report.frames * 640 * 480 * 3);
  const auto greyOf = [&](std::size_t frame) {
    return static_cast<int>(static_cast<unsigned char>(pixels[frame * 640 * 480 * 3]));
  };
  EXPECT_EQ(greyOf(0), 10);
  EXPECT_EQ(greyOf(2), 10) << "nothing came: the one before stands";
  EXPECT_EQ(greyOf(3), 30);
  EXPECT_EQ(greyOf(4), 40);
}

/// Of the programs that this process has started, the encoder's.
std::vector<int> nicenessOfChildren() {
  std::vector<int> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "stat");
    std::string stat;
    std::getline(file, stat);
    int parent = 0;
    char state = 0;
    std::istringstream after_name(stat.substr(stat.rfind(')') + 1));
    if (!(after_name >> state >> parent) || parent != ::getpid()) continue;
    const int child = std::stoi(entry.path().filename());
    found.push_back(::getpriority(PRIO_PROCESS, static_cast<id_t>(child)));
  }
  return found;
}

TEST_F(VideoTest, ALiveVideoIsPackedInTheBackground) {
  const int before = ::getpriority(PRIO_PROCESS, 0);
  if (before >= 5) GTEST_SKIP() << "this process already runs in the background";
  LiveVideo live(path("live.mp4"), {VideoProfile::talk, 64, 64, 10, "{}", "live"});
  std::vector<int> seen;
  live.offer(
      [&] {
        seen = nicenessOfChildren();
        seen.push_back(::getpriority(PRIO_PROCESS, 0));
        return plain(64, 64, 10);
      },
      0);
  live.finish();
  while (!live.report().ended) std::this_thread::yield();
  ASSERT_EQ(seen.size(), 2U) << "one encoder";
  EXPECT_EQ(seen, (std::vector<int>{5, 5}));
  EXPECT_EQ(::getpriority(PRIO_PROCESS, 0), before);
}

TEST_F(VideoTest, ALiveVideoThatIsNotFinishedLeavesNothingAndAFullDiskSaysSo) {
  { const LiveVideo live(path("left.mp4"), {VideoProfile::talk, 64, 64, 10, "{}", "left"}); }
  EXPECT_TRUE(left().empty());
  const SmallDisk disk(2000);
  LiveVideo live(path("full.mp4"), {VideoProfile::archive, 64, 64, 10, "{}", "full"});
  std::uint8_t grey = 0;
  for (int i = 0; !live.report().ended; ++i) {
    RgbaImage noise = plain(64, 64, 0);
    for (std::uint8_t& byte : noise.rgba)
      byte = grey = static_cast<std::uint8_t>(grey * 5 + 77 + i);
    live.offer(std::move(noise), 0.1 * i);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // As a camera's pictures come.
  }
  EXPECT_NE(live.report().error.find("Video stopped"), std::string::npos) << live.report().error;
  EXPECT_EQ(live.report().code, "E401");
}

TEST_F(VideoTest, ACameraPathNeedsNoRecording) {
  KeyView from{0, {}}, to{1, {}};
  from.view.region = {0, 0, 80, {0}};
  to.view.region = {20, 25, 20, {0}};
  to.view.elevation_deg = -30;
  request_.path = CameraPath{"closer", {from, to}};
  request_.overview = false;
  VideoFrames frames(*surface_, nullptr, request_);
  EXPECT_EQ(frames.times().frames, 11U);
  const std::string first = rgbOf(frames.draw(0));
  const std::string middle = rgbOf(frames.draw(5));
  EXPECT_NE(first, middle);
  VideoFrames again(*surface_, nullptr, request_);
  EXPECT_EQ(rgbOf(again.draw(5)), middle) << "also where the map was cut anew in between";
}

}  // namespace
}  // namespace relievo
