// SPDX-License-Identifier: BSD-3-Clause
// A video sounds at its pictures' times, from the first to the last one, and as it was given.
#include "ui/video/video_sound.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "core/depth/rules/rasterize.h"
#include "ui/figure/figure.h"
#include "ui/video/video.h"
#include "ui/video/video_file.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

constexpr int kFps = 10;

Surface makeStep() {
  Scan scan;
  for (int row = 0; row <= 80; ++row) {
    for (int col = 0; col <= 80; ++col) {
      scan.points.push_back(
          {static_cast<float>(col), static_cast<float>(row), col > 40 ? 3.0F : 0.0F});
    }
  }
  scan.info.points = scan.info.finite_points = scan.points.size();
  scan.info.format = "PLY";
  SurfaceOptions options;
  options.unit = LengthUnit::mm;
  options.view = ViewChoice{"top", {}};
  options.spacing_mm = 1;
  return makeSurface(scan, options, rasterize);
}

/// Two seconds: at 10 pictures a second 21 of them, which last 2.1 s.
TouchRecording makeRecording() {
  TouchRecording recording;
  recording.name = "touch.csv";
  for (int i = 0; i <= 200; ++i) {
    TouchRow row;
    row.t_s = 3 + 0.01 * i;
    row.proxy = row.hip = {20 + 0.2 * i, 40, 1};
    row.window_id = 1;
    recording.rows.push_back(row);
  }
  recording.windows = {{1, {10, 10, 60, {0}}, 1, true}};
  return recording;
}

void addSample(std::string& bytes, int value) {
  const auto bits = static_cast<std::uint16_t>(static_cast<std::int16_t>(value));
  bytes += static_cast<char>(bits & 0xFFU);
  bytes += static_cast<char>(bits >> 8U);
}

/// Left and right are different, and nothing comes twice.
std::string noise(std::size_t frames) {
  std::string bytes;
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < 2 * frames; ++i) {
    state = state * 1664525U + 1013904223U;
    addSample(bytes, static_cast<int>(state >> 17U) - 16384);
  }
  return bytes;
}

/// Short tones at these times, silence between them.
std::string clicks(double seconds, const std::vector<double>& times_s, int rate_hz) {
  std::string bytes;
  for (int i = 0; i < static_cast<int>(seconds * rate_hz); ++i) {
    double value = 0;
    for (const double time_s : times_s) {
      const double after_s = static_cast<double>(i) / rate_hz - time_s;
      if (after_s >= 0) value += 20000 * std::exp(-after_s / 0.004) * std::sin(12000 * after_s);
    }
    for (int side = 0; side < 2; ++side) addSample(bytes, static_cast<int>(value));
  }
  return bytes;
}

