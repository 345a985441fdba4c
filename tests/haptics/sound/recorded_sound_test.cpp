// SPDX-License-Identifier: BSD-3-Clause
// What is heard of a recording is what is in it: clicks at the frame of their contact and as loud
// as its speed, pitch, place and rustling by their laws, each happening once, and nothing else.
#include "haptics/sound/recorded_sound.h"

#include <array>
#include <string>

#include "core/base/error.h"
#include "tests/haptics/sound/sound_test.h"

namespace relievo::sound {
namespace {

using test::cents;
using test::framesOf;
using test::leftOf;
using test::pitchHz;
using test::powerBetween;
using test::recordingOf;
using test::rms;

const double kHalf = std::sqrt(0.5);  // Of each side, in the middle.

std::uint64_t struck(const RecordedSound::Summary& summary, Earcon earcon) {
  return summary.struck[static_cast<std::size_t>(earcon)];
}

std::uint64_t struckInAll(const RecordedSound::Summary& summary) {
  std::uint64_t count = 0;
  for (const std::uint64_t one : summary.struck) count += one;
  return count;
}

/// No tone: what happens is heard alone.
SoundRequest withoutTone() {
  SoundRequest request;
  request.synth.tone_for_s = 0;
  return request;
}

/// The first frames that are heard after a twentieth of a second of silence.
std::vector<std::size_t> onsetsIn(const std::vector<Frame>& frames) {
  std::vector<std::size_t> onsets;
  std::size_t silent = kSampleRateHz;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (std::abs(frames[i].left) < 1e-4 && std::abs(frames[i].right) < 1e-4) {
      ++silent;
      continue;
    }
    if (silent > kSampleRateHz / 20) onsets.push_back(i);
    silent = 0;
  }
  return onsets;
}

/// Taps, one every 0.3 s: the hand comes down with a speed of its own, stays 0.1 s, and leaves.
struct Tap {
  double at_s, speed_mm_per_s;
};
std::vector<Tap> taps() {
  std::vector<Tap> all;
  for (int i = 0; i < 13; ++i) all.push_back({0.2 + 0.3 * i, 20 + 30.0 * i});
  return all;
}
TouchRecording tapping() {
  return recordingOf(4.5, [](TouchRow& row) {
    row.hand_hip = {40, 40, 30};
    for (const Tap& tap : taps()) {
      const double before_s = tap.at_s - row.t_s;
      if (before_s < -0.1 - 1e-9 || before_s > 0.05) continue;
      row.contact = before_s <= 1e-9;
      row.hand_hip.z = tap.speed_mm_per_s * std::max(0.0, before_s);
    }
  });
}

TEST(RecordedSound, AClickBeginsInTheFrameOfItsContactAndNoOtherDoes) {
  RecordedSound::Summary summary;
  const TouchRecording recording = tapping();
  const std::vector<Frame> frames = framesOf(RecordedSound(recording, withoutTone()), &summary);
  const std::vector<std::size_t> onsets = onsetsIn(frames);
  ASSERT_EQ(onsets.size(), taps().size());
  EXPECT_EQ(struck(summary, Earcon::contact), taps().size());
  EXPECT_EQ(struckInAll(summary), taps().size());
  for (std::size_t i = 0; i < onsets.size(); ++i) {
    EXPECT_EQ(onsets[i], static_cast<std::size_t>(std::lround(taps()[i].at_s * kSampleRateHz)));
  }
}

TEST(RecordedSound, AtAnotherSpeedAClickComesAtItsTimeAndIsTheSame) {
  const TouchRecording recording = tapping();
  const std::vector<Frame> once = framesOf(RecordedSound(recording, withoutTone()));
  const std::vector<std::size_t> as_it_was = onsetsIn(once);
  for (const double speed : {0.25, 0.02, 2.0}) {
    SoundRequest request = withoutTone();
    request.speed = speed;
    const RecordedSound sound(recording, request);
    EXPECT_NEAR(sound.seconds(), 4.5 / speed + 0.2, 1e-4);
    const std::vector<Frame> frames = framesOf(sound);
    const std::vector<std::size_t> onsets = onsetsIn(frames);
    ASSERT_EQ(onsets.size(), taps().size()) << speed;
    for (std::size_t i = 0; i < onsets.size(); ++i) {
      EXPECT_EQ(onsets[i],
                static_cast<std::size_t>(std::lround(taps()[i].at_s / speed * kSampleRateHz)));
      for (std::size_t k = 0; k < 200; ++k) {
        ASSERT_EQ(frames[onsets[i] + k].left, once[as_it_was[i] + k].left) << speed;
      }
    }
  }
}

TEST(RecordedSound, ATouchThatIsHeardSlowlyIsHeardWithoutAGapAndNoDeeper) {
  const TouchRecording recording = recordingOf(0.4, [](TouchRow& row) {
    row.contact = true;
    row.proxy = {40, 40, 10};
    row.hand_hip = {40, 40, 9};
  });
  SoundRequest request;
  request.heights = ToneHeights{0, 20};
  request.speed = 0.01;  // A row each tenth of a second.
  const std::vector<double> left = leftOf(framesOf(RecordedSound(recording, request)));
  for (double t = 1; t < 39; t += 0.02) ASSERT_GT(rms(left, t, t + 0.02), 0.01) << t;
  EXPECT_NEAR(cents(pitchHz(left, 10, 11), heightHz(0.5)), 0, 3);
}

TEST(RecordedSound, AWindowThatWasPlacedForTheEyeIsNotHeard) {
  const auto touching = [](TouchRow& row) {
    row.contact = true;
    row.proxy = {0, 40, 0};
  };
  TouchRecording recording = recordingOf(0.4, touching);
  RecordedSound::Summary known, placed;
  framesOf(RecordedSound(recording, withoutTone()), &known);
  EXPECT_EQ(struck(known, Earcon::edge), 1U);
  recording.windows.front().known = false;
  framesOf(RecordedSound(recording, withoutTone()), &placed);
  EXPECT_EQ(struck(placed, Earcon::edge), 0U);
}

TEST(RecordedSound, AClickIsAsLoudAsTheHandIsFast) {
  const TouchRecording recording = tapping();
  const std::vector<Frame> frames = framesOf(RecordedSound(recording, withoutTone()));
  const std::vector<std::size_t> onsets = onsetsIn(frames);
  ASSERT_EQ(onsets.size(), taps().size());
  double before = 0;
  for (std::size_t i = 0; i < onsets.size(); ++i) {
    const double peak = frames[onsets[i]].left;
    EXPECT_NEAR(peak, kHalf * clickPeak(taps()[i].speed_mm_per_s), 0.001);
    EXPECT_GT(peak, before) << "faster is louder";
    before = peak;
  }
}

TEST(RecordedSound, AHandThatLeavesOrComesSlidingAlongMakesTheSoftestClick) {
  // Sideways at 200 mm/s, and so not toward the surface.
  const TouchRecording recording = recordingOf(0.4, [](TouchRow& row) {
    row.hand_hip = {200 * row.t_s, 0, 0.5};
    row.contact = row.t_s > 0.2;
  });
  const std::vector<Frame> frames = framesOf(RecordedSound(recording, withoutTone()));
  ASSERT_EQ(onsetsIn(frames).size(), 1U);
  EXPECT_NEAR(frames[onsetsIn(frames)[0]].left, kHalf * kLeastClick, 0.001);
}

TEST(RecordedSound, ThePitchIsThatOfTheHeight) {
  for (const double share : {0.0, 0.25, 0.6, 1.0}) {
    const TouchRecording recording = recordingOf(1, [&](TouchRow& row) {
      row.contact = row.t_s >= 0.1;
      row.proxy.z = 20 * share;
    });
    SoundRequest request;
    request.heights = ToneHeights{0, 20};
    const std::vector<double> left = leftOf(framesOf(RecordedSound(recording, request)));
    EXPECT_NEAR(cents(pitchHz(left, 0.4, 0.9), heightHz(share)), 0, 3) << share;
    EXPECT_NEAR(rms(left, 0.4, 0.9), kHalf * kToneLevel * kHalf, 0.002);
    EXPECT_LT(rms(left, 0, 0.09), 1e-6) << "in the air there is no tone";
    EXPECT_LT(rms(left, 1.15, 1.2), 1e-3) << "nor after the end";
  }
  EXPECT_DOUBLE_EQ(heightHz(0), 200);
  EXPECT_DOUBLE_EQ(heightHz(1), 800);
}

TEST(RecordedSound, ThePitchFollowsASlope) {
  const TouchRecording recording = recordingOf(2, [](TouchRow& row) {
    row.contact = true;
    row.proxy.z = 10 * row.t_s;
  });
  const RecordedSound sound(recording, {});
  EXPECT_NEAR(sound.heights().low_mm, 0, 1e-9);
  EXPECT_NEAR(sound.heights().high_mm, 20, 1e-9) << "without --heights: what was touched";
  const std::vector<double> left = leftOf(framesOf(sound));
  for (double t = 0.3; t < 1.8; t += 0.1) {
    EXPECT_NEAR(cents(pitchHz(left, t, t + 0.1), heightHz((t + 0.05) / 2)), 0, 15) << t;
  }
}

TEST(RecordedSound, AGainOfTheWindowIsNoHeight) {
  TouchRecording recording = recordingOf(1, [](TouchRow& row) {
    row.contact = true;
    row.proxy.z = 40;  // 10 mm, shown four times as high.
  });
  recording.windows[0].gain = 4;
  SoundRequest request;
  request.heights = ToneHeights{0, 20};
  const std::vector<double> left = leftOf(framesOf(RecordedSound(recording, request)));
  EXPECT_NEAR(cents(pitchHz(left, 0.4, 0.9), heightHz(0.5)), 0, 3);
}

TEST(RecordedSound, ThePlaceIsHeardBetweenLeftAndRight) {
  double left_before = 2, right_before = -1;
  for (const double x : {4.0, 20.0, 40.0, 60.0, 76.0}) {
    const TouchRecording recording = recordingOf(1, [&](TouchRow& row) {
      row.contact = true;
      row.proxy.x = x;
    });
    const std::vector<Frame> frames = framesOf(RecordedSound(recording, {}));
    std::vector<double> right;
    for (const Frame& frame : frames) right.push_back(frame.right);
    const double l = rms(leftOf(frames), 0.4, 0.9), r = rms(right, 0.4, 0.9);
    EXPECT_NEAR(l * l + r * r, 0.5 * kToneLevel * kToneLevel, 1e-4) << "as loud at every place";
    EXPECT_NEAR(std::atan2(r, l), x / 80 * std::numbers::pi / 2, 0.02) << x;
    EXPECT_LT(l, left_before);
    EXPECT_GT(r, right_before);
    left_before = l;
    right_before = r;
  }
}

TEST(RecordedSound, TheToneEndsAfterItsTimeAndTheClicksGoOn) {
  const TouchRecording recording = recordingOf(
      3, [](TouchRow& row) { row.contact = row.t_s >= 0.5 && (row.t_s < 2.3 || row.t_s > 2.5); });
  SoundRequest request;
  request.synth.tone_for_s = 1;
  RecordedSound::Summary summary;
  const std::vector<double> left = leftOf(framesOf(RecordedSound(recording, request), &summary));
  EXPECT_GT(rms(left, 0.7, 1.4), 0.03);
  EXPECT_LT(rms(left, 1.6, 2.2), 1e-6) << "1 s after the first contact";
  EXPECT_LT(rms(left, 2.7, 2.9), 1e-6) << "another contact does not begin it anew";
  EXPECT_EQ(struck(summary, Earcon::contact), 2U);
}

/// A hand that slides to and fro, 20 mm, so that it stays in the window.
TouchRecording sliding(double mm_per_s, double force_n) {
  return recordingOf(1.5, [&](TouchRow& row) {
    row.contact = true;
    const double way = std::fmod(mm_per_s * row.t_s, 40.0);
    row.proxy.x = 30 + (way < 20 ? way : 40 - way);
    row.force = {0, 0, force_n};
  });
}

TEST(RecordedSound, RustlingIsAsLoudAndAsBrightAsItsLaw) {
  for (const double speed : {50.0, 100.0, 300.0}) {
    const TouchRecording recording = sliding(speed, 2);
    const std::vector<double> left = leftOf(framesOf(RecordedSound(recording, withoutTone())));
    // Where the hand turns it is slower for a while.
    EXPECT_NEAR(rms(left, 0.2, 1.4) / (kHalf * frictionRms(2, speed)), 1, 0.25) << speed;
    const double hz = frictionHz(speed);
    const double in_band = powerBetween(left, 0.5, hz / 1.6, hz * 1.6);
    EXPECT_GT(in_band / powerBetween(left, 0.5, 50, 16000), 0.5) << speed;
  }
  const auto loud = [](double speed, double force) {
    const TouchRecording recording = sliding(speed, force);
    return rms(leftOf(framesOf(RecordedSound(recording, withoutTone()))), 0.2, 1.4);
  };
  EXPECT_NEAR(loud(100, 2) / loud(100, 0.5), 2, 0.1) << "the root of the force";
  EXPECT_LT(loud(0, 4), 1e-4) << "a hand at rest is silent";
  EXPECT_LT(loud(100, 0), 1e-4) << "and one that does not press";
}

TEST(RecordedSound, EdgesFilledGroundDetailsNotesAndFaultsAreHeardOnce) {
  TouchRecording recording = recordingOf(4, [](TouchRow& row) {
    row.contact = row.t_s >= 0.2;
    if (row.t_s >= 1 && row.t_s < 1.5) row.origin = CellStatus::interpolated;
    if (row.t_s >= 1.2 && row.t_s < 1.5) row.origin = CellStatus::base_plane;  // Filled, too.
    if (row.t_s >= 2 && row.t_s < 2.2) row.origin = CellStatus::outside;
    if (row.t_s >= 2.6 && row.t_s < 2.8) row.proxy.x = 79.95;  // The window's end.
    if (row.t_s >= 3) row.detail = 2;
    if (row.t_s >= 3.4) row.detail = 1;
  });
  recording.events = {{.t_s = 3.1, .text = "forces on"},
                      {.t_s = 5.5, .text = "window 1; the device was unplugged"},
                      {.t_s = 6.9, .text = "a crack", .is_note = true}};
  RecordedSound::Summary summary;
  framesOf(RecordedSound(recording, withoutTone()), &summary);
  for (const Earcon earcon : {Earcon::contact, Earcon::not_measured, Earcon::finer, Earcon::coarser,
                              Earcon::problem, Earcon::done}) {
    EXPECT_EQ(struck(summary, earcon), 1U) << static_cast<int>(earcon);
  }
  EXPECT_EQ(struck(summary, Earcon::edge), 2U) << "of the object, and of the window";
  EXPECT_EQ(struckInAll(summary), 8U);
}

TEST(RecordedSound, NoSampleIsAboveTheCeiling) {
  for (const double ceiling : {0.9, 0.3, 0.05}) {
    TouchRecording recording = recordingOf(2, [](TouchRow& row) {
      // Everything at once, again and again.
      const bool odd = static_cast<int>(row.t_s * 200) % 2 == 1;
      row.contact = odd;
      row.origin = odd ? CellStatus::base_plane : CellStatus::measured;
      row.detail = odd ? 2 : 1;
      row.hand_hip = {40, 40, odd ? 0.0 : 5.0};
      row.proxy.x = odd ? 20 : 79.9;
      row.force = {0, 0, 9};
    });
    SoundRequest request;
    request.synth.ceiling = ceiling;
    RecordedSound::Summary summary;
    const std::vector<Frame> frames = framesOf(RecordedSound(recording, request), &summary);
    double largest = 0;
    for (const Frame& f : frames) {
      largest = std::max({largest, std::abs(double{f.left}), std::abs(double{f.right})});
    }
    EXPECT_LE(largest, ceiling + 1e-6);
    EXPECT_GT(largest, 0.85 * ceiling) << "and what is loud comes to it";
    EXPECT_DOUBLE_EQ(summary.peak, largest);
  }
}

TEST(RecordedSound, WhereSamplesAreMissingNothingIsHeard) {
  TouchRecording recording = recordingOf(3, [](TouchRow& row) { row.contact = true; });
  std::erase_if(recording.rows, [](const TouchRow& row) { return row.t_s > 4 && row.t_s < 5; });
  const std::vector<double> left = leftOf(framesOf(RecordedSound(recording, {})));
  EXPECT_GT(rms(left, 0.5, 0.9), 0.03);
  EXPECT_LT(rms(left, 1.15, 1.95), 1e-4);
  EXPECT_GT(rms(left, 2.2, 2.8), 0.03) << "and then it goes on";
}

TEST(RecordedSound, APartThatEndsOrBeginsWhereSamplesAreMissingIsSilentThere) {
  TouchRecording recording = recordingOf(3, [](TouchRow& row) { row.contact = true; });
  std::erase_if(recording.rows, [](const TouchRow& row) { return row.t_s > 4 && row.t_s < 5; });
  SoundRequest request;
  request.to_s = 1.8;
  const std::vector<double> first = leftOf(framesOf(RecordedSound(recording, request)));
  EXPECT_GT(rms(first, 0.5, 0.9), 0.03);
  EXPECT_LT(rms(first, 1.15, 1.75), 1e-4);
  request = {};
  request.from_s = 1.5;
  const std::vector<double> second = leftOf(framesOf(RecordedSound(recording, request)));
  EXPECT_LT(rms(second, 0, 0.45), 1e-4);
  EXPECT_GT(rms(second, 0.7, 1.3), 0.03);
}

TEST(RecordedSound, APartSoundsAtItsOwnTimes) {
  const TouchRecording recording = tapping();
  SoundRequest request = withoutTone();
  request.from_s = 1;
  request.to_s = 2.05;
  RecordedSound::Summary summary;
  const RecordedSound sound(recording, request);
  const std::vector<Frame> frames = framesOf(sound, &summary);
  EXPECT_EQ(frames.size(), sound.frames());
  EXPECT_EQ(frames.size(), static_cast<std::size_t>(1.25 * kSampleRateHz));
  const std::vector<std::size_t> onsets = onsetsIn(frames);
  ASSERT_EQ(onsets.size(), 4U) << "at 1.1, 1.4, 1.7 and 2 s";
  EXPECT_EQ(onsets[0], static_cast<std::size_t>(std::lround(0.1 * kSampleRateHz)));
  EXPECT_EQ(struck(summary, Earcon::contact), 4U);
}

TEST(RecordedSound, TheSameRecordingIsTheSameSound) {
  const TouchRecording recording = sliding(120, 3);
  const std::vector<Frame> a = framesOf(RecordedSound(recording, {}));
  const std::vector<Frame> b = framesOf(RecordedSound(recording, {}));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].left, b[i].left);
    ASSERT_EQ(a[i].right, b[i].right);
  }
}

