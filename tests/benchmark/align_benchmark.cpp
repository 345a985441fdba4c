// SPDX-License-Identifier: BSD-3-Clause
// How near the alignment comes to the truth, and how long it takes: the tables of
// docs/dev/align-figures.md. Parts of closed objects and plates, each part with points of its own,
// 0.05 mm of noise on 200 mm, the second part three times as coarse as the first. Made objects
// always; scans from the folder that RELIEVO_SHARED_DATA names, or ../shared/data, if it is there.
// `align_benchmark [points|automatic|plates|four]...`: only these tables. Of four parts
// ALIGN_ROUNDS says how often, with other points, noise and picks, and ALIGN_OBJECTS names the
// objects.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/io/import.h"
#include "core/prepare/align/align_scans.h"
#include "tests/core/prepare/align_bound.h"
#include "tests/core/prepare/align_objects.h"

namespace {

namespace fs = std::filesystem;
using namespace relievo;
using namespace relievo::test;

constexpr std::size_t kFinePoints = 60000;
constexpr std::size_t kCoarsePoints = 20000;
constexpr double kNoiseMm = 0.05;

std::vector<MadeObject> objects() {
  std::vector<MadeObject> all{gargoyle()};
  const char* stated = std::getenv("RELIEVO_SHARED_DATA");
  const fs::path folder = stated != nullptr
                              ? fs::path(stated)
                              : fs::path(RELIEVO_SOURCE_DIR) / ".." / "shared" / "data";
  for (const char* name :
       {"obj/stanford-bunny.obj", "obj/armadillo.obj", "obj/demosthenes-low-res.obj",
        "ply/ankylosaurus_mesh.ply", "ply/DancingGirl_le_normals.ply", "obj/sword.obj"}) {
    std::error_code missing;
    if (!fs::exists(folder / name, missing)) {
      std::printf("%s is not there: left out.\n", name);
      continue;
    }
    all.push_back(meshObject(importScan(folder / name), fs::path(name).stem().string()));
  }
  return all;
}

struct Row {
  std::string object, start;
  AlignAnswer answer;
  std::vector<Part> parts;
  double processor_s = 0;
};

/// Of all threads, which other work on the machine moves less than the clock.
double processorSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void heading() {
  std::printf(
      "\n| object | start | verdict | stability | turn, degrees | shift, mm | bound, degrees | "
      "bound, "
      "mm | spacing, mm | processor s |\n|---|---|---|---:|---:|---:|---:|---:|---:|---:|\n");
}

/// Of two parts; of more none is known that is so simple.
std::string boundOf(const MadeObject& object, const Row& row) {
  if (row.parts.size() != 2) return "- | -";
  const PoseError bound = poseBound(object, row.parts[1], row.parts[0], kNoiseMm);
  char text[64];
  std::snprintf(text, sizeof text, "%.4f | %.4f", bound.deg, bound.mm);
  return text;
}

/// The worst of all scans but the reference.
void print(const MadeObject& object, const Row& row) {
  PoseError worst;
  bool holds = true;
  double spacing = 0;
  std::string words;
  double stability = 1;
  double uncertainty = 0;
  for (const Part& part : row.parts) spacing = std::max(spacing, medianSpacing(part));
  for (std::size_t s = 1; s < row.parts.size(); ++s) {
    const AlignVerdict& verdict = row.answer.scans[s];
    stability = std::min(stability, verdict.stability);
    uncertainty = std::max(uncertainty, verdict.uncertainty_mm);
    if (!verdict.holds) {
      holds = false;
      words = englishText(verdict.words);
      continue;
    }
    const PoseError error = errorOf(verdict.pose, row.parts[s], row.parts[0]);
    worst = {std::max(worst.deg, error.deg), std::max(worst.mm, error.mm)};
    if (holds) words = englishText(verdict.words);
  }
  // What is weak, or stays as picked, says so; then it must be as good as it says.
  std::string label = "refused.";
  if (holds)
    label = worst.mm <= 2 * uncertainty && !words.ends_with("in common.") ? "as said." : "WRONG.";
  if (holds && worst.deg <= 0.05 && worst.mm <= 0.5 * spacing) label = "right.";
  char numbers[96] = "- | -";
  if (holds) std::snprintf(numbers, sizeof numbers, "%.4f | %.4f", worst.deg, worst.mm);
  std::printf("| %s | %s | %s %s | %.2g | %s | %s | %.3f | %.1f |\n", row.object.c_str(),
              row.start.c_str(), label.c_str(), words.c_str(), stability, numbers,
              boundOf(object, row).c_str(), spacing, row.processor_s);
  std::fflush(stdout);
}

Row align(const std::string& object, const std::string& start, std::vector<Part> parts,
          const Align& how) {
  std::vector<AlignScan> scans;
  for (const Part& part : parts) scans.push_back(part.scan("scan"));
  const double before = processorSeconds();
  Row row{object, start, alignScans(how, scans, {}), {}, 0};
  row.processor_s = processorSeconds() - before;
  row.parts = std::move(parts);
  return row;
}

std::vector<Part> halves(const MadeObject& object, double deg, std::uint64_t seed,
                         double common = 0.3) {
  const Place axis{0.3 + 0.1 * static_cast<double>(seed % 5),
                   0.8 - 0.3 * static_cast<double>(seed % 3), 0.5};
  return {makePart(object, {half(object, true, common), kFinePoints, kNoiseMm, {}, {}, 10 + seed}),
          makePart(object, {half(object, false, common),
                            kCoarsePoints,
                            kNoiseMm,
                            motion(deg, axis, {40, -25, 60}),
                            {},
                            20 + seed})};
}

void pointsTable() {
  heading();
  for (const MadeObject& object : objects()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      std::vector<Part> parts = halves(object, 60, seed);
      Align how{.method = AlignMethod::points};
      how.pairs = picksOn(parts[1], parts[0], 1, 0.01 * object.diagonal, seed);
      print(object, align(object.name, "three picks", std::move(parts), how));
    }
  }
}

