// SPDX-License-Identifier: BSD-3-Clause
#include "ui/views/overlays/pink_window.h"

#include <gtest/gtest.h>

namespace relievo {
namespace {

constexpr Region kWindow{.x_mm = 10, .y_mm = 20, .side_mm = 100, .level = {1}};

TEST(PinkWindow, IsGrabbedByEdgesCornersAndInside) {
  EXPECT_EQ(pinkPartAt(kWindow, 60, 70, 3), PinkPart::inside);
  EXPECT_EQ(pinkPartAt(kWindow, 10, 70, 3), PinkPart::left);
  EXPECT_EQ(pinkPartAt(kWindow, 112, 70, 3), PinkPart::right);
  EXPECT_EQ(pinkPartAt(kWindow, 60, 18, 3), PinkPart::bottom);
  EXPECT_EQ(pinkPartAt(kWindow, 60, 119, 3), PinkPart::top);
  EXPECT_EQ(pinkPartAt(kWindow, 11, 21, 3), PinkPart::left_bottom);
  EXPECT_EQ(pinkPartAt(kWindow, 109, 119, 3), PinkPart::right_top);
  EXPECT_EQ(pinkPartAt(kWindow, 5, 70, 3), PinkPart::outside);
}

TEST(PinkWindow, KeepsAnInsideHoweverSmallItIs) {
  const Region tiny{.x_mm = 0, .y_mm = 0, .side_mm = 1, .level = {0}};
  EXPECT_EQ(pinkPartAt(tiny, 0.5, 0.5, 3), PinkPart::inside);
}

TEST(PinkWindow, IsDrawnAsASquareFromItsFirstCorner) {
  const RectMm up = drawnSquare(10, 10, 40, 25);
  EXPECT_EQ(up.x_mm, 10);
  EXPECT_EQ(up.y_mm, 10);
  EXPECT_EQ(up.width_mm, 30);
  EXPECT_EQ(up.height_mm, 30);
  const RectMm down = drawnSquare(10, 10, 5, -30);
  EXPECT_EQ(down.x_mm + down.width_mm, 10);
  EXPECT_EQ(down.y_mm + down.height_mm, 10);
  EXPECT_EQ(down.height_mm, 40);
}

TEST(PinkWindow, ResizesAboutTheOppositeCorner) {
  const RectMm r = resizedSquare(kWindow, PinkPart::left_bottom, 30, 60, 1);
  EXPECT_DOUBLE_EQ(r.x_mm + r.width_mm, 110);
  EXPECT_DOUBLE_EQ(r.y_mm + r.height_mm, 120);
  EXPECT_DOUBLE_EQ(r.width_mm, 80);
  EXPECT_DOUBLE_EQ(r.width_mm, r.height_mm);
}

TEST(PinkWindow, ResizesByAnEdgeAboutTheOppositeEdgesMiddle) {
  const RectMm r = resizedSquare(kWindow, PinkPart::right, 60, 999, 1);
  EXPECT_DOUBLE_EQ(r.x_mm, 10);
  EXPECT_DOUBLE_EQ(r.width_mm, 50);
  EXPECT_DOUBLE_EQ(r.y_mm + 0.5 * r.height_mm, kWindow.centreY());
}

TEST(PinkWindow, NeverBecomesSmallerThanTheLeast) {
  const RectMm r = resizedSquare(kWindow, PinkPart::right_top, -500, -500, 4);
  EXPECT_EQ(r.width_mm, 4);
  EXPECT_EQ(r.x_mm, 10);
}

}  // namespace
}  // namespace relievo