TEST(RecordedSound, WhatCannotSoundIsRefused) {
  TouchRecording empty;
  empty.name = "log.csv";
  EXPECT_THROW(RecordedSound(empty, {}), FileError);
  const TouchRecording recording = tapping();
  SoundRequest beyond;
  beyond.from_s = 10;
  EXPECT_THROW(RecordedSound(recording, beyond), ArgumentError);
  TouchRecording of_nowhere = recording;
  of_nowhere.windows.clear();
  for (TouchRow& row : of_nowhere.rows) row.hand_hip = row.hand_proxy = {};
  EXPECT_THROW(RecordedSound(of_nowhere, {}), FileError) << "neither hand nor window";
}

TEST(RecordedSound, AnOlderRecordingWithoutTheHandSoundsByItsWindow) {
  const TouchRecording with_hand = tapping();
  TouchRecording without_hand = with_hand;
  for (TouchRow& row : without_hand.rows) row.hand_hip = row.hand_proxy = {};
  const std::vector<Frame> a = framesOf(RecordedSound(with_hand, withoutTone()));
  const std::vector<Frame> b = framesOf(RecordedSound(without_hand, withoutTone()));
  EXPECT_EQ(onsetsIn(a), onsetsIn(b));
  for (const std::size_t i : onsetsIn(a)) EXPECT_NEAR(a[i].left, b[i].left, 1e-6);
}

TEST(RecordedSound, OfAHandThatIsLedTheHeightIsHeardWithoutContactAndAfterTwoMinutes) {
  TouchRecording recording = test::recordingOf(3, [](TouchRow& row) {
    row.proxy.z = row.t_s < 1.5 ? 5 : 15;
    row.hand_hip = {40, 40, 30};
  });
  recording.events.push_back({3.5, "new window: 1; the hand is led", false});
  recording.events.push_back({5.5, "the guide lets go: a button", false});
  SoundRequest request;
  request.heights = ToneHeights{0, 20};
  request.synth.tone_for_s = 0;
  const std::vector<double> left = test::leftOf(test::framesOf(RecordedSound(recording, request)));
  EXPECT_EQ(test::rms(left, 0, 0.49), 0) << "not led, and nothing is touched";
  EXPECT_NEAR(test::cents(test::pitchHz(left, 0.8, 1.4), heightHz(0.25)), 0, 5);
  EXPECT_NEAR(test::cents(test::pitchHz(left, 1.8, 2.4), heightHz(0.75)), 0, 5);
  EXPECT_LT(test::rms(left, 2.6, 3), 1e-4) << "the hand leads";
}

}  // namespace
}  // namespace relievo::sound
