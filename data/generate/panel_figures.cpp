// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/panel_figures.h"

#include <cmath>
#include <numbers>

namespace relievo::samples {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Figure elephant() {
  return {{
              // body, held to the ground by a hidden stem
              {{60, 104, 0}, {104, 100, 0}, 27, 25},
              {{80, 100, -10}, {80, 99, -44}, 15, 17},
              // head, forehead, ear
              {{126, 116, 4}, {134, 112, 6}, 17, 14},
              {{131, 127, 6}, {128, 122, 4}, 8, 9},
              {{113, 118, 17}, {108, 100, 19}, 10, 7},
              {{113, 122, 17}, {118, 104, 20}, 8, 5},
              // trunk, curling up at the end
              {{141, 108, 8}, {149, 92, 9}, 10, 8},
              {{149, 92, 9}, {152, 70, 11}, 8, 6.4},
              {{152, 70, 11}, {158, 57, 13}, 6.4, 5.2},
              {{158, 57, 13}, {168, 55, 14}, 5.2, 4.4},
              {{168, 55, 14}, {172, 63, 14}, 4.4, 3.4},
              // tusk
              {{136, 99, 14}, {150, 88, 19}, 3.6, 2.6},
              {{150, 88, 19}, {163, 90, 21}, 2.6, 1.2},
              // legs, near and far
              {{46, 92, 9}, {42, 58, 10}, 13, 10},
              {{42, 58, 10}, {45, 33, 10}, 10, 9},
              {{110, 88, 10}, {116, 58, 11}, 12, 9.5},
              {{116, 58, 11}, {112, 33, 11}, 9.5, 9},
              {{66, 88, -12}, {70, 33, -12}, 12, 8.5},
              {{92, 84, -12}, {90, 33, -12}, 11, 8.5},
              // tail
              {{33, 108, 6}, {25, 84, 6}, 3.4, 2.4},
              {{25, 84, 6}, {26, 62, 6}, 2.4, 3.4},
          },
          24,
          0.5,
          5};
}

Figure driver() {
  return {{
              {{88, 132, 0}, {90, 148, 2}, 10, 8.5},
              {{91, 161, 4}, {92, 163, 4}, 7.2, 6.6},
              {{90, 168, 2}, {90, 171, 1}, 6, 3.6},
              {{96, 150, 8}, {106, 139, 12}, 4, 3.4},
              {{106, 139, 12}, {119, 136, 14}, 3.4, 2.6},
              {{90, 130, 10}, {104, 120, 16}, 6.4, 5.2},
              {{104, 120, 16}, {107, 104, 18}, 5, 3.6},
              {{82, 150, -2}, {74, 142, 2}, 4, 3.4},
              {{74, 142, 2}, {68, 150, 4}, 3.2, 2.6},
          },
          27,
          0.5,
          2.5};
}

Figure parasol() {
  std::vector<Limb> limbs{{{68, 128, 0}, {68, 178, 0}, 1.8, 1.6}};
  for (int rib = -2; rib <= 2; ++rib) {
    limbs.push_back({{68, 180, 4}, {68 + 11.0 * rib, 172 - 1.2 * std::abs(rib), 3}, 4.4, 3.2});
  }
  limbs.push_back({{68, 183, 4}, {68, 187, 4}, 2.4, 1.2});
  return {limbs, 22, 0.55, 2};
}

Figure horse() {
  return {{
              // barrel and its stem
              {{182, 92, 0}, {224, 95, 0}, 17, 15.5},
              {{203, 92, -8}, {203, 92, -30}, 9, 10},
              // neck, head, muzzle, ears, mane
              {{228, 102, 1}, {243, 128, 3}, 12, 8},
              {{244, 131, 4}, {260, 119, 5}, 8, 4.8},
              {{243, 137, 6}, {244, 144, 7}, 2.6, 1.2},
              {{238, 137, 3}, {237, 143, 3}, 2.6, 1.2},
              {{224, 118, 7}, {236, 136, 7}, 4, 3},
              // hind legs
              {{176, 84, 7}, {166, 62, 8}, 9.5, 5.4},
              {{166, 62, 8}, {176, 46, 8}, 5, 3.6},
              {{176, 46, 8}, {172, 34, 8}, 3.6, 4},
              {{188, 80, -8}, {196, 60, -8}, 9, 5},
              {{196, 60, -8}, {188, 34, -8}, 4.4, 3.8},
              // fore legs, one lifted
              {{226, 86, 7}, {244, 72, 9}, 7.4, 4.6},
              {{244, 72, 9}, {238, 56, 9}, 4.2, 3.2},
              {{238, 56, 9}, {244, 49, 9}, 3.2, 3.6},
              {{220, 82, -8}, {226, 58, -8}, 7, 4.4},
              {{226, 58, -8}, {224, 34, -8}, 4.2, 3.8},
              // tail
              {{168, 102, 2}, {156, 92, 2}, 4, 4.6},
              {{156, 92, 2}, {148, 70, 1}, 4.6, 2},
          },
          15,
          0.5,
          4};
}

Figure rider() {
  return {{
              {{204, 112, 4}, {207, 132, 5}, 9, 8.4},
              {{209, 146, 6}, {210, 148, 6}, 6.8, 6.2},
              {{208, 154, 5}, {205, 158, 5}, 5, 2.8},
              {{206, 110, 12}, {220, 98, 17}, 6, 5},
              {{220, 98, 17}, {214, 80, 18}, 4.6, 3.4},
              {{214, 80, 18}, {221, 77, 18}, 3.4, 2.6},
              {{211, 133, 12}, {222, 124, 16}, 4, 3.4},
              {{222, 124, 16}, {232, 122, 16}, 3.2, 2.6},
              {{203, 134, 8}, {194, 142, 12}, 4, 3.4},
              {{194, 142, 12}, {198, 154, 14}, 3.2, 2.8},
              // spear
              {{160, 140, 15}, {256, 172, 15}, 1.8, 1.8},
              {{256, 172, 15}, {267, 175.7, 15}, 3.2, 0.6},
              // cloak
              {{199, 128, 0}, {184, 122, 3}, 6, 5},
              {{184, 122, 3}, {172, 126, 5}, 5, 2},
          },
          20,
          0.5,
          2.5};
}

/// A tree: a bent stem and pointed leaves around a few centres.
Figure tree(double foot_x, double foot_y, double bend, double top_y) {
  const Point3 fork{foot_x + bend, 0.7 * top_y + 0.3 * foot_y, 2};
  const Point3 top{foot_x - 0.5 * bend, top_y, 2};
  std::vector<Limb> limbs{{{foot_x, foot_y, 0}, fork, 5.5, 4}, {fork, top, 4, 2.4}};
  for (const Point3& centre : {fork, top}) {
    for (int leaf = 0; leaf < 11; ++leaf) {
      const double angle = (leaf * 32.7 + centre.x) * kDegree;
      const double reach = 17 + 4 * (leaf % 3);
      limbs.push_back({{centre.x + 6 * std::cos(angle), centre.y + 6 * std::sin(angle), 4},
                       {centre.x + reach * std::cos(angle), centre.y + reach * std::sin(angle), 6},
                       3.8,
                       0.7});
    }
  }
  return {limbs, 5, 0.55, 1.5};
}

/// A tendril of leaves along the foot of the panel.
Figure tendril() {
  std::vector<Limb> limbs;
  constexpr double kStepMm = 16;
  for (int i = 0; i < 16; ++i) {
    const double x = 24 + kStepMm * i;
    const double side = i % 2 == 0 ? 1 : -1;
    limbs.push_back({{x, 20 - 2 * side, 0}, {x + kStepMm, 20 + 2 * side, 0}, 1.3, 1.3});
    limbs.push_back({{x + 3, 20, 1}, {x + 11, 20 + 4.5 * side, 2}, 2.6, 0.6});
    limbs.push_back({{x + 3, 20, 1}, {x + 4, 20 + 5.5 * side, 2}, 2.2, 0.6});
  }
  return {limbs, 19, 0.8, 0.8};
}

}  // namespace

std::vector<Figure> panelFigures() {
  return {tree(154, 24, 6, 160),
          tree(272, 24, -8, 150),
          tree(30, 24, 4, 150),
          horse(),
          rider(),
          elephant(),
          driver(),
          parasol(),
          tendril()};
}

}  // namespace relievo::samples
