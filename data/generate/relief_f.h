// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "data/generate/sample.h"

/// The acceptance relief F: a plate whose every height is known in closed form. It carries one
/// feature for each thing the program must get right: a dome, a step, a low ridge, a fine grating,
/// three enclosed holes of different size, a missing corner. All lengths in millimetres, z up.
namespace relievo::samples {

inline constexpr double kReliefFWidthMm = 300;
inline constexpr double kReliefFDepthMm = 200;  ///< Extent in y.
inline constexpr double kReliefFSpacingMm = 0.25;
inline constexpr int kReliefFCols = 1200;  ///< Points at 0.125 + 0.25 i.
inline constexpr int kReliefFRows = 800;

struct Disc {
  double x_mm = 0, y_mm = 0, radius_mm = 0;
};
struct Square {
  double x_mm = 0, y_mm = 0, side_mm = 0;  ///< About its centre.
};
inline constexpr Disc kReliefFCap{90, 100, 60};  ///< Base of the spherical cap.
inline constexpr double kReliefFCapHeightMm = 30;
inline constexpr double kReliefFStepX = 200;  ///< Everything beyond is raised.
inline constexpr double kReliefFStepMm = 5;
inline constexpr double kReliefFRidgeY = 30;
inline constexpr double kReliefFRidgeHeightMm = 1;
inline constexpr double kReliefFRidgeSigmaMm = 3;
inline constexpr Square kReliefFGrating{240, 150, 40};
inline constexpr double kReliefFGratingPeriodMm = 4;       ///< Along x.
inline constexpr double kReliefFGratingAmplitudeMm = 0.3;  ///< 0 .. 0.6 mm above the ground.
inline constexpr Disc kReliefFHole1{150, 60, 10};
inline constexpr Square kReliefFHole2{60, 160, 6};
inline constexpr Disc kReliefFHole3{30, 30, 0.5};     ///< On the ridge, on purpose.
inline constexpr Square kReliefFCorner{290, 10, 20};  ///< Missing: outside, not a hole.

/// Height of the closed form; the contributions add up. Defined everywhere, in the holes too.
double reliefFHeightMm(double x_mm, double y_mm);

/// Is (x, y) in one of the three enclosed holes?
bool isHole(double x_mm, double y_mm);

/// Is (x, y) off the plate or in the missing corner?
bool isOutside(double x_mm, double y_mm);

/// Area of enclosed hole 1, 2 or 3 in mm^2, from its shape. @throw std::out_of_range
double reliefFHoleAreaMm2(int hole);

/// The points: all grid positions that are neither hole nor outside, row by row.
Cloud makeReliefF();

/// Closed form at the grid positions of the points, NaN outside; filled where the holes are.
Reference reliefFReference();

}  // namespace relievo::samples
