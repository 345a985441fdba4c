// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/stroke.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/haptics/haptic_fixture.h"

namespace relievo {
namespace {

using test::spaceOf;

std::filesystem::path written(const std::string& text) {
  std::filesystem::path file = test::ownPath("stroke.csv");
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

std::string refusal(const std::string& text) {
  try {
    readStroke(written(text));
  } catch (const FileError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Stroke, IsReadAsWritten) {
  const Stroke stroke =
      readStroke(written("\xEF\xBB\xBFt_s,x_mm,y_mm,z_mm\r\n# a remark\r\n0.5, 1,2,-3e1\r\n\n"
                         "0.75,1.5,2,0.1\n"));
  ASSERT_EQ(stroke.points.size(), 2U);
  EXPECT_EQ(stroke.points[0].t_s, 0.5);
  EXPECT_EQ(stroke.points[0].z_mm, -30);
  EXPECT_EQ(stroke.points[1].x_mm, 1.5);
}

TEST(Stroke, NamesTheRowThatIsWrong) {
  const std::string head = "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n";
  for (const char* bad : {"0.1,0,0\n", "0.1,0,0,0,0\n", "0.1,nan,0,0\n", "0.1,0,inf,0\n",
                          "0.1,0,,0\n", "0.1,0,1x,0\n", "0,0,0,0\n", "-1,0,0,0\n"}) {
    const std::string said = refusal(head + bad);
    EXPECT_NE(said.find("row 2 "), std::string::npos) << bad << said;
  }
  EXPECT_NE(refusal("x,y,z\n0,0,0\n").find("t_s,x_mm,y_mm,z_mm"), std::string::npos);
  EXPECT_NE(refusal("t_s,x_mm,y_mm,z_mm\n").find("no rows"), std::string::npos);
  EXPECT_NE(refusal(""), "accepted");
  EXPECT_THROW(readStroke("/nowhere/stroke.csv"), FileError);
  EXPECT_THROW(readStroke(::testing::TempDir()), FileError);
}

std::vector<std::pair<HapticSample, double>> run(const HapticSpace& space, const Stroke& stroke,
                                                 const StrokeOptions& options = {}) {
  std::vector<std::pair<HapticSample, double>> samples;
  const std::uint64_t ticks =
      runStroke(space, options, stroke,
                [&](const HapticSample& sample, double t_s) { samples.emplace_back(sample, t_s); });
  EXPECT_EQ(ticks, samples.size());
  EXPECT_EQ(ticks, strokeTicks(stroke));
  return samples;
}

TEST(Stroke, TicksOncePerMillisecondFromItsStartToItsEnd) {
  const auto space = spaceOf(80, [](double, double) { return 0.0; });
  const auto count = [](double from, double to) {
    return strokeTicks({{{from, 0, 0, 1}, {to, 1, 0, 1}}});
  };
  EXPECT_EQ(count(0, 0.1), 101U);
  EXPECT_EQ(count(2.5, 2.5009), 1U);
  EXPECT_EQ(count(0, 0.0029999999999), 4U) << "rounding of the end does not cost a tick";
  EXPECT_EQ(count(0.1, 0.3), 201U);
  EXPECT_EQ(strokeTicks({{{5, 0, 0, 0}}}), 1U);

  const auto samples = run(*space, {{{0.1, 10, 20, 3}, {0.2, 20, 20, 3}, {0.25, 20, 30, 8}}});
  ASSERT_EQ(samples.size(), 151U);
  EXPECT_DOUBLE_EQ(samples[0].second, 0.1);
  EXPECT_NEAR(samples[50].first.hip_view.x, 15, 1e-12) << "linear between rows";
  EXPECT_NEAR(samples[125].first.hip_view.y, 25, 1e-12);
  EXPECT_NEAR(samples[150].first.hip_view.z, 8, 1e-12);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].first.tick, i);
    EXPECT_EQ(samples[i].first.rate_hz, 1000);
  }
}

TEST(Stroke, StartsWithThePlacementAndSolvesFromTheNextTick) {
  const auto space = spaceOf(80, [](double x, double) { return 0.5 * x; });
  const auto samples = run(*space, {{{0, 40, 40, 18}, {0.01, 40, 40, 18}}});
  const HapticSample& first = samples[0].first;
  EXPECT_TRUE(first.contact);
  EXPECT_NEAR(first.proxy_view.x, 40, 1e-9);
  EXPECT_NEAR(first.proxy_view.z, 20, 1e-4) << "straight above";
  EXPECT_NEAR(first.force.z, 0.5 * (first.proxy.z - first.hip.z), 1e-12);
  const HapticSample& second = samples[1].first;
  EXPECT_NEAR(second.proxy_view.x, 40 - 2 * 0.5 / 1.25, 1e-4) << "foot of the perpendicular";
  EXPECT_EQ(run(*space, {{{0, 40, 40, 22}}})[0].first.contact, false);
}

TEST(Stroke, TakesPositionsInTheHandsFrameToo) {
  const auto space = spaceOf(40, [](double x, double) { return 0.1 * x; });
  StrokeOptions options;
  options.frame = StrokeFrame::device;
  const auto samples = run(*space, {{{0, -12, 7, 3}}}, options);
  EXPECT_EQ(samples[0].first.hip, (DeviceMm{-12, 7, 3}));
  EXPECT_NEAR(norm(samples[0].first.hip_view - space->viewFromDevice({-12, 7, 3})), 0, 1e-12);
}

TEST(Stroke, HasNoLimitsUnlessAskedFor) {
  const auto space = spaceOf(80, [](double, double) { return 0.0; });
  const Stroke press{{{0, 40, 40, 5}, {2, 40, 40, 5}, {2.1, 40, 40, -20}, {3, 40, 40, -20}}};
  StrokeOptions options;
  options.stiffness_n_per_mm = 2;
  EXPECT_NEAR(run(*space, press, options).back().first.force.z, 40, 1e-9);
  options.chain = ForceChain::whole;
  double largest = 0;
  for (const auto& [sample, t_s] : run(*space, press, options)) {
    largest = std::max(largest, norm(sample.force));
  }
  EXPECT_NEAR(largest, 6, 1e-9);
}

TEST(Stroke, DampingAddsItsForceWhilePressingInAndNothingWhileLeaving) {
  const auto space = spaceOf(80, [](double, double) { return 0.0; });
  // 2 mm in at 20 mm/s, a rest, and out again at 20 mm/s.
  const Stroke press{{{0, 40, 40, 1}, {0.15, 40, 40, -2}, {0.25, 40, 40, -2}, {0.4, 40, 40, 1}}};
  StrokeOptions options;
  const auto plain = run(*space, press, options);
  options.damping_n_s_per_mm = 0.002;
  const auto damped = run(*space, press, options);
  ASSERT_EQ(plain.size(), damped.size());
  double work_n_mm = 0;  // Of the damping, on the hand.
  for (std::size_t n = 1; n < plain.size(); ++n) {
    const HapticSample& p = plain[n].first;
    const HapticSample& d = damped[n].first;
    EXPECT_EQ(d.proxy, p.proxy);
    const double extra_n = d.force.z - p.force.z;
    if (!p.contact || n > 160) {
      EXPECT_EQ(extra_n, 0) << "tick " << n;
    } else if (n < 150) {
      EXPECT_NEAR(extra_n, 0.002 * 20, 1e-9) << "tick " << n;
    }
    EXPECT_GE(d.force.z, 0);
    work_n_mm += extra_n * (d.hip.z - plain[n - 1].first.hip.z);
  }
  EXPECT_LT(work_n_mm, -0.05);
}

TEST(Stroke, RefusesWhatCannotRunAndStopsWhenAsked) {
  const auto space = spaceOf(80, [](double, double) { return 0.0; });
  const auto nothing = [](const HapticSample&, double) {};
  StrokeOptions options;
  EXPECT_THROW(runStroke(*space, options, {}, nothing), ArgumentError);
  options.stiffness_n_per_mm = 0;
  EXPECT_THROW(runStroke(*space, options, {{{0, 0, 0, 0}}}, nothing), ArgumentError);
  options.stiffness_n_per_mm = 1;
  EXPECT_THROW(runStroke(*space, options, {{{0, 0, 0, 0}, {1e12, 0, 0, 0}}}, nothing),
               ArgumentError);
  options.damping_n_s_per_mm = -1;
  EXPECT_THROW(runStroke(*space, options, {{{0, 0, 0, 0}}}, nothing), ArgumentError);
  options.damping_n_s_per_mm = 0;
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(runStroke(*space, options, {{{0, 0, 0, 0}}}, nothing, {source.get_token(), {}}),
               Cancelled);
}

}  // namespace
}  // namespace relievo
