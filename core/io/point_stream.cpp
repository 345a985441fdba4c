// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/point_stream.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "core/base/control_group.h"
#include "core/base/error.h"
#include "core/file/owned_fd.h"
#include "core/io/file_check.h"
#include "core/io/input_facts.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"
#include "core/io/system_unit.h"
#include "core/io/worker/answer_text.h"
#include "core/io/worker/import_answer.h"
#include "core/io/worker/stream_protocol.h"
#include "core/io/worker/stream_worker.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr suseconds_t kLookUs = 50'000;      ///< Between two looks at the stop token.
constexpr double kMostCpuS = 7 * 24 * 3600;  ///< A stream is as long as the work on it.

int channelCount() {
  return std::min(usableCores(), kMostChannels);
}

/// A socket that forgets to wait after a while; the other end is above the numbers of a child.
void makeChannel(OwnedFd& ours, OwnedFd& childs) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    raised(-1);  // Says it.
  }
  ours.reset(ends[0]);
  childs.reset(raised(ends[1]));
  const timeval look{.tv_sec = 0, .tv_usec = kLookUs};
  ::setsockopt(ours.get(), SOL_SOCKET, SO_RCVTIMEO, &look, sizeof(look));
}

/// What the program may have sent instead of points is none.
bool isPoint(const FilePoint& p) {
  const bool none = std::isnan(p.x) && std::isnan(p.y) && std::isnan(p.z);
  return none || (std::abs(p.x) <= kFarthestCoordinate && std::abs(p.y) <= kFarthestCoordinate &&
                  std::abs(p.z) <= kFarthestCoordinate);
}

}  // namespace

struct PointStream::Impl {
  Impl(const std::filesystem::path& wanted, const ImportOptions& limits, const Task& work,
       StreamedParts parts)
      : file(wanted), options(limits), task{.stop = work.stop, .progress = {}} {
    options.max_cpu_s = kMostCpuS;
    open(work, parts);
  }

  /// A channel while a thread has it.
  class Lease {
   public:
    explicit Lease(Impl& impl) : impl_(impl), channel_(impl.take()) {}
    ~Lease() { impl_.giveBack(channel_); }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    int channel() const { return channel_; }

   private:
    Impl& impl_;
    int channel_;
  };

  void open(const Task& work, StreamedParts parts);
  void takeHead(const Task& work);
  int take();
  void giveBack(int channel);
  /// @return  what the process counted @throw FileError  what it refused with; Cancelled
  std::uint64_t ask(int channel, const StreamRequest& request);
  void receive(int channel, void* out, std::size_t bytes);
  void send(int channel, const void* from, std::size_t bytes);
  void fetch(int channel, std::size_t at, void* out, std::size_t bytes);
  void put(int channel, const void* from, std::size_t bytes);
  [[noreturn]] void refuseEnded();           ///< It closed its end.
  [[noreturn]] void refuseNonsense() const;  ///< It answered what it must not.
  void check(std::span<const FilePoint> points);

  std::filesystem::path file;
  ImportOptions options;
  Task task;
  PointStreamHead head;
  std::vector<OwnedFd> channels;  ///< Our ends.
  OwnedFd slices;
  std::unique_ptr<WorkerProcess> worker;
  std::mutex mutex;
  std::condition_variable freed;
  std::vector<int> free;  ///< Channels that no thread has now.
};

void PointStream::Impl::open(const Task& work, StreamedParts parts) {
  const StreamSetup setup{.channels = channelCount(), .parts = parts};
  std::vector<OwnedFd> childs(static_cast<std::size_t>(setup.channels));
  channels.resize(childs.size());
  std::vector<FdForChild> fds;
  for (std::size_t i = 0; i < childs.size(); ++i) {
    makeChannel(channels[i], childs[i]);
    fds.push_back({childs[i].get(), kFirstChannelFd + static_cast<int>(i)});
  }
  slices.reset(raised(::memfd_create("relievo-points", MFD_CLOEXEC)));
  fds.push_back({slices.get(), kFirstChannelFd + setup.channels});
  worker = std::make_unique<WorkerProcess>(ImportAsk{.program = ImportProgram::own,
                                                     .file = file,
                                                     .kind = ImportKind::points,
                                                     .options = options,
                                                     .answer_folder = {},
                                                     .more = argumentsOf(setup),
                                                     .fds = std::move(fds)});
  childs.clear();  // What the process does not hold any more is closed.
  takeHead(work);
  for (int i = 0; i < setup.channels; ++i) free.push_back(i);
}

