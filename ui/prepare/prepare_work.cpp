// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/prepare_work.h"

#include <algorithm>
#include <cmath>

#include "core/base/failure.h"
#include "core/base/replaceable.h"
#include "core/io/export/write_cloud.h"
#include "core/io/formats/text_file.h"
#include "core/neighbours/point_neighbours.h"
#include "core/provenance/prepared_state.h"
#include "ui/work/pictures/scan_points.h"

namespace relievo {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb kGone{176, 48, 48};
constexpr Rgb kAlone{120, 120, 120};  // No other scan is near.
constexpr std::size_t kCheckEvery = 1U << 16U;
constexpr double kFarthestSpacings = 3;

/// Distinct also to people who see no red or green (Okabe and Ito 2008).
constexpr std::array<Rgb, 8> kScanColours{{{230, 159, 0},
                                           {86, 180, 233},
                                           {0, 158, 115},
                                           {240, 228, 66},
                                           {0, 114, 178},
                                           {213, 94, 0},
                                           {204, 121, 167},
                                           {200, 200, 200}}};

/// Blue, white, red: 0, 1/2, 1.
Rgb distanceColour(double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  const auto mix = [](double a, double b, double at) {
    return static_cast<std::uint8_t>(std::lround(a + (b - a) * at));
  };
  if (t < 0.5) return {mix(40, 245, 2 * t), mix(90, 245, 2 * t), mix(200, 245, 2 * t)};
  return {mix(245, 200, 2 * t - 1), mix(245, 40, 2 * t - 1), mix(245, 30, 2 * t - 1)};
}

Point3f turnedNormal(const Pose& pose, const Point3f& n) {
  if (pose == Pose{}) return n;
  Point3f out{};
  for (std::size_t r = 0; r < 3; ++r) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) sum += pose.m[4 * r + c] * static_cast<double>(n[c]);
    out[r] = static_cast<float>(sum);
  }
  return out;
}

/// Where a picture's points are counted from: the middle of the first scan's box, as it was laid.
FilePoint originOf(const Scan& scan, const Pose& pose) {
  const auto& box = scan.info.bounds;
  return pose(box ? 0.5 * (box->min + box->max) : scan.origin);
}

Point3f from(const FilePoint& origin, const FilePoint& p) {
  const FilePoint d = p - origin;
  return {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
}

/// The points of one scan in a picture.
struct Range {
  std::size_t first = 0, end = 0;
};

/// Distances from the surface that the other scans' points lie on, in spacings; negative: none is
/// near.
std::vector<float> distancesToOthers(const CloudPoints& cloud, const Range& of, const Task& task) {
  std::vector<Point3f> others, normals;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (i >= of.first && i < of.end) continue;
    others.push_back(cloud.points[i]);
    normals.push_back(cloud.normals[i]);
  }
  std::vector<float> distances(of.end - of.first, -1);
  if (others.empty() || !(cloud.spacing > 0)) return distances;
  const PointNeighbours near(others, task);
  const std::span<const Point3f> queries(cloud.points.data() + of.first, of.end - of.first);
  near.nearestTo(queries, 1, 0, task, [&](const NearPlaces& found) {
    if (found.places.empty()) return;
    const double far = std::sqrt(static_cast<double>(found.squared[0])) / cloud.spacing;
    if (far > kFarthestSpacings) return;
    const std::uint32_t place = found.places[0];
    const Point3f& p = near.place(place);
    const Point3f& n = normals[near.pointsAt(place)[0]];
    const Point3f& q = queries[found.of];
    double along = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      along += static_cast<double>(q[k] - p[k]) * static_cast<double>(n[k]);
    }
    const bool has_normal = n != Point3f{};
    distances[found.of] = static_cast<float>(has_normal ? std::abs(along) / cloud.spacing : far);
  });
  return distances;
}

void colourByDistance(CloudPoints& cloud, const std::vector<Range>& scans, const Task& task) {
  for (const Range& scan : scans) {
    const std::vector<float> distances = distancesToOthers(cloud, scan, task);
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const auto d = static_cast<double>(distances[i]);
      cloud.colours[scan.first + i] = d < 0 ? kAlone : distanceColour(d / kFarthestSpacings);
    }
  }
}

std::vector<InputFile> inputsOf(const PrepareResult& result, const std::filesystem::path& written,
                                const Task& task) {
  const std::filesystem::path folder = written.parent_path();
  std::vector<InputFile> inputs;
  for (std::size_t i = 0; i < result.used.size(); ++i) {
    const std::filesystem::path& file = result.choices.inputs[result.used[i]].file;
    inputs.push_back(inputFile(file, folder.empty() ? std::filesystem::path(".") : folder, task));
    if (inputs.back().sha256 != result.scans[i]->sha256) {
      throw failure<MessageId::input_changed_since_read>(file.filename().string());
    }
  }
  return inputs;
}

