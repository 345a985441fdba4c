// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/force/transient.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relievo {
namespace {

TransientInput touching(double speed_mm_s) {
  TransientInput input;
  input.contact = true;
  input.velocity = {0, 0, -speed_mm_s};
  input.spring_n = 1;
  return input;
}

/// Largest share of a knock that a landing at this speed begins.
double landing(const TransientOptions& options, double speed_mm_s) {
  TransientState state;
  double largest = 0;
  for (int i = 0; i < 60; ++i) {
    const ContactTransient now = knock(options, touching(speed_mm_s), state);
    state = now.state;
    largest = std::max(largest, now.force.z);
  }
  return largest;
}

TEST(Transient, ALandingKnocksAsHardAsTheHandCameAndNoHarderThanAllowed) {
  const TransientOptions options{.contact_n = 0.3, .contact_n_s_per_mm = 0.002};
  EXPECT_EQ(landing({}, 100), 0) << "off unless asked for";
  EXPECT_NEAR(landing(options, 100) / landing(options, 50), 2, 1e-12);
  EXPECT_GT(landing(options, 100), 0.1);
  EXPECT_LE(landing(options, 10'000), 0.3);
  EXPECT_EQ(landing(options, -100), 0) << "a hand that leaves";
}

/// A surface came to a hand that moves away; then the hand lands. The first was no landing, and
/// must not keep the second one quiet.
TEST(Transient, AContactWhileMovingAwayIsNoLandingAndDelaysNone) {
  const TransientOptions options{.contact_n = 0.3, .contact_n_s_per_mm = 0.002};
  TransientState state;
  double largest = 0;
  for (int i = 0; i < 40; ++i) {
    TransientInput input = touching(i < 5 ? -100 : 100);
    input.contact = i < 5 || i >= 10;
    const ContactTransient now = knock(options, input, state);
    state = now.state;
    if (i < 10) {
      EXPECT_EQ(now.force, DeviceN{}) << i;
    }
    largest = std::max(largest, now.force.z);
  }
  EXPECT_GT(largest, 0.1);
}

TEST(Transient, DecaysAndIsOverWithin24Ticks) {
  TransientState state;
  double early = 0, late = 0;
  for (int i = 0; i < 60; ++i) {
    const ContactTransient now =
        knock({.contact_n = 0.3, .contact_n_s_per_mm = 0.01}, touching(100), state);
    state = now.state;
    (i < 6 ? early : late) = std::max(i < 6 ? early : late, std::abs(now.force.z));
    if (i >= kKnockTicks) {
      EXPECT_EQ(now.force, DeviceN{}) << i;
    }
  }
  EXPECT_GT(early, 2 * late);
  EXPECT_GT(late, 0);
}

TEST(Transient, NeverPullsTheHand) {
  TransientState state;
  TransientInput input = touching(200);
  input.spring_n = 0.02;
  for (int i = 0; i < 60; ++i) {
    const ContactTransient now =
        knock({.contact_n = 0.5, .contact_n_s_per_mm = 0.01}, input, state);
    state = now.state;
    EXPECT_GE(now.force.z + input.spring_n, 0);
  }
}

TEST(Transient, EndsBeforeItHasDoneMoreWorkThanAllowed) {
  TransientState state;
  TransientInput input = touching(200);
  input.moved = {0, 0, 0.3};  // The hand flies off with the push: 300 mm/s.
  const TransientOptions options{.contact_n = 0.5, .contact_n_s_per_mm = 0.01, .most_mj = 0.02};
  double work_mj = 0, most_work_mj = 0, felt_n = 0, one_step_mj = 0;
  for (int i = 0; i < 60; ++i) {
    work_mj += felt_n * input.moved.z;
    most_work_mj = std::max(most_work_mj, work_mj);
    const ContactTransient now = knock(options, input, state);
    state = now.state;
    felt_n = now.force.z;
    one_step_mj = std::max(one_step_mj, felt_n * input.moved.z);
  }
  EXPECT_GT(one_step_mj, 0.02) << "it would have done more";
  EXPECT_LE(most_work_mj, options.most_mj + one_step_mj);
}

TEST(Transient, ATickAtEachCrossingButNotWhereTheGroundFlickers) {
  const TransientOptions options{.crossing_n = 0.1};
  TransientState state;
  int knocks = 0;
  for (int i = 0; i < 400; ++i) {
    TransientInput input = touching(0);
    input.measured = i < 100 || (i >= 100 && i < 110 && i % 2 == 0) || i >= 250;
    const ContactTransient now = knock(options, input, state);
    state = now.state;
    if (state.age == 0) ++knocks;
    EXPECT_LE(std::abs(now.force.z), 0.1);
  }
  EXPECT_EQ(knocks, 2) << "out, with its flicker, and back in";
}

}  // namespace
}  // namespace relievo