void PointStream::Impl::takeHead(const Task& work) {
  worker->waitFor(channels[0].get(), work);
  StreamReply ready;
  if (::recv(channels[0].get(), &ready, sizeof(ready), 0) != sizeof(ready)) {
    const WorkerEnd end = worker->wait(work);
    const WorkerAnswer answer = receiveAnswer(worker->answerFd(), work);
    if (const auto* refusal = std::get_if<WorkerRefusal>(&answer)) throwRefusal(*refusal);
    refuseEnd(file, options, end);
  }
  const WorkerAnswer answer = receiveAnswer(worker->answerFd(), work);
  const auto* text = std::get_if<WorkerText>(&answer);
  auto known = text != nullptr ? streamHeadOf(*text) : std::nullopt;
  if (!known) refuseNonsense();
  head = std::move(*known);
  head.info.file = file;
  StreamStart start;
  if (head.system) {
    ScanInfo said;
    start.height_factor = addUnitOfSystem(*head.system, said);
    head.info.unit = said.unit;
    head.info.warnings.insert(
        head.info.warnings.begin() + static_cast<std::ptrdiff_t>(head.warnings_before_system),
        said.warnings.begin(), said.warnings.end());
    if (head.stated_bounds) {
      head.stated_bounds->min.z *= start.height_factor;
      head.stated_bounds->max.z *= start.height_factor;
    }
  }
  send(0, &start, sizeof(start));
}

int PointStream::Impl::take() {
  std::unique_lock lock(mutex);
  freed.wait(lock, [this] { return !free.empty(); });
  const int channel = free.back();
  free.pop_back();
  return channel;
}

void PointStream::Impl::giveBack(int channel) {
  {
    const std::scoped_lock lock(mutex);
    free.push_back(channel);
  }
  freed.notify_one();
}

void PointStream::Impl::refuseEnded() {
  const std::scoped_lock lock(mutex);
  refuseEnd(file, options, worker->wait(task));
}

void PointStream::Impl::refuseNonsense() const {
  refuseEnd(file, options, {});
}

void PointStream::Impl::send(int channel, const void* from, std::size_t bytes) {
  const int fd = channels[static_cast<std::size_t>(channel)].get();
  ssize_t sent = 0;
  do {
    sent = ::send(fd, from, bytes, MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  // Requests are few bytes, and there is never more than one.
  if (sent != static_cast<ssize_t>(bytes)) refuseEnded();
}

void PointStream::Impl::receive(int channel, void* out, std::size_t bytes) {
  const int fd = channels[static_cast<std::size_t>(channel)].get();
  auto* to = static_cast<char*>(out);
  while (bytes > 0) {
    const ssize_t got = ::recv(fd, to, bytes, 0);
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) {
      task.check();  // Whoever is answered no more asks no more: the stop stays.
      continue;
    }
    if (got <= 0) refuseEnded();
    to += got;
    bytes -= static_cast<std::size_t>(got);
  }
}

void PointStream::Impl::fetch(int channel, std::size_t at, void* out, std::size_t bytes) {
  auto* to = static_cast<char*>(out);
  std::uint64_t from = static_cast<std::uint64_t>(channel) * kSliceBytes + at;
  while (bytes > 0) {
    const ssize_t got = ::pread(slices.get(), to, bytes, static_cast<off_t>(from));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) refuseNonsense();
    to += got;
    from += static_cast<std::uint64_t>(got);
    bytes -= static_cast<std::size_t>(got);
  }
}

void PointStream::Impl::put(int channel, const void* from, std::size_t bytes) {
  const auto at = static_cast<off_t>(static_cast<std::uint64_t>(channel) * kSliceBytes);
  if (::pwrite(slices.get(), from, bytes, at) != static_cast<ssize_t>(bytes)) {
    throwReadError(file, said<MessageId::refused_points_not_kept>());
  }
}

std::uint64_t PointStream::Impl::ask(int channel, const StreamRequest& request) {
  task.check();
  send(channel, &request, sizeof(request));
  StreamReply reply;
  receive(channel, &reply, sizeof(reply));
  if (reply.refused == 0) return reply.count;
  std::string bytes(std::min<std::uint64_t>(reply.count, kSliceBytes), '\0');
  fetch(channel, 0, bytes.data(), bytes.size());
  Unpacker unpacker(std::move(bytes));
  WorkerRefusal refusal;
  refusal.message = unpacker.text();
  refusal.code = unpacker.text();
  refusal.of_catalogue = unpacker.text();
  if (!unpacker.good() || refusal.message.empty()) refuseNonsense();
  throwRefusal(refusal);
}

void PointStream::Impl::check(std::span<const FilePoint> points) {
  if (!std::all_of(points.begin(), points.end(), isPoint)) refuseNonsense();
}