std::vector<FileRead> readBy(const PrepareResult& result) {
  std::vector<FileRead> files;
  for (const std::size_t i : result.used) files.push_back({result.choices.inputs[i].file});
  return files;
}

}  // namespace

std::array<std::uint8_t, 3> colourOfScan(std::size_t number) {
  return kScanColours[number % kScanColours.size()];
}

std::shared_ptr<const ReadScan> shownOf(std::shared_ptr<const Scan> scan, const std::string& sha256,
                                        std::size_t most, const Task& task) {
  auto read = std::make_shared<ReadScan>();
  ShownPoints shown = shownPoints(*scan, most, task);
  read->shown = std::move(shown.numbers);
  read->normals = std::move(shown.normals);
  read->spacing = shown.spacing;
  read->scan = std::move(scan);
  read->sha256 = sha256;
  return read;
}

std::shared_ptr<const ReadScan> readScan(const PrepareInput& input, std::size_t most,
                                         const Task& task) {
  ImportOptions import;
  import.accept_incomplete = input.accept_incomplete;
  import.scan = input.read;
  auto scan = std::make_shared<const Scan>(importScan(input.file, import, task));
  const std::string sha256 = sha256OfFile(input.file, task);
  return shownOf(std::move(scan), sha256, most, task);
}

CloudPoints cloudOf(const PrepareResult& result, const CloudWish& wish, const Task& task) {
  const bool before = wish.stage == CloudStage::before;
  const std::vector<Pose> as_stored(result.scans.size());
  const std::vector<Pose>& poses = before ? as_stored : result.prepared.answer.poses;
  const auto& steps = result.prepared.answer.steps;
  const PointBits* const kept = before || steps.empty() ? nullptr : &steps.back().kept;
  CloudPoints cloud;
  if (result.scans.empty()) return cloud;
  cloud.origin = originOf(*result.scans[0]->scan, poses[0]);
  std::vector<Range> ranges;
  std::vector<std::size_t> gone;
  std::size_t first = 0;
  for (std::size_t s = 0; s < result.scans.size(); ++s) {
    const ReadScan& read = *result.scans[s];
    cloud.spacing = std::max(cloud.spacing, read.spacing);
    Range range{cloud.points.size(), 0};
    for (std::size_t i = 0; i < read.shown.size(); ++i) {
      if (i % kCheckEvery == 0) task.check();
      const std::size_t point = read.shown[i];
      const bool stays = kept == nullptr || (*kept)[first + point];
      if (!stays && wish.stage == CloudStage::after) continue;
      if (!stays) gone.push_back(cloud.points.size());
      cloud.points.push_back(from(cloud.origin, poses[s](read.scan->point(point))));
      cloud.normals.push_back(turnedNormal(poses[s], read.normals[i]));
      cloud.colours.push_back(wish.colour == CloudColour::scan ? colourOfScan(result.used[s])
                                                               : shownColour(*read.scan, point));
    }
    range.end = cloud.points.size();
    ranges.push_back(range);
    first += read.scan->points.size();
  }
  if (wish.colour == CloudColour::distance) colourByDistance(cloud, ranges, task);
  for (const std::size_t i : gone) cloud.colours[i] = kGone;
  return cloud;
}

CloudPoints cloudOf(const ReadScan& read) {
  CloudPoints cloud;
  cloud.origin = originOf(*read.scan, Pose{});
  cloud.spacing = read.spacing;
  cloud.normals = read.normals;
  for (const std::uint32_t point : read.shown) {
    cloud.points.push_back(from(cloud.origin, read.scan->point(point)));
    cloud.colours.push_back(shownColour(*read.scan, point));
  }
  return cloud;
}

void writePrepared(const PrepareResult& result, const std::filesystem::path& file,
                   const Task& task) {
  requireReplaceable(file);
  requireNotAnInput(file, readBy(result));
  const std::vector<InputFile> inputs = inputsOf(result, file, task);
  const Recipe again = recipeAgain(result.recipe, result.prepared, inputs);
  writeCloud(file, result.prepared.scan,
             {.state = preparedState(again, result.prepared, inputs),
              .normals = result.prepared.answer.normals},
             task);
}

void writeRecipe(const PrepareResult& result, const std::filesystem::path& file, const Task& task) {
  requireReplaceable(file);
  requireNotAnInput(file, readBy(result));
  const std::vector<InputFile> inputs = inputsOf(result, file, task);
  writeTextFile(file, recipeText(recipeAgain(result.recipe, result.prepared, inputs)) + "\n");
}

}  // namespace relievo
