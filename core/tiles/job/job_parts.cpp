// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/job/job_parts.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "core/base/exchange.h"
#include "core/base/plain_bytes.h"

namespace relievo {
namespace {

constexpr const char* kDecisions = "decided.part";

std::string nameOf(const char* folder, std::uint64_t number) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%s/%09llu.part", folder,
                static_cast<unsigned long long>(number));
  return text.data();
}

struct StoredDecisions {
  std::uint64_t hidden = 0, strays = 0, on_front = 0;
  std::int64_t rule = 0;
};

/// Of a part of the points; then for each of its tiles a TileRun, then the points.
struct PointsHead {
  std::uint64_t tiles = 0, points = 0;
  std::uint64_t hidden = 0, strays = 0, on_front = 0;
};

}  // namespace

std::optional<PointDecisions> decisionsFrom(std::string_view content) {
  PlainBytes bytes(content);
  StoredDecisions stored;
  if (!bytes.take(stored)) return std::nullopt;
  // Kept as bytes: a folder goes on with the same program only (JobFacts).
  std::optional<Message> reason = messageFromBytes(bytes.rest());
  if (!reason) return std::nullopt;
  return PointDecisions{
      .rule = {.rule = static_cast<PointRule>(stored.rule), .reason = *std::move(reason)},
      .left_out = {.hidden = stored.hidden, .strays = stored.strays, .on_front = stored.on_front}};
}

std::string bytesOfDecisions(const PointDecisions& decisions) {
  StoredDecisions stored;
  stored.hidden = decisions.left_out.hidden;
  stored.strays = decisions.left_out.strays;
  stored.on_front = decisions.left_out.on_front;
  stored.rule = static_cast<std::int64_t>(decisions.rule.rule);
  return std::string(plainBytes(stored)) + messageBytes(decisions.rule.reason);
}

std::optional<PointDecisions> loadDecisions(JobFolder& job) {
  const std::optional<std::string> content = job.load(kDecisions);
  return content ? decisionsFrom(*content) : std::nullopt;
}

void keepDecisions(JobFolder& job, const PointDecisions& decisions) {
  job.keep(kDecisions, {bytesOfDecisions(decisions)});
}

RowsHead headOf(const DepthRows& rows) {
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
  return head;
}

std::optional<HiddenSurface> hiddenOf(const RowsHead& head) {
  if (head.has_hidden == 0) return std::nullopt;
  return HiddenSurface{.hidden = head.hidden,
                       .all = head.all,
                       .cells = head.cells,
                       .cells_in_layers = head.cells_in_layers};
}

std::optional<DepthRows> loadRows(JobFolder& job, int tile_row, GridSize map) {
  const std::optional<std::string> content =
      job.load(nameOf("heights", static_cast<std::uint64_t>(tile_row)));
  if (!content) return std::nullopt;
  PlainBytes bytes(*content);
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
  rows.hidden = hiddenOf(head);
  return rows;
}

void keepRows(JobFolder& job, int tile_row, const DepthRows& rows) {
  const RowsHead head = headOf(rows);
  job.keep(nameOf("heights", static_cast<std::uint64_t>(tile_row)),
           {plainBytes(head), plainBytes(rows.front), plainBytes(rows.between),
            plainBytes(rows.steep), plainBytes(rows.points)});
}

bool JobBands::load(int number, std::size_t cells, FilledBand& band) {
  const std::optional<std::string> content =
      job_.load(nameOf("filled", static_cast<std::uint64_t>(number)));
  if (!content) return false;
  PlainBytes bytes(*content);
  return bytes.take(band.heights_mm, cells) && bytes.take(band.origins, cells) &&
         bytes.rest().empty();
}

void JobBands::keep(int number, const FilledBand& band) {
  job_.keep(nameOf("filled", static_cast<std::uint64_t>(number)),
            {plainBytes(band.heights_mm), plainBytes(band.origins)});
}