bool PointStream::canStream(const std::filesystem::path& file) {
  return inputFacts(file).in_blocks;
}

PointStream::PointStream(const std::filesystem::path& file, const ImportOptions& options,
                         const Task& task, StreamedParts parts) {
  checkedFileSize(file);
  impl_ = std::make_unique<Impl>(file, options, task, parts);
}
PointStream::~PointStream() = default;

const ScanInfo& PointStream::info() const noexcept {
  return impl_->head.info;
}
const std::optional<FileBounds>& PointStream::statedBounds() const noexcept {
  return impl_->head.stated_bounds;
}
std::size_t PointStream::keptBytes() const noexcept {
  return static_cast<std::size_t>(impl_->head.kept_bytes);
}
std::optional<ScalarType> PointStream::colourType() const noexcept {
  return impl_->head.colour_type;
}
std::optional<ScalarType> PointStream::intensityType() const noexcept {
  return impl_->head.intensity_type;
}
bool PointStream::hasWordIntensities() const noexcept {
  return impl_->head.word_intensities;
}
const std::string& PointStream::colourSource() const noexcept {
  return impl_->head.colour_source;
}

std::size_t PointStream::read(std::uint64_t first, std::span<FilePoint> block) const {
  return read(first, block, {});
}

std::size_t PointStream::read(std::uint64_t first, std::span<FilePoint> block,
                              std::span<StoredValues> values) const {
  const std::uint64_t all = impl_->head.info.points;
  if (first >= all) return 0;
  const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), all - first));
  const Impl::Lease lease(*impl_);
  for (std::size_t done = 0; done < wanted;) {
    const std::size_t count = std::min(wanted - done, kPointsAtOnce);
    const std::uint64_t got =
        impl_->ask(lease.channel(), {.ask = values.empty() ? StreamAsk::points : StreamAsk::values,
                                     .first = first + done,
                                     .count = count});
    if (got != count) impl_->refuseNonsense();
    const std::span<FilePoint> points = block.subspan(done, count);
    impl_->fetch(lease.channel(), 0, points.data(), points.size_bytes());
    impl_->check(points);
    if (!values.empty()) {
      impl_->fetch(lease.channel(), kPointsAtOnce * sizeof(FilePoint), values.data() + done,
                   count * sizeof(StoredValues));
    }
    done += count;
  }
  return wanted;
}

void PointStream::read(std::span<const PointRange> ranges, std::span<FilePoint> block) const {
  const Impl::Lease lease(*impl_);
  while (!ranges.empty()) {
    // As many together as there is room for their points.
    std::size_t together = 0, points = 0;
    while (together < std::min(ranges.size(), kRangesAtOnce) &&
           points + ranges[together].count <= kPointsAtOnce) {
      points += static_cast<std::size_t>(ranges[together++].count);
    }
    impl_->put(lease.channel(), ranges.data(), together * sizeof(PointRange));
    const std::uint64_t got =
        impl_->ask(lease.channel(), {.ask = StreamAsk::ranges, .first = 0, .count = together});
    if (got != points || together == 0) impl_->refuseNonsense();
    impl_->fetch(lease.channel(), 0, block.data(), points * sizeof(FilePoint));
    impl_->check(block.first(points));
    ranges = ranges.subspan(together);
    block = block.subspan(points);
  }
}

std::vector<PointRange> PointStream::cheapSample(std::uint64_t points) const {
  std::vector<PointRange> ranges;
  if (!impl_->head.is_packed) return ranges;
  const Impl::Lease lease(*impl_);
  std::uint64_t got = kRangesAtOnce;
  while (got == kRangesAtOnce) {
    got = std::min(
        impl_->ask(lease.channel(),
                   {.ask = StreamAsk::cheap_sample, .first = ranges.size(), .count = points}),
        std::uint64_t{kRangesAtOnce});
    const std::size_t known = ranges.size();
    ranges.resize(known + static_cast<std::size_t>(got));
    impl_->fetch(lease.channel(), 0, ranges.data() + known,
                 static_cast<std::size_t>(got) * sizeof(PointRange));
    if (ranges.size() > kMostSampleRanges) impl_->refuseNonsense();
  }
  const std::uint64_t all = impl_->head.info.points;
  std::uint64_t left = all;  // A range may not be told again and again.
  const bool sound = std::all_of(ranges.begin(), ranges.end(), [&](const PointRange& range) {
    if (range.count > left) return false;
    left -= range.count;
    return range.first <= all && range.count <= all - range.first;
  });
  if (!sound) impl_->refuseNonsense();
  return ranges;
}

}  // namespace relievo
