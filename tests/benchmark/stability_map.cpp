// SPDX-License-Identifier: BSD-3-Clause
// The stability map: how stiff a surface may be for each level and grip, with and without the
// passivity stage, found with the virtual hand. Writes docs/dev/stability.md and its plot:
//   cmake --build --preset release --target stability
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "app/cli/verbs/svg.h"
#include "haptics/loop/stable_stiffness.h"
#include "tests/haptics/stability.h"

namespace relievo {
namespace {

/// Largest stable stiffness of one scene, per grip, without and with the passivity stage.
struct Row {
  std::string scene;
  int detail = 0;
  std::array<std::array<double, 2>, kHandPresets.size()> k{};
};

std::vector<Row> measure(const VirtualHandOptions& device) {
  std::vector<Row> rows;
  for (const test::StabilityScene& scene : test::stabilityScenes()) {
    Row row{scene.name, scene.detail, {}};
    for (std::size_t grip = 0; grip < kHandPresets.size(); ++grip) {
      for (const bool passivity : {false, true}) {
        row.k[grip][passivity ? 1 : 0] =
            test::largestStable(*scene.space, kHandPresets[grip], passivity, device);
      }
    }
    rows.push_back(row);
    std::cerr << scene.name << ' ' << scene.detail << '\n';
  }
  return rows;
}

/// The least over the scenes that a level meets and all grips.
double leastAt(const std::vector<Row>& rows, int detail, bool passivity) {
  double least = 1e9;
  for (const Row& row : rows) {
    if (row.detail != 0 && row.detail != detail) continue;
    for (const auto& k : row.k) least = std::min(least, k[passivity ? 1 : 0]);
  }
  return least;
}

std::string number(double k) {
  return (k > 2.95 ? ">= " : "") + fixedDigits(k, 1);
}

void writeTable(std::ostream& out, const std::vector<Row>& rows) {
  out << "| scene |";
  for (const HandImpedance& grip : kHandPresets) out << ' ' << grip.name << " grip |";
  out << "\n|---|";
  for (std::size_t i = 0; i < kHandPresets.size(); ++i) out << "---:|";
  out << '\n';
  for (const Row& row : rows) {
    out << "| " << row.scene;
    if (row.detail > 0) {
      out << " of resolution " << row.detail << ", "
          << test::kTextureWaveMm[static_cast<std::size_t>(row.detail - 1)] << " mm waves";
    }
    out << " |";
    for (const auto& k : row.k) out << ' ' << number(k[0]) << " -> " << number(k[1]) << " |";
    out << '\n';
  }
}

/// As the loop has it.
void writeRateTable(std::ostream& out) {
  out << "\n## By rate\n\nThe least over scenes and grips with counts of 0.048 mm, by ticks of "
         "delay, "
         "without -> with the stage: measured by\n`stability_map --rates` and kept in "
         "`haptics/loop/stable_stiffness.cpp`. E306 takes 75 % of the second number.\n\n"
         "| rate | 0 ticks | 1 tick | 2 ticks |\n|---:|---:|---:|---:|\n";
  for (const double rate_hz : {100.0, 300.0, 400.0, 600.0, 800.0, 1000.0}) {
    out << "| " << rate_hz << " /s |";
    for (int delay = 0; delay <= 2; ++delay) {
      const DeviceTiming timing{rate_hz, delay, 0.048};
      out << ' ' << fixedDigits(stableStiffnessAlone(timing), 2) << " -> "
          << fixedDigits(stableStiffness(timing), 2) << " |";
    }
    out << '\n';
  }
}

void writePage(std::ostream& out, const std::vector<Row>& rows, const std::vector<Row>& falcon) {
  out << "# How stiff a surface may be\n\n"
         "Found with the virtual hand (`haptics/device/virtual_hand.h`: 0.2 kg, 1 N s/m, 0.1 N of "
         "dry "
         "friction,\n0.0635 mm per count, one tick from `send` until the force is felt) at 1 kHz, "
         "full "
         "strength, the oscillation\nwatch off. A hand lands, slides at 30 mm/s for a second and "
         "rests; pushes of 0.5, 2 and 4 N, two places.\nStable: in the last half second the force "
         "swings by less than "
      << fixedDigits(test::kStillN, 2)
      << " N above 20 Hz, at this stiffness and\nat every lower one in steps of 0.1 N/mm. Largest "
         "stable stiffness in N/mm, without -> with the passivity stage.\n\n## The virtual "
         "hand\n\n";
  writeTable(out, rows);
  out << "\n## The Falcon\n\nThe same arms and hands with what its driver declares: two ticks from "
         "`send` until the motors show the force, 0.048 mm\nper count. Its rate is the loop's; its "
         "friction is not known, and the virtual hand's 0.1 N stands in for it.\n\n";
  writeTable(out, falcon);
  out << "\n## Defaults\n";
  out << "\n![Largest stable stiffness and the default, per level](stability.svg)\n\n"
         "Waves are in mm of hand; their amplitude is 1/20 of their length. A level meets the "
         "flat, the\n"
         "edge and its own texture; the least over scenes and grips bounds its default\n"
         "(`stiffnessForDetail`). Resolution 1 and 2 take at most 75 % of what is stable with the "
         "stage.\n"
         "Resolution 3 and finer, which carry the texture, take no more than what is stable "
         "without "
         "it, so\n"
         "that the stage has nothing to do where the finest forces are felt; from Resolution 4 on "
         "0.5, "
         "up\n"
         "to which textured surfaces were found to be felt cleanly (Choi and Tan 2004).\n\n"
         "| level | virtual hand, without -> with | Falcon, without -> with | default "
         "|\n|---|---:|---:|---:|\n";
  for (int detail = 1; detail <= 4; ++detail) {
    out << "| Resolution " << detail << (detail == 4 ? " and finer" : "") << " | "
        << number(leastAt(rows, detail, false)) << " -> " << number(leastAt(rows, detail, true))
        << " | " << number(leastAt(falcon, detail, false)) << " -> "
        << number(leastAt(falcon, detail, true)) << " | "
        << fixedDigits(stiffnessForDetail(detail), 2) << " |\n";
  }
  writeRateTable(out);
  out << "\nGenerated: `cmake --build --preset release --target stability`. "
         "`haptics/loop/stability_test` checks that the defaults\nare stable for every grip and "
         "scene of their level, and one cell that needs the stage.\n";
}

constexpr double kLeft = 56, kTop = 34, kWidth = 560, kHeight = 240;

double yOf(double k, double most) {
  return kTop + kHeight * (1 - k / most);
}

std::string plot(const std::vector<Row>& rows) {
  const double most = 2;
  std::string svg =
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 640 330' width='640' height='330' "
      "font-family='sans-serif' font-size='11'>\n<rect width='640' height='330' fill='white'/>\n";
  svg += batch::textAt(kLeft, 20, "start",
                       "Largest stable stiffness over scenes and grips, virtual hand (N/mm)",
                       " font-size='13'");
  for (int i = 0; i <= 8; ++i) {
    const double k = 0.25 * i;
    svg += batch::lineAt(kLeft, yOf(k, most), kLeft + kWidth, yOf(k, most), "#dddddd");
    svg += batch::textAt(kLeft - 6, yOf(k, most) + 4, "end", fixedDigits(k, 2));
  }
  const auto bar = [&](double x, double k, const std::string& style) {
    return "<rect x='" + fixedDigits(x, 1) + "' y='" +
           fixedDigits(yOf(std::min(k, most), most), 1) + "' width='30' height='" +
           fixedDigits(kTop + kHeight - yOf(std::min(k, most), most), 1) + "' " + style + "/>\n";
  };
  // Outline, grey and solid tell the three apart without colour, too.
  constexpr const char* kWithout = "fill='white' stroke='#222222'";
  constexpr const char* kWith = "fill='#9bb8e8' stroke='#1f5fd0'";
  constexpr const char* kDefault = "fill='#222222'";
  for (int detail = 1; detail <= 4; ++detail) {
    const double x = kLeft + 25 + 140 * (detail - 1);
    svg += bar(x, leastAt(rows, detail, false), kWithout);
    svg += bar(x + 34, leastAt(rows, detail, true), kWith);
    svg += bar(x + 68, stiffnessForDetail(detail), kDefault);
    svg += batch::textAt(x + 49, kTop + kHeight + 16, "middle",
                         "Resolution " + std::to_string(detail));
  }
  const auto legend = [&](double x, const char* style, const char* text) {
    return "<rect x='" + fixedDigits(x, 1) + "' y='302' width='12' height='12' " + style + "/>\n" +
           batch::textAt(x + 18, 312, "start", text);
  };
  svg += legend(kLeft, kWithout, "without the passivity stage");
  svg += legend(kLeft + 200, kWith, "with it");
  svg += legend(kLeft + 300, kDefault, "default");
  return svg + "</svg>\n";
}

/// The table of haptics/loop/stable_stiffness.cpp, on standard output.
void writeRates(std::ostream& out) {
  for (const double rate_hz : {100.0, 200.0, 300.0, 400.0, 600.0, 800.0, 1000.0}) {
    std::array<std::array<double, 3>, 2> least{};
    for (int delay = 0; delay <= 2; ++delay) {
      VirtualHandOptions device = test::likeTheFalcon();
      device.delay_ticks = delay;
      for (const bool passivity : {false, true}) {
        double& k = least[passivity ? 1 : 0].at(static_cast<std::size_t>(delay));
        k = 1e9;
        for (const test::StabilityScene& scene : test::stabilityScenes()) {
          for (const HandImpedance& grip : kHandPresets) {
            k = std::min(k, test::largestStable(*scene.space, grip, passivity, device, rate_hz));
          }
        }
      }
    }
    out << "    {" << rate_hz;
    for (const auto& row : least) {
      out << ", {" << fixedDigits(row[0], 2) << ", " << fixedDigits(row[1], 2) << ", "
          << fixedDigits(row[2], 2) << '}';
    }
    out << "}," << std::endl;
  }
}

bool write(const std::string& file, const auto& fill) {
  std::ofstream out(file);
  fill(out);
  out.close();
  if (!out) std::cerr << "stability_map: " << file << " cannot be written.\n";
  return static_cast<bool>(out);
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  using namespace relievo;
  if (argc != 2) {
    std::cerr << "Usage: stability_map FOLDER | --rates\n";
    return 1;
  }
  const std::string folder = argv[1];
  if (folder == "--rates") {
    writeRates(std::cout);
    return 0;
  }
  const std::vector<Row> rows = measure({}), falcon = measure(test::likeTheFalcon());
  const bool done =
      write(folder + "/stability.md", [&](std::ostream& out) { writePage(out, rows, falcon); }) &&
      write(folder + "/stability.svg", [&](std::ostream& out) { out << plot(rows); });
  return done ? 0 : 3;
}