namespace {

struct PartFound {
  std::vector<TileRun> runs;
  LeftOut left_out;
};

std::optional<PartFound> loadPart(JobFolder& job, const std::string& name) {
  const std::optional<std::string> content = job.load(name);
  if (!content) return std::nullopt;
  PlainBytes bytes(*content);
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
  job.keep(name, {plainBytes(head), plainBytes(found.runs), plainBytes(points)});
  return found;
}

/// For the processes that did not make it.
std::string bytesOfPart(const PartFound& part) {
  const PointsHead head{.tiles = part.runs.size(),
                        .points = 0,
                        .hidden = part.left_out.hidden,
                        .strays = part.left_out.strays,
                        .on_front = part.left_out.on_front};
  return std::string(plainBytes(head)) + std::string(plainBytes(part.runs));
}

PartFound partFrom(PlainBytes& bytes) {
  PointsHead head;
  PartFound part;
  bytes.take(head);
  bytes.take(part.runs, head.tiles);
  part.left_out = {.hidden = head.hidden, .strays = head.strays, .on_front = head.on_front};
  return part;
}

/// Parts of all points, made or found, each process its own ones.
class PartMaker {
 public:
  PartMaker(const PointSource& source, const ViewFromFile& view_from_file, const GridFrame& frame,
            TileStore& store, JobFolder& job, std::uint64_t part_points, const FrontSurface* front)
      : source_(source),
        view_from_file_(view_from_file),
        frame_(frame),
        store_(store),
        job_(job),
        part_points_(part_points),
        front_(front) {}

  std::uint64_t count() const { return (source_.count + part_points_ - 1) / part_points_; }
  static std::string nameOfPart(std::uint64_t number) { return nameOf("points", number); }

  PartFound part(std::uint64_t number, KnownParts& known) {
    const std::string name = nameOfPart(number);
    const std::uint64_t start = number * part_points_;
    const std::uint64_t count = std::min(part_points_, source_.count - start);
    if (std::optional<PartFound> there = loadPart(job_, name)) {
      known.points += count;
      ++known.parts;
      return *std::move(there);
    }
    LeftOut of_part;
    std::vector<TilePoint> placed =
        placedPoints(source_, view_from_file_, frame_, {.first = start, .count = count},
                     store_.threads(), of_part, front_);
    return makePart(job_, name, store_, std::move(placed), of_part);
  }

 private:
  const PointSource& source_;
  const ViewFromFile& view_from_file_;
  const GridFrame& frame_;
  TileStore& store_;
  JobFolder& job_;
  std::uint64_t part_points_;
  const FrontSurface* front_;
};

}  // namespace

LeftOut scatterByParts(const PointSource& source, const ViewFromFile& view_from_file,
                       const GridFrame& frame, TileStore& store, JobFolder& job,
                       std::uint64_t part_points, KnownParts& known, const Task& task,
                       const FrontSurface* front, Exchange* processes) {
  Alone alone;
  Exchange& all = processes != nullptr ? *processes : alone;
  PartMaker maker(source, view_from_file, frame, store, job, part_points, front);
  const auto ranks = static_cast<std::uint64_t>(all.ranks());
  LeftOut left_out;
  const auto adopt = [&](std::uint64_t number, const PartFound& part) {
    store.adopt(job.fileOf(PartMaker::nameOfPart(number)), part.runs);
    left_out.hidden += part.left_out.hidden;
    left_out.strays += part.left_out.strays;
    left_out.on_front += part.left_out.on_front;
  };
  std::string mine;
  KnownParts found;
  for (std::uint64_t number = static_cast<std::uint64_t>(all.rank()); number < maker.count();
       number += ranks) {
    task.check();
    task.report("Sorting points into tiles",
                static_cast<double>(number) / static_cast<double>(maker.count()));
    const PartFound part = maker.part(number, found);
    if (all.isAlone()) {
      adopt(number, part);
    } else {
      mine += bytesOfPart(part);
    }
  }
  const std::vector<std::string> told = all.share(std::string(plainBytes(found)) + mine);
  std::vector<PlainBytes> bytes(told.begin(), told.end());
  for (PlainBytes& one : bytes) {
    KnownParts by_one;
    one.take(by_one);
    known.points += by_one.points;
    known.parts += by_one.parts;
  }
  for (std::uint64_t number = 0; !all.isAlone() && number < maker.count(); ++number) {
    adopt(number, partFrom(bytes[number % ranks]));
  }
  return left_out;
}

}  // namespace relievo
