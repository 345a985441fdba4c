// SPDX-License-Identifier: BSD-3-Clause
// What is said of a video that cannot be made as it was asked for.
#include "core/replay/video_request.h"

#include <gtest/gtest.h>

#include <string>

#include "core/base/error.h"

namespace relievo {
namespace {

/// From 2 s to 6 s on its own clock.
TouchRecording fourSeconds() {
  TouchRecording recording;
  for (int i = 0; i <= 40; ++i) {
    TouchRow row;
    row.t_s = 2 + 0.1 * i;
    recording.rows.push_back(row);
  }
  return recording;
}

template <class Ask>
std::string refused(const Ask& ask) {
  try {
    ask();
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "nothing was refused";
}

VideoRequest part(double from_s, double to_s) {
  VideoRequest request;
  request.from_s = from_s;
  request.to_s = to_s;
  return request;
}

TEST(VideoRequest, SaysHowLongTheRecordingIsWhereNothingOfItIsAskedFor) {
  const TouchRecording recording = fourSeconds();
  EXPECT_EQ(refused([&] { timesOf(part(9, 12.5), &recording); }),
            "There is nothing between 9 s and 12.5 s: the recording is 4 s long. Nothing was "
            "made.");
  EXPECT_EQ(refused([&] { timesOf(part(3, 2), &recording); }),
            "There is nothing between 3 s and 2 s: the recording is 4 s long. Nothing was made.");
  VideoRequest along = part(9, 12);
  along.path.emplace();
  along.path->keys.resize(2);
  along.path->keys.back().t_s = 2.5;
  EXPECT_EQ(refused([&] { timesOf(along, nullptr); }),
            "There is nothing between 9 s and 12 s: the camera path is 2.5 s long. Nothing was "
            "made.");
}

TEST(VideoRequest, SaysWhatOfAPartIsNotThere) {
  const TouchRecording recording = fourSeconds();
  EXPECT_EQ(whatIsCut(part(3, 8), &recording),
            "The part from 3 s to 8 s is cut to 3 s to 4 s: the recording is 4 s long.");
  EXPECT_EQ(whatIsCut(part(-1, 2), &recording),
            "The part from -1 s to 2 s is cut to 0 s to 2 s: the recording is 4 s long.");
  EXPECT_EQ(whatIsCut(part(0, 4), &recording), "");
  EXPECT_EQ(whatIsCut({}, &recording), "");
}

TEST(VideoRequest, NamesLimitsInTheUnitOfTheirOptions) {
  VideoRequest request;
  request.speed = 0;
  EXPECT_EQ(refused([&] { check(request); }),
            "A video's speed must be 0.01 to 100. Nothing was made.");
  request.speed = 101;
  EXPECT_NE(refused([&] { check(request); }).find("0.01 to 100"), std::string::npos);
  for (const double speed : {0.01, 100.0}) {
    request.speed = speed;
    EXPECT_NO_THROW(check(request));
  }
  request.eye_angle_deg = 61;
  EXPECT_EQ(refused([&] { check(request); }),
            "A video's angle between the eyes in degrees must be 0.01 to 60. Nothing was made.");
  request.eye_angle_deg = 4;
  request.width_px = 5000;
  EXPECT_EQ(refused([&] { check(request); }),
            "A video's width in pixels must be 64 to 4096. Nothing was made.");
}

}  // namespace
}  // namespace relievo
