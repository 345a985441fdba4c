// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/worker/stream_worker.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <system_error>
#include <thread>
#include <utility>

#include "core/base/error.h"
#include "core/file/whole_bytes.h"
#include "core/io/formats/lines.h"
#include "core/io/point_reader.h"
#include "core/io/worker/answer_text.h"
#include "core/io/worker/stream_protocol.h"

namespace relievo {
namespace {

bool writeWhole(int fd, const void* from, std::size_t bytes) {
  const auto* at = static_cast<const char*>(from);
  while (bytes > 0) {
    const ssize_t written = ::write(fd, at, bytes);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    at += written;
    bytes -= static_cast<std::size_t>(written);
  }
  return true;
}

/// One channel and its slice.
class Service {
 public:
  Service(const PointReader& reader, const StreamSetup& setup, int channel,
          const std::function<WorkerRefusal()>& refusal)
      : reader_(reader),
        refusal_(refusal),
        fd_(kFirstChannelFd + channel),
        slices_(kFirstChannelFd + setup.channels),
        slice_at_(static_cast<std::uint64_t>(channel) * kSliceBytes) {}

  void run() {
    StreamRequest request;
    while (readWhole(fd_, &request, sizeof(request))) {
      StreamReply reply;
      try {
        reply.count = answer(request);
      } catch (...) {
        reply = refuse();
      }
      if (!writeWhole(fd_, &reply, sizeof(reply))) return;
    }
  }

 private:
  std::uint64_t answer(const StreamRequest& request) {
    switch (request.ask) {
      case StreamAsk::values:
        values_.resize(std::min<std::uint64_t>(request.count, kPointsAtOnce));
        [[fallthrough]];
      case StreamAsk::points:
        return points(request);
      case StreamAsk::ranges:
        return ranges(request);
      case StreamAsk::cheap_sample:
        return cheapSample(request);
    }
    return 0;
  }

  std::uint64_t points(const StreamRequest& request) {
    const bool with_values = request.ask == StreamAsk::values;
    points_.resize(std::min<std::uint64_t>(request.count, kPointsAtOnce));
    const std::size_t got = reader_.read(
        request.first, points_, with_values ? std::span(values_) : std::span<StoredValues>());
    put(0, points_.data(), got * sizeof(FilePoint));
    if (with_values) {
      put(kPointsAtOnce * sizeof(FilePoint), values_.data(), got * sizeof(StoredValues));
    }
    return got;
  }

  std::uint64_t ranges(const StreamRequest& request) {
    std::vector<PointRange> wanted(std::min<std::uint64_t>(request.count, kRangesAtOnce));
    if (::pread(slices_, wanted.data(), wanted.size() * sizeof(PointRange),
                static_cast<off_t>(slice_at_)) < 0) {
      return 0;
    }
    points_.resize(kPointsAtOnce);
    std::size_t done = 0;
    for (const PointRange& range : wanted) {
      const auto room = std::min<std::uint64_t>(range.count, points_.size() - done);
      done += reader_.read(range.first, std::span(points_).subspan(done, room));
    }
    put(0, points_.data(), done * sizeof(FilePoint));
    return done;
  }

  std::uint64_t cheapSample(const StreamRequest& request) {
    const std::vector<PointRange> all = reader_.cheapSample(request.count);
    if (request.first >= all.size()) return 0;
    const std::size_t count =
        std::min(all.size() - static_cast<std::size_t>(request.first), kRangesAtOnce);
    put(0, all.data() + request.first, count * sizeof(PointRange));
    return count;
  }

  StreamReply refuse() {
    const WorkerRefusal why = refusal_();
    Packer packer;
    packer.put(why.message);
    packer.put(why.code);
    packer.put(why.of_catalogue);
    const std::size_t bytes = std::min(packer.bytes().size(), kSliceBytes);
    put(0, packer.bytes().data(), bytes);
    return {.refused = 1, .count = bytes};
  }

  void put(std::size_t at, const void* from, std::size_t bytes) const {
    const auto* start = static_cast<const char*>(from);
    while (bytes > 0) {
      const ssize_t written = ::pwrite(slices_, start, bytes, static_cast<off_t>(slice_at_ + at));
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) throw Error("The points cannot be passed on.");
      start += written;
      at += static_cast<std::size_t>(written);
      bytes -= static_cast<std::size_t>(written);
    }
  }

  const PointReader& reader_;
  const std::function<WorkerRefusal()>& refusal_;
  int fd_, slices_;
  std::uint64_t slice_at_;
  std::vector<FilePoint> points_;
  std::vector<StoredValues> values_;
};

}  // namespace

