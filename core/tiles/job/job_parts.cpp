// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/job/job_parts.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <type_traits>

namespace relievo {
namespace {

constexpr const char* kDecisions = "decided.part";

std::string nameOf(const char* folder, std::uint64_t number) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%s/%09llu.part", folder,
                static_cast<unsigned long long>(number));
  return text.data();
}

template <class T>
std::string_view bytesOf(const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}
template <class T>
std::string_view bytesOf(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Takes values from the beginning of a part's content; what is too short gives nothing.
class Content {
 public:
  explicit Content(std::string_view bytes) : rest_(bytes) {}

  template <class T>
  bool take(T& value) {
    return takeBytes(&value, sizeof(T));
  }
  template <class T>
  bool take(std::vector<T>& values, std::size_t count) {
    if (rest_.size() / sizeof(T) < count) return false;
    values.resize(count);
    return takeBytes(values.data(), count * sizeof(T));
  }
  std::string_view rest() const { return rest_; }

 private:
  bool takeBytes(void* to, std::size_t bytes) {
    if (rest_.size() < bytes) return false;
    if (bytes > 0) std::memcpy(to, rest_.data(), bytes);
    rest_.remove_prefix(bytes);
    return true;
  }
  std::string_view rest_;
};

struct StoredDecisions {
  std::uint64_t hidden = 0, strays = 0, on_front = 0;
  std::int64_t rule = 0;
};

/// Of rows of tiles.
struct RowsHead {
  std::int32_t first_row = 0, rows = 0;
  std::uint64_t outliers = 0, cells = 0, cells_in_layers = 0;
  double hidden = 0, all = 0;
  std::uint16_t has_between = 0, has_steep = 0, has_points = 0, has_hidden = 0;
};

/// Of a part of the points; then for each of its tiles a TileRun, then the points.
struct PointsHead {
  std::uint64_t tiles = 0, points = 0;
  std::uint64_t hidden = 0, strays = 0, on_front = 0;
};

}  // namespace

std::optional<PointDecisions> loadDecisions(JobFolder& job) {
  const std::optional<std::string> content = job.load(kDecisions);
  if (!content) return std::nullopt;
  Content bytes(*content);
  StoredDecisions stored;
  if (!bytes.take(stored)) return std::nullopt;
  // Kept as bytes: a folder goes on with the same program only (JobFacts).
  std::optional<Message> reason = messageFromBytes(bytes.rest());
  if (!reason) return std::nullopt;
  return PointDecisions{
      .rule = {.rule = static_cast<PointRule>(stored.rule), .reason = *std::move(reason)},
      .left_out = {.hidden = stored.hidden, .strays = stored.strays, .on_front = stored.on_front}};
}

void keepDecisions(JobFolder& job, const PointDecisions& decisions) {
  StoredDecisions stored;
  stored.hidden = decisions.left_out.hidden;
  stored.strays = decisions.left_out.strays;
  stored.on_front = decisions.left_out.on_front;
  stored.rule = static_cast<std::int64_t>(decisions.rule.rule);
  const std::string reason = messageBytes(decisions.rule.reason);
  job.keep(kDecisions, {bytesOf(stored), reason});
}

std::optional<DepthRows> loadRows(JobFolder& job, int tile_row, GridSize map) {
  const std::optional<std::string> content =
      job.load(nameOf("heights", static_cast<std::uint64_t>(tile_row)));
  if (!content) return std::nullopt;
  Content bytes(*content);
  RowsHead head;
  if (!bytes.take(head) || head.first_row != tile_row * kTileSide) return std::nullopt;
  DepthRows rows;
  rows.first_row = head.first_row;
  rows.rows = head.rows;
  const std::size_t cells =
      static_cast<std::size_t>(head.rows) * static_cast<std::size_t>(map.cols);
  const bool is_whole = bytes.take(rows.front, cells) &&
                        bytes.take(rows.between, head.has_between != 0 ? cells : 0) &&
                        bytes.take(rows.steep, head.has_steep != 0 ? cells : 0) &&
                        bytes.take(rows.points, head.has_points != 0 ? cells : 0);
  if (!is_whole) return std::nullopt;
  rows.outliers = head.outliers;
  if (head.has_hidden != 0) {
    rows.hidden = HiddenSurface{.hidden = head.hidden,
                                .all = head.all,
                                .cells = head.cells,
                                .cells_in_layers = head.cells_in_layers};
  }
  return rows;
}

