// SPDX-License-Identifier: BSD-3-Clause
// Of the tests that draw figures or videos.
#include <gtest/gtest.h>

#include "ui/figure/figure.h"
#include "ui/vtk/offscreen.h"

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const relievo::DisplayGuard display;
  const relievo::FigureSession session;
  return RUN_ALL_TESTS();
}