SoundTrack trackOf(std::string bytes, int rate_hz = 48000) {
  SoundTrack track;
  track.rate_hz = rate_hz;
  track.frames = bytes.size() / 4;
  track.render = [bytes = std::move(bytes)](const auto& take, const Task& task) {
    constexpr std::size_t kAtOnce = 5000;  // No round number.
    for (std::size_t at = 0; at < bytes.size(); at += kAtOnce) {
      task.check();
      take(std::string_view(bytes).substr(at, kAtOnce));
    }
  };
  return track;
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

/// Where sound begins after silence, in seconds.
std::vector<double> onsetsIn(const std::string& bytes, int rate_hz) {
  std::vector<double> onsets;
  std::size_t silent = bytes.size();
  for (std::size_t i = 0; 4 * i + 1 < bytes.size(); ++i) {
    const auto low = static_cast<unsigned char>(bytes[4 * i]);
    const auto high = static_cast<unsigned char>(bytes[4 * i + 1]);
    ++silent;
    if (std::abs(static_cast<std::int16_t>(low | high << 8)) < 4000) continue;
    if (silent > static_cast<std::size_t>(rate_hz) / 20) {
      onsets.push_back(static_cast<double>(i) / rate_hz);
    }
    silent = 0;
  }
  return onsets;
}

class VideoSoundTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { surface_ = std::make_unique<Surface>(makeStep()); }
  static void TearDownTestSuite() { surface_.reset(); }
  void SetUp() override {
    if (!haveFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    folder_ = fs::temp_directory_path() / ("relievo_video_sound_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    request_.width_px = 160;
    request_.height_px = 96;
    request_.fps = kFps;
    request_.plots = request_.overview = false;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path path(const std::string& name) const { return folder_ / name; }
  VideoFacts write(const std::string& name, const SoundTrack* sound, const Task& task = {},
                   bool both_eyes = false) {
    const auto state = [](const VideoRequest& one) { return videoState({}, one, {}); };
    return writeVideo(*surface_, &recording_, request_, state,
                      {.video = path(name), .both_eyes = both_eyes, .sound = sound}, task);
  }
  std::string heard(const std::string& name) const {
    return outputOf("ffmpeg -v error -nostdin -i '" + path(name).string() +
                    "' -map 0:a -f s16le pipe:1");
  }
  std::string probed(const std::string& name, const std::string& entries) const {
    return outputOf("ffprobe -v error -show_entries " + entries + " -of csv=p=0 '" +
                    path(name).string() + "'");
  }
  std::string stateBeside(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name + ".json")).rdbuf();
    return text.str();
  }
  std::size_t filesLeft() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  static std::unique_ptr<Surface> surface_;
  fs::path folder_;
  TouchRecording recording_ = makeRecording();
  VideoRequest request_;
};
std::unique_ptr<Surface> VideoSoundTest::surface_;

TEST_F(VideoSoundTest, AnArchiveGivesEverySampleBackAsLongAsThereArePictures) {
  request_.profile = VideoProfile::archive;
  const std::string given = noise(48000 * 22 / 10);  // A tenth of a second more.
  const SoundTrack longer = trackOf(given);
  EXPECT_EQ(write("longer.mp4", &longer).frames, 21U);
  EXPECT_EQ(heard("longer.mp4"), given.substr(0, 4 * 48000 * 21 / 10));
  EXPECT_EQ(probed("longer.mp4", "stream=codec_name,sample_rate,channels,start_time,duration"),
            "h264,0.000000,2.100000\nalac,48000,2,0.000000,2.100000\n");
  const std::string half = given.substr(0, 4 * 48000);
  const SoundTrack shorter = trackOf(half);
  write("shorter.mp4", &shorter);
  EXPECT_EQ(heard("shorter.mp4"), half + std::string(4 * 48000 * 11 / 10, '\0'));
  EXPECT_EQ(filesLeft(), 4U) << "two videos and what they were made from";
}

TEST_F(VideoSoundTest, WhatIsHeardInATalkIsHeardWithItsPicture) {
  const std::vector<double> times_s{0.05, 0.7, 1.33, 1.95};
  const SoundTrack track = trackOf(clicks(2.2, times_s, 48000));
  write("talk.mp4", &track);
  const std::vector<double> onsets = onsetsIn(heard("talk.mp4"), 48000);
  ASSERT_EQ(onsets.size(), times_s.size());
  for (std::size_t i = 0; i < onsets.size(); ++i) EXPECT_NEAR(onsets[i], times_s[i], 0.003) << i;
  std::istringstream lines(probed("talk.mp4", "stream=start_time,duration"));
  for (int stream = 0; stream < 2; ++stream) {
    double start_s = -1, length_s = 0;
    char comma = 0;
    lines >> start_s >> comma >> length_s;
    EXPECT_EQ(start_s, 0) << stream;
    EXPECT_NEAR(length_s, 2.1, 0.005) << stream;
  }
  EXPECT_EQ(probed("talk.mp4", "stream=codec_name"), "h264\naac\n");
}

TEST_F(VideoSoundTest, EachEyesVideoSoundsTheSameAndSaysSo) {
  request_.profile = VideoProfile::archive;
  const SoundTrack track = trackOf(noise(48000));
  write("eyes.mp4", &track, {}, true);
  const std::string whole = heard("eyes.mp4");
  EXPECT_EQ(whole.size(), 4U * 48000 * 21 / 10);
  EXPECT_EQ(heard("eyes.left.mp4"), whole);
  EXPECT_EQ(heard("eyes.right.mp4"), whole);
  EXPECT_NE(stateBeside("eyes.left.mp4").find(R"("sound":"alac")"), std::string::npos)
      << stateBeside("eyes.left.mp4");
}

TEST_F(VideoSoundTest, WithoutSoundThereIsNoTrackAndNoWordOfIt) {
  write("silent.mp4", nullptr);
  EXPECT_EQ(probed("silent.mp4", "stream=codec_name"), "h264\n");
  EXPECT_EQ(stateBeside("silent.mp4").find("sound"), std::string::npos);
  request_.profile = VideoProfile::images;
  const SoundTrack track = trackOf(noise(48000));
  EXPECT_EQ(write("frames", &track).frames, 21U);
  EXPECT_EQ(stateBeside("frames").find("sound"), std::string::npos);
}

TEST_F(VideoSoundTest, OnePictureIsEnough) {
  request_.to_s = 0;
  const SoundTrack track = trackOf(clicks(0.3, {0.01}, 48000));
  EXPECT_EQ(write("one.mp4", &track).frames, 1U);
  EXPECT_EQ(onsetsIn(heard("one.mp4"), 48000).size(), 1U);
}

TEST_F(VideoSoundTest, CancelWhileTheSoundIsMadeLeavesNothing) {
  std::stop_source stop;
  SoundTrack endless = trackOf(noise(48000));
  endless.render = [&stop, render = endless.render](const auto& take, const Task& task) {
    render(take, task);
    stop.request_stop();
    render(take, task);
  };
  EXPECT_THROW(write("cancelled.mp4", &endless, {stop.get_token(), {}}), Cancelled);
  EXPECT_EQ(filesLeft(), 0U);
}

TEST_F(VideoSoundTest, AFullDiskEndsInACompleteFileWithItsSound) {
  request_.profile = VideoProfile::archive;
  request_.speed = 0.25;  // Eight seconds.
  constexpr int kRateHz = 8000;
  const std::string given = noise(kRateHz * 9);
  const SoundTrack track = trackOf(given, kRateHz);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  // Room for the samples alone, which take no less when packed: they are noise.
  const rlimit limit{4 * kRateHz * 82 / 10, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::string said;
  try {
    write("full.mp4", &track);
  } catch (const WriteError& error) {
    said = error.what();
    EXPECT_EQ(error.code, "E401");
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  ASSERT_NE(said.find("saved and complete"), std::string::npos) << said;
  const std::string kept = heard("full.mp4");
  const std::string frames = outputOf(
      "ffprobe -v error -select_streams v -count_frames -show_entries "
      "stream=nb_read_frames -of csv=p=0 '" +
      path("full.mp4").string() + "'");
  const int pictures = std::stoi(frames);
  EXPECT_GT(pictures, 10);
  EXPECT_LT(pictures, 81);
  EXPECT_NE(said.find("(" + std::to_string(pictures) + " frames)"), std::string::npos) << said;
  EXPECT_NEAR(static_cast<double>(kept.size()) / 4 / kRateHz, 1.0 * pictures / kFps, 1.0)
      << "packets that were complete";
  EXPECT_EQ(kept, given.substr(0, kept.size()));
}

TEST_F(VideoSoundTest, ADiskWithoutRoomForTheSamplesLeavesNothing) {
  const SoundTrack track = trackOf(noise(48000 * 2));
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit limit{100'000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  EXPECT_THROW(write("full.mp4", &track), WriteError);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_EQ(filesLeft(), 0U);
}

TEST(SoundOfAVideo, IsMadeOfRecordingsAloneAndWhyThereIsNoneIsKept) {
  const TouchRecording recording = makeRecording();
  VideoRequest request;
  int asked = 0;
  const SoundTrackOf make = [&](const TouchRecording& of, const VideoRequest& by) {
    ++asked;
    EXPECT_EQ(&of, &recording);
    EXPECT_EQ(&by, &request);
    return trackOf("12345678");
  };
  EXPECT_TRUE(soundOf(request, &recording, make).track);
  EXPECT_FALSE(soundOf(request, nullptr, make).track) << "a camera path";
  EXPECT_FALSE(soundOf(request, &recording, {}).track) << "nothing can make it";
  request.profile = VideoProfile::images;
  EXPECT_FALSE(soundOf(request, &recording, make).track);
  request.profile = VideoProfile::archive;
  request.sound = false;
  EXPECT_FALSE(soundOf(request, &recording, make).track);
  EXPECT_EQ(asked, 1);
  request.sound = true;
  const VideoSound none = soundOf(
      request, &recording,
      [](const TouchRecording&, const VideoRequest&) -> SoundTrack { throw FileError("Old."); });
  EXPECT_FALSE(none.track);
  ASSERT_TRUE(none.missing);
  EXPECT_STREQ(none.missing->what(), "Old.");
}

}  // namespace
}  // namespace relievo