std::vector<std::string> argumentsOf(const StreamSetup& setup) {
  return {std::to_string(setup.channels),
          setup.parts == StreamedParts::values ? "values" : "places"};
}

std::optional<StreamSetup> streamSetupOf(std::span<const std::string> arguments) {
  if (arguments.size() != 2) return std::nullopt;
  const auto channels = parseWhole<int>(arguments[0]);
  if (!channels || *channels < 1 || *channels > kMostChannels) return std::nullopt;
  return StreamSetup{
      .channels = *channels,
      .parts = arguments[1] == "values" ? StreamedParts::values : StreamedParts::places};
}

void servePoints(const std::filesystem::path& file, const ImportOptions& options,
                 const StreamSetup& setup, const Task& task,
                 const std::function<WorkerRefusal()>& refusal) {
  PointReader reader(file, options, task, setup.parts);
  sendAnswer(kAnswerFd, textOf(reader.head()));
  const StreamReply ready;
  StreamStart start;
  if (!writeWhole(kFirstChannelFd, &ready, sizeof(ready)) ||
      !readWhole(kFirstChannelFd, &start, sizeof(start))) {
    return;
  }
  reader.convertHeights(start.height_factor);
  std::vector<std::jthread> threads;
  try {
    for (int channel = 1; channel < setup.channels; ++channel) {
      threads.emplace_back(
          [&reader, &setup, &refusal, channel] { Service(reader, setup, channel, refusal).run(); });
    }
  } catch (const std::system_error&) {
    // The system refuses a thread. Those that run wait for questions and would never be joined.
    std::_Exit(EXIT_FAILURE);
  }
  Service(reader, setup, 0, refusal).run();
}

WorkerText textOf(const PointStreamHead& head) {
  Packer packer;
  pack(head.info, packer);
  packer.put(static_cast<std::uint64_t>(head.stated_bounds.has_value()));
  packer.put(head.stated_bounds.value_or(FileBounds{}));
  for (const auto& type : {head.colour_type, head.intensity_type}) {
    packer.put(type ? static_cast<std::int64_t>(*type) : std::int64_t{-1});
  }
  packer.put(static_cast<std::uint64_t>(head.word_intensities));
  packer.put(static_cast<std::uint64_t>(head.is_packed));
  packer.put(head.colour_source);
  packer.put(head.kept_bytes);
  packer.put(static_cast<std::uint64_t>(head.system.has_value()));
  if (head.system) pack(*head.system, packer);
  packer.put(head.warnings_before_system);
  return {packer.bytes()};
}

std::optional<PointStreamHead> streamHeadOf(const WorkerText& text) {
  constexpr std::uint64_t kMostPoints = 1ULL << 48U;
  constexpr std::uint64_t kMostKept = 1ULL << 32U;
  Unpacker unpacker(text.bytes);
  PointStreamHead head;
  if (!unpack(unpacker, head.info)) return std::nullopt;
  const bool has_bounds = unpacker.get<std::uint64_t>() != 0;
  const auto bounds = unpacker.get<FileBounds>();
  if (has_bounds && !(isFinite(bounds.min) && isFinite(bounds.max))) return std::nullopt;
  if (has_bounds) head.stated_bounds = bounds;
  for (auto* const type : {&head.colour_type, &head.intensity_type}) {
    const auto number = unpacker.get<std::int64_t>();
    if (number > static_cast<std::int64_t>(ScalarType::f64)) return std::nullopt;
    if (number >= 0) *type = static_cast<ScalarType>(number);
  }
  head.word_intensities = unpacker.get<std::uint64_t>() != 0;
  head.is_packed = unpacker.get<std::uint64_t>() != 0;
  head.colour_source = unpacker.text();
  head.kept_bytes = unpacker.get<std::uint64_t>();
  LasSystem system;
  const bool has_system = unpacker.get<std::uint64_t>() != 0;
  if (has_system && !unpack(unpacker, system)) return std::nullopt;
  if (has_system) head.system = system;
  head.warnings_before_system = unpacker.get<std::uint64_t>();
  const bool sound = unpacker.good() && head.info.points >= 1 && head.info.points <= kMostPoints &&
                     head.kept_bytes <= kMostKept &&
                     head.warnings_before_system <= head.info.warnings.size();
  return sound ? std::optional(std::move(head)) : std::nullopt;
}

}  // namespace relievo
