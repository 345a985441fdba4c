// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/point_files.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <future>
#include <list>
#include <map>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "core/base/control_group.h"
#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using OpenStream = std::shared_ptr<const PointStream>;

constexpr int kMostOpen = 9;  // Processes at once; a few cost less than opening anew.
constexpr std::size_t kMostWarningsOfAll = 8;  // Of several files; more would not be read.

/// Opens streams on a thread of its own: an import process ends with the thread that started it,
/// and those that read come and go.
class Opener {
 public:
  Opener() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

  OpenStream open(std::function<OpenStream()> make) {
    std::packaged_task<OpenStream()> work(std::move(make));
    std::future<OpenStream> made = work.get_future();
    {
      const std::scoped_lock lock(mutex_);
      waiting_.push_back(std::move(work));
    }
    came_.notify_one();
    return made.get();
  }

 private:
  void run(const std::stop_token& stop) {
    for (;;) {
      std::packaged_task<OpenStream()> work;
      {
        std::unique_lock lock(mutex_);
        if (!came_.wait(lock, stop, [this] { return !waiting_.empty(); })) return;
        work = std::move(waiting_.front());
        waiting_.pop_front();
      }
      work();
    }
  }

  std::mutex mutex_;
  std::condition_variable_any came_;
  std::deque<std::packaged_task<OpenStream()>> waiting_;
  std::jthread thread_;  // Last: it ends before what it uses.
};

std::string unitWord(const std::optional<LengthUnit>& unit) {
  return unit ? std::string(name(*unit)) : "no unit";
}

/// @throw FileError  they cannot be one source
void requireAlike(const ScanInfo& one, const ScanInfo& other) {
  if (one.unit != other.unit) {
    throw failure<MessageId::inputs_differ_in_unit>(one.file, other.file, unitWord(one.unit),
                                                    unitWord(other.unit));
  }
  if (one.reference_system != other.reference_system) {
    throw failure<MessageId::inputs_differ_in_system>(one.file, other.file);
  }
}

}  // namespace

struct PointFiles::Impl {
  std::vector<fs::path> files;
  ImportOptions options;
  Task task;
  StreamedParts parts = StreamedParts::places;
  ScanInfo info;
  std::vector<std::uint64_t> starts;  ///< Of each file, and the end.
  std::size_t kept_bytes = 0;         ///< Of the file that keeps the most.
  std::optional<ScalarType> colour_type, intensity_type;
  bool word_intensities = false;
  std::string colour_source;

  mutable std::mutex mutex;
  /// Newest first; a reader keeps what it reads from. Of a single file this is its stream.
  mutable std::list<std::pair<std::size_t, OpenStream>> open;
  mutable std::map<std::size_t, std::shared_future<OpenStream>> being_opened;
  std::unique_ptr<Opener> opener;  ///< Of several files.

  static int mostOpen() { return std::min(usableCores() + 1, kMostOpen); }

  OpenStream make(std::size_t file) const {
    return std::make_shared<PointStream>(files[file], options, task, parts);
  }

  OpenStream stream(std::size_t file) const {
    std::promise<OpenStream> promise;
    std::shared_future<OpenStream> other;
    {
      const std::scoped_lock lock(mutex);
      const auto found = std::find_if(open.begin(), open.end(),
                                      [file](const auto& one) { return one.first == file; });
      if (found != open.end()) {
        open.splice(open.begin(), open, found);
        return open.front().second;
      }
      if (const auto now = being_opened.find(file); now != being_opened.end()) {
        other = now->second;
      } else {
        being_opened.emplace(file, promise.get_future().share());
      }
    }
    if (other.valid()) return other.get();
    try {
      OpenStream made = opener->open([this, file] { return make(file); });
      keep(file, made);
      promise.set_value(made);
      return made;
    } catch (...) {
      promise.set_exception(std::current_exception());
      const std::scoped_lock lock(mutex);
      being_opened.erase(file);
      throw;
    }
  }

  void keep(std::size_t file, const OpenStream& made) const {
    std::list<std::pair<std::size_t, OpenStream>> gone;  // Ends without the lock.
    const std::scoped_lock lock(mutex);
    being_opened.erase(file);
    open.emplace_front(file, made);
    while (open.size() > static_cast<std::size_t>(mostOpen())) {
      gone.splice(gone.begin(), open, std::prev(open.end()));
    }
  }

  std::size_t fileOf(std::uint64_t point) const {
    const auto after = std::upper_bound(starts.begin(), starts.end(), point);
    return static_cast<std::size_t>(after - starts.begin()) - 1;
  }

  void add(std::size_t file, const PointStream& stream);
  void join(const Task& work);
};

/// What one file says, beside what is known of those before.
void PointFiles::Impl::add(std::size_t file, const PointStream& stream) {
  const ScanInfo& said = stream.info();
  starts.push_back(starts.back() + said.points);
  kept_bytes = std::max(kept_bytes, stream.keptBytes());
  if (file == 0) {
    info = said;
    colour_type = stream.colourType();
    intensity_type = stream.intensityType();
    word_intensities = stream.hasWordIntensities();
    colour_source = stream.colourSource();
    return;
  }
  requireAlike(info, said);
  info.points += said.points;
  info.withheld += said.withheld;
  info.faces += said.faces;
  if (info.format != said.format) info.format = "several formats";
  const bool same_colours = colour_type == stream.colourType();
  const bool same_intensities =
      intensity_type == stream.intensityType() && word_intensities == stream.hasWordIntensities();
  if (!same_colours && (colour_type || stream.colourType())) {
    info.warnings.push_back(
        relievo::said<MessageId::colours_of_another_form>(shownName(files[file])));
  }
  if (!same_colours) colour_type.reset();
  if (!same_intensities) intensity_type.reset();
}