void keepRows(JobFolder& job, int tile_row, const DepthRows& rows) {
  RowsHead head;
  head.first_row = rows.first_row;
  head.rows = rows.rows;
  head.outliers = rows.outliers;
  head.has_between = rows.between.empty() ? 0 : 1;
  head.has_steep = rows.steep.empty() ? 0 : 1;
  head.has_points = rows.points.empty() ? 0 : 1;
  if (rows.hidden) {
    head.has_hidden = 1;
    head.hidden = rows.hidden->hidden;
    head.all = rows.hidden->all;
    head.cells = rows.hidden->cells;
    head.cells_in_layers = rows.hidden->cells_in_layers;
  }
  job.keep(nameOf("heights", static_cast<std::uint64_t>(tile_row)),
           {bytesOf(head), bytesOf(rows.front), bytesOf(rows.between), bytesOf(rows.steep),
            bytesOf(rows.points)});
}

namespace {

struct PartFound {
  std::vector<TileRun> runs;
  LeftOut left_out;
};

std::optional<PartFound> loadPart(JobFolder& job, const std::string& name) {
  const std::optional<std::string> content = job.load(name);
  if (!content) return std::nullopt;
  Content bytes(*content);
  PointsHead head;
  PartFound found;
  if (!bytes.take(head) || !bytes.take(found.runs, head.tiles) ||
      bytes.rest().size() != head.points * sizeof(CellPoint)) {
    return std::nullopt;
  }
  found.left_out = {.hidden = head.hidden, .strays = head.strays, .on_front = head.on_front};
  return found;
}

PartFound makePart(JobFolder& job, const std::string& name, TileStore& store,
                   std::vector<TilePoint> placed, const LeftOut& left_out) {
  std::vector<CellPoint> points;
  PartFound found{.runs = store.sorted(placed, points), .left_out = left_out};
  std::vector<TilePoint>().swap(placed);
  PointsHead head{.tiles = found.runs.size(),
                  .points = points.size(),
                  .hidden = left_out.hidden,
                  .strays = left_out.strays,
                  .on_front = left_out.on_front};
  for (TileRun& run : found.runs) {
    run.at = sizeof(head) + found.runs.size() * sizeof(TileRun) + run.at * sizeof(CellPoint);
  }
  job.keep(name, {bytesOf(head), bytesOf(found.runs), bytesOf(points)});
  return found;
}

}  // namespace

LeftOut scatterByParts(const PointSource& source, const ViewFromFile& view_from_file,
                       const GridFrame& frame, TileStore& store, JobFolder& job,
                       std::uint64_t part_points, KnownParts& known, const Task& task,
                       const FrontSurface* front) {
  LeftOut left_out;
  for (std::uint64_t start = 0; start < source.count; start += part_points) {
    task.check();
    task.report("Sorting points into tiles",
                static_cast<double>(start) / static_cast<double>(source.count));
    const std::uint64_t end = std::min(start + part_points, source.count);
    const std::string name = nameOf("points", start / part_points);
    std::optional<PartFound> part = loadPart(job, name);
    if (part) {
      known.points += end - start;
      ++known.parts;
    } else {
      LeftOut of_part;
      std::vector<TilePoint> placed =
          placedPoints(source, view_from_file, frame, {.first = start, .count = end - start},
                       store.threads(), of_part, front);
      part = makePart(job, name, store, std::move(placed), of_part);
    }
    store.adopt(job.fileOf(name), part->runs);
    left_out.hidden += part->left_out.hidden;
    left_out.strays += part->left_out.strays;
    left_out.on_front += part->left_out.on_front;
  }
  return left_out;
}

}  // namespace relievo