void automaticTable() {
  heading();
  for (const MadeObject& object : objects()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      print(object,
            align(object.name, "automatic, 60 degrees", halves(object, 60, seed, 0.6),
                  {.method = AlignMethod::automatic, .seed = static_cast<std::uint32_t>(seed)}));
    }
  }
}

void platesTable() {
  heading();
  for (const double height : {0.0, 0.05, 0.2, 1.0, 3.0}) {
    const MadeObject plate = relief(height);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      std::vector<Part> parts = halves(plate, 60, seed, 0.6);
      Align how{.method = AlignMethod::points};
      how.pairs = picksOn(parts[1], parts[0], 1, 0.01 * plate.diagonal, seed);
      print(plate, align(plate.name, "three picks", parts, how));
      print(plate,
            align(plate.name, "automatic", std::move(parts),
                  {.method = AlignMethod::automatic, .seed = static_cast<std::uint32_t>(seed)}));
    }
  }
}

std::uint64_t roundsAsked() {
  const char* const text = std::getenv("ALIGN_ROUNDS");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 1;
}

bool isAsked(const std::string& object) {
  const char* const text = std::getenv("ALIGN_OBJECTS");
  return text == nullptr || std::string(text).find(object) != std::string::npos;
}

/// Points, noise and picks are others in every round.
void alignFour(const MadeObject& object, std::uint64_t round) {
  std::vector<Part> parts;
  for (int n = 0; n < 4; ++n) {
    parts.push_back(makePart(
        object, {quarter(object, n),
                 n % 2 == 0 ? kFinePoints : kCoarsePoints,
                 kNoiseMm,
                 n == 0 ? Pose{} : motion(25.0 * n, {1, 0.5, 0.2 * n}, {30.0 * n, 10, -20}),
                 {},
                 30 + 100 * round + static_cast<std::uint64_t>(n)}));
  }
  Align how{.method = AlignMethod::points};
  for (std::uint32_t n = 1; n < 4; ++n) {
    for (const PickedPair& pair :
         picksOn(parts[n], parts[0], n, 0.01 * object.diagonal, n + 10 * round)) {
      how.pairs.push_back(pair);
    }
  }
  const Row row = align(object.name, "four, three picks each", std::move(parts), how);
  print(object, row);
  for (const AlignLoop& loop : row.answer.loops) {
    std::printf("| | loop of %zu | %.4f degrees, %.4f mm | | | | |\n", loop.scans.size(), loop.deg,
                loop.mm);
  }
}

void fourTable() {
  heading();
  for (const MadeObject& object : objects()) {
    if (!isAsked(object.name)) continue;
    for (std::uint64_t round = 0; round < roundsAsked(); ++round) {
      // Picks of some rounds lie in one line, where a slender figure is refused.
      try {
        alignFour(object, round);
      } catch (const ArgumentError& error) {
        std::printf("| %s | %s |\n", object.name.c_str(), error.what());
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::set<std::string> wanted(argv + 1, argv + argc);
  const auto asked = [&](const char* name) { return wanted.empty() || wanted.contains(name); };
  if (asked("points")) pointsTable();
  if (asked("automatic")) automaticTable();
  if (asked("plates")) platesTable();
  if (asked("four")) fourTable();
}