void PointFiles::Impl::join(const Task& work) {
  std::vector<Message> warnings;
  for (std::size_t file = 0; file < files.size(); ++file) {
    work.check();
    work.report("Opening the files", static_cast<double>(file) / static_cast<double>(files.size()));
    const PointStream stream(files[file], options, work, parts);
    info.warnings.clear();
    add(file, stream);
    const std::string name = shownName(files[file]);
    warnings.insert(warnings.end(), info.warnings.begin(), info.warnings.end());
    if (file > 0) {
      for (const Message& warning : stream.info().warnings) {
        const bool names_it = englishText(warning).find(name) != std::string::npos;
        warnings.push_back(names_it ? warning : said<MessageId::remark_on_file>(name, warning));
      }
    }
    info.parts.push_back({.name = name, .points = stream.info().points, .viewpoint = {}});
  }
  if (warnings.size() > kMostWarningsOfAll) {
    const std::size_t more = warnings.size() - kMostWarningsOfAll;
    warnings.resize(kMostWarningsOfAll);
    warnings.push_back(said<MessageId::more_remarks_on_files>(more));
  }
  info.warnings = std::move(warnings);
  opener = std::make_unique<Opener>();
}

PointFiles::PointFiles(std::vector<fs::path> files, const ImportOptions& options, const Task& task,
                       StreamedParts parts)
    : impl_(std::make_unique<Impl>()) {
  impl_->files = std::move(files);
  impl_->options = options;
  impl_->task = {.stop = task.stop, .progress = {}};
  impl_->parts = parts;
  impl_->starts.push_back(0);
  if (impl_->files.size() > 1) {
    impl_->join(task);
    return;
  }
  auto stream = std::make_shared<PointStream>(impl_->files.front(), options, task, parts);
  impl_->add(0, *stream);
  impl_->open.emplace_front(0, std::move(stream));
}

PointFiles::~PointFiles() = default;

const std::vector<fs::path>& PointFiles::files() const noexcept {
  return impl_->files;
}
const ScanInfo& PointFiles::info() const noexcept {
  return impl_->info;
}
std::optional<ScalarType> PointFiles::colourType() const noexcept {
  return impl_->colour_type;
}
std::optional<ScalarType> PointFiles::intensityType() const noexcept {
  return impl_->intensity_type;
}
bool PointFiles::hasWordIntensities() const noexcept {
  return impl_->word_intensities;
}
const std::string& PointFiles::colourSource() const noexcept {
  return impl_->colour_source;
}

std::size_t PointFiles::keptBytes(int threads) const noexcept {
  const bool several = impl_->files.size() > 1;
  return impl_->kept_bytes * static_cast<std::size_t>(threads + (several ? Impl::mostOpen() : 0));
}

std::size_t PointFiles::read(std::uint64_t first, std::span<FilePoint> block) const {
  return read(first, block, {});
}

std::size_t PointFiles::read(std::uint64_t first, std::span<FilePoint> block,
                             std::span<StoredValues> values) const {
  std::size_t done = 0;
  while (done < block.size() && first + done < impl_->starts.back()) {
    const std::size_t file = impl_->fileOf(first + done);
    const std::uint64_t start = first + done - impl_->starts[file];
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(
        block.size() - done, impl_->starts[file + 1] - impl_->starts[file] - start));
    const OpenStream stream = impl_->stream(file);
    const std::span<FilePoint> part = block.subspan(done, count);
    const std::size_t got = values.empty() ? stream->read(start, part)
                                           : stream->read(start, part, values.subspan(done, count));
    if (got == 0) break;
    done += got;
  }
  return done;
}

void PointFiles::read(std::span<const PointRange> ranges, std::span<FilePoint> block) const {
  std::vector<PointRange> together;  // Of one file.
  std::size_t file = 0, points = 0;
  const auto take = [&] {
    if (together.empty()) return;
    impl_->stream(file)->read(together, block.first(points));
    block = block.subspan(points);
    together.clear();
    points = 0;
  };
  for (PointRange range : ranges) {
    while (range.count > 0) {
      const std::size_t of = impl_->fileOf(range.first);
      if (of != file) take();
      file = of;
      const std::uint64_t count = std::min(range.count, impl_->starts[of + 1] - range.first);
      together.push_back({.first = range.first - impl_->starts[of], .count = count});
      points += static_cast<std::size_t>(count);
      range.first += count;
      range.count -= count;
    }
  }
  take();
}

std::vector<PointRange> PointFiles::cheapSample(std::uint64_t points) const {
  std::vector<PointRange> all;
  const auto sum = static_cast<double>(std::max<std::uint64_t>(impl_->starts.back(), 1));
  for (std::size_t file = 0; file < impl_->files.size(); ++file) {
    const std::uint64_t start = impl_->starts[file], count = impl_->starts[file + 1] - start;
    const double share = static_cast<double>(count) / sum;
    const auto wanted = impl_->files.size() == 1
                            ? points
                            : static_cast<std::uint64_t>(share * static_cast<double>(points)) + 1;
    const std::vector<PointRange> ranges = impl_->stream(file)->cheapSample(wanted);
    if (ranges.empty() && count > 0) return {};  // All points of this one cost the same.
    for (const PointRange& range : ranges) {
      all.push_back({.first = start + range.first, .count = range.count});
    }
  }
  return all;
}

}  // namespace relievo
