// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/transport.h"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <new>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <utility>

#include "core/base/failure.h"
#include "core/base/json_nesting.h"

namespace relievo {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMagic = 0x31'70'65'72'70'6C'65'72;  // "relprep1"
constexpr std::size_t kChunk = 16U << 20U;  ///< Between two looks at the stop token.
constexpr std::uint64_t kMostHeadBytes = 16U << 20U;
constexpr std::size_t kCheckEvery = 1U << 20U;

enum class Kind : std::uint64_t { refusal, job, answer };

/// Then the head as JSON, then lists of numbers, each from a multiple of 8.
struct FileStart {
  std::uint64_t magic = kMagic;
  Kind kind = Kind::refusal;
  std::uint64_t head_bytes = 0;
};

/// What is wrong with what came; nobody is told more than that it cannot be used.
struct Inconsistent : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr std::uint64_t aligned(std::uint64_t at) {
  return (at + 7) / 8 * 8;
}

class FileWriter {
 public:
  FileWriter(int fd, const Task& task) : fd_(fd), task_(task) {}

  void start(Kind kind, const Json& head) {
    const std::string text = head.dump(-1, ' ', true, Json::error_handler_t::replace);
    const FileStart first{kMagic, kind, text.size()};
    bytes({reinterpret_cast<const char*>(&first), sizeof(first)});
    bytes(text);
  }
  template <class T>
  void list(std::span<const T> items) {
    at_ = aligned(at_);
    bytes({reinterpret_cast<const char*>(items.data()), items.size_bytes()});
  }
  void finish() {
    if (::ftruncate(fd_, static_cast<off_t>(at_)) != 0) refuse();
  }

 private:
  [[noreturn]] static void refuse() {
    if (errno == EFBIG || errno == ENOMEM) throw std::bad_alloc();
    throw Error(said<MessageId::scan_not_passed_on>(std::strerror(errno)));
  }
  void bytes(std::string_view from) {
    while (!from.empty()) {
      task_.check();
      const ssize_t written =
          ::pwrite(fd_, from.data(), std::min(from.size(), kChunk), static_cast<off_t>(at_));
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) refuse();
      from.remove_prefix(static_cast<std::size_t>(written));
      at_ += static_cast<std::uint64_t>(written);
    }
  }

  int fd_;
  const Task& task_;
  std::uint64_t at_ = 0;
};

/// A file in memory. A job is looked at where it lies, for its parent waits for the child; an
/// answer is copied first, so that whoever still holds the file changes nothing under our eyes.
class FileView {
 public:
  static FileView ofJob(int fd) {
    FileView view;
    view.size_ = static_cast<std::size_t>(jobBytes(fd));
    if (view.size_ < sizeof(FileStart)) return view;
    void* const place = ::mmap(nullptr, view.size_, PROT_READ, MAP_SHARED, fd, 0);
    if (place == MAP_FAILED) return view;
    view.take(
        {place, [size = view.size_](const void* at) { ::munmap(const_cast<void*>(at), size); }});
    return view;
  }
  /// @throw Cancelled
  static FileView ofAnswer(int fd, std::uint64_t most_bytes, const Task& task) {
    FileView view;
    const std::uint64_t size = jobBytes(fd);
    if (size < sizeof(FileStart) || size > most_bytes) return view;
    view.size_ = static_cast<std::size_t>(size);
    const auto copy = std::make_shared<std::vector<std::uint64_t>>((view.size_ + 7) / 8);
    auto* const bytes = reinterpret_cast<char*>(copy->data());
    for (std::size_t at = 0; at < view.size_;) {
      task.check();
      const ssize_t got =
          ::pread(fd, bytes + at, std::min(view.size_ - at, kChunk), static_cast<off_t>(at));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return view;
      at += static_cast<std::size_t>(got);
    }
    view.take({copy, copy->data()});
    return view;
  }

  bool good() const noexcept { return memory_ != nullptr; }
  Kind kind() const noexcept { return start_.kind; }
  std::string_view head() const { return {bytes() + sizeof(start_), start_.head_bytes}; }
  std::shared_ptr<const void> memory() const { return memory_; }

  /// The next list. @throw Inconsistent  the file is too short
  template <class T>
  std::span<const T> list(std::uint64_t items) {
    at_ = aligned(at_);
    if (at_ > size_ || items > (size_ - at_) / sizeof(T)) throw Inconsistent("it is too short");
    const auto* const first = reinterpret_cast<const T*>(bytes() + at_);
    at_ += items * sizeof(T);
    return {first, static_cast<std::size_t>(items)};
  }
  bool ended() const noexcept { return at_ == size_; }

 private:
  FileView() = default;
  void take(std::shared_ptr<const void> memory) {
    std::memcpy(&start_, memory.get(), sizeof(start_));
    if (start_.magic != kMagic || start_.head_bytes > kMostHeadBytes ||
        start_.head_bytes > size_ - sizeof(start_)) {
      return;
    }
    at_ = sizeof(start_) + start_.head_bytes;
    memory_ = std::move(memory);
  }
  const char* bytes() const { return static_cast<const char*>(memory_.get()); }

  std::shared_ptr<const void> memory_;
  std::size_t size_ = 0;
  FileStart start_;
  std::uint64_t at_ = 0;
};

Json parsed(std::string_view text) {
  constexpr int kDeepest = 16;
  if (isNestedDeeper(text, kDeepest)) throw Inconsistent("it is nested too deep");
  return Json::parse(text);
}

double finite(const Json& json) {
  if (!json.is_number()) throw Inconsistent("a number is none");
  const auto value = json.get<double>();
  if (!std::isfinite(value)) throw Inconsistent("a number is not finite");
  return value;
}

/// JSON has text alone: the bytes of messages go as numbers.
Json jsonOf(const std::vector<Message>& messages) {
  Json json = Json::array();
  for (const Message& message : messages) {
    const std::string bytes = messageBytes(message);
    json.push_back(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
  }
  return json;
}

Message messageFrom(const Json& json) {
  const auto bytes = json.get<std::vector<std::uint8_t>>();
  auto message = messageFromBytes({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!message) throw Inconsistent("a message is none");
  return *std::move(message);
}

std::vector<Message> messagesFrom(const Json& json) {
  std::vector<Message> messages;
  for (const Json& message : json) messages.push_back(messageFrom(message));
  return messages;
}

Json jsonOf(const FilePoint& p) {
  return {p.x, p.y, p.z};
}

template <std::size_t N>
std::array<double, N> numbers(const Json& json) {
  if (!json.is_array() || json.size() != N) throw Inconsistent("a list has another length");
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i) values[i] = finite(json.at(i));
  return values;
}

FilePoint pointFrom(const Json& json) {
  const auto v = numbers<3>(json);
  return {v[0], v[1], v[2]};
}

Pose poseFrom(const Json& json) {
  const Pose pose{numbers<16>(json)};
  if (!isRigid(pose)) throw Inconsistent("a pose is no rotation and translation");
  return pose;
}

Json jsonOf(const PrepareScan& scan) {
  Json json{{"name", scan.name},
            {"origin", jsonOf(scan.origin)},
            {"mm_per_unit", scan.mm_per_unit},
            {"points", scan.points.size()},
            {"classes", scan.classes.size()},
            {"returns", scan.returns.size()},
            {"intensities", scan.intensities.size()}};
  if (scan.viewpoint) json["viewpoint"] = jsonOf(*scan.viewpoint);
  if (scan.intensity) json["intensity"] = {scan.intensity->low, scan.intensity->high};
  return json;
}

/// All but the points.
PrepareScan scanFrom(const Json& json) {
  PrepareScan scan;
  scan.name = json.at("name").get<std::string>();
  scan.origin = pointFrom(json.at("origin"));
  scan.mm_per_unit = finite(json.at("mm_per_unit"));
  if (!(scan.mm_per_unit > 0)) throw Inconsistent("a unit has no length");
  if (json.contains("viewpoint")) scan.viewpoint = pointFrom(json.at("viewpoint"));
  if (json.contains("intensity")) {
    const auto range = numbers<2>(json.at("intensity"));
    scan.intensity = IntensityRange{range[0], range[1]};
  }
  return scan;
}

void requireAsMany(std::size_t items, std::size_t points) {
  if (items != 0 && items != points) throw Inconsistent("a list is not as long as the points");
}

Json jsonOf(const AlignAnswer& align) {
  Json json{{"scans", Json::array()}, {"loops", Json::array()}};
  for (const AlignVerdict& v : align.scans) {
    json["scans"].push_back({{"pose", v.pose.m},
                             {"start", v.start.m},
                             {"holds", v.holds},
                             {"rms_mm", v.rms_mm},
                             {"share", v.share},
                             {"tight_share", v.tight_share},
                             {"stability", v.stability},
                             {"weak_direction", v.weak_direction},
                             {"uncertainty_mm", v.uncertainty_mm},
                             {"words", jsonOf(v.words)}});
  }
  for (const AlignLoop& loop : align.loops) {
    json["loops"].push_back({{"scans", loop.scans}, {"deg", loop.deg}, {"mm", loop.mm}});
  }
  return json;
}

AlignAnswer alignFrom(const Json& json, std::size_t scans) {
  AlignAnswer align;
  for (const Json& v : json.at("scans")) {
    align.scans.push_back({.pose = poseFrom(v.at("pose")),
                           .start = poseFrom(v.at("start")),
                           .holds = v.at("holds").get<bool>(),
                           .rms_mm = finite(v.at("rms_mm")),
                           .share = finite(v.at("share")),
                           .tight_share = finite(v.at("tight_share")),
                           .stability = finite(v.at("stability")),
                           .weak_direction = numbers<3>(v.at("weak_direction")),
                           .uncertainty_mm = finite(v.at("uncertainty_mm")),
                           .words = messagesFrom(v.at("words"))});
  }
  if (align.scans.size() != scans) throw Inconsistent("a scan has no verdict");
  for (const Json& loop : json.at("loops")) {
    align.loops.push_back({.scans = loop.at("scans").get<std::vector<std::uint32_t>>(),
                           .deg = finite(loop.at("deg")),
                           .mm = finite(loop.at("mm"))});
    for (const std::uint32_t scan : align.loops.back().scans) {
      if (scan >= scans) throw Inconsistent("a loop names a scan that is not there");
    }
  }
  return align;
}

Json headOf(const PrepareAnswer& answer) {
  Json head{
      {"steps", Json::array()}, {"poses", Json::array()}, {"warnings", jsonOf(answer.warnings)},
      {"pcl", answer.pcl},      {"flann", answer.flann},  {"normals", answer.normals.size()}};
  for (const StepResult& step : answer.steps) {
    head["steps"].push_back({{"before", step.before},
                             {"after", step.after},
                             {"seconds", step.seconds},
                             {"notes", jsonOf(step.notes)},
                             {"done", step.done}});
  }
  for (const Pose& pose : answer.poses) head["poses"].push_back(pose.m);
  if (answer.align) head["align"] = jsonOf(*answer.align);
  return head;
}

/// The bits of a step, if they are among those before it and as many as it says.
void takeBits(FileView& file, StepResult& step, const PointBits& before) {
  const auto words = file.list<std::uint64_t>(before.words().size());
  step.kept = before;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if ((words[i] & ~before.words()[i]) != 0) throw Inconsistent("a point came back");
    step.kept.words()[i] = words[i];
  }
  if (step.before != before.count() || step.after != step.kept.count()) {
    throw Inconsistent("a step left another number of points than it says");
  }
}

void takeNormals(FileView& file, std::uint64_t count, PrepareAnswer& answer, const Task& task) {
  const std::uint64_t left = answer.steps.empty() ? 0 : answer.steps.back().after;
  if (count == 0) return;
  if (count != left) throw Inconsistent("there is not one normal for each point");
  const auto normals = file.list<Point3f>(count);
  answer.normals.assign(normals.begin(), normals.end());
  for (std::size_t i = 0; i < answer.normals.size(); ++i) {
    if (i % kCheckEvery == 0) task.check();
    const Point3f& n = answer.normals[i];
    const float squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    if (!(squared == 0 || std::abs(squared - 1) < 1e-4F))
      throw Inconsistent("a normal has no length");
  }
}

PrepareAnswer answerFrom(FileView& file, const PrepareJob& job, const Task& task) {
  const Json head = parsed(file.head());
  PrepareAnswer answer;
  PointBits before(job.points());
  for (const Json& json : head.at("steps")) {
    task.check();
    StepResult& step = answer.steps.emplace_back();
    step.before = json.at("before").get<std::uint64_t>();
    step.after = json.at("after").get<std::uint64_t>();
    step.seconds = finite(json.at("seconds"));
    step.notes = messagesFrom(json.at("notes"));
    step.done = json.at("done").get<bool>();
    takeBits(file, step, before);
    before = step.kept;
  }
  if (answer.steps.size() != job.steps.size()) throw Inconsistent("a step is missing");
  for (const Json& pose : head.at("poses")) answer.poses.push_back(poseFrom(pose));
  if (answer.poses.size() != job.scans.size()) throw Inconsistent("a pose is missing");
  if (head.contains("align")) answer.align = alignFrom(head.at("align"), job.scans.size());
  answer.warnings = messagesFrom(head.at("warnings"));
  answer.pcl = head.at("pcl").get<std::string>();
  answer.flann = head.at("flann").get<std::string>();
  takeNormals(file, head.at("normals").get<std::uint64_t>(), answer, task);
  if (!file.ended()) throw Inconsistent("it is too long");
  return answer;
}

}  // namespace

void sendJob(int fd, const PrepareJob& job, const Task& task) {
  Json head{{"recipe", toJson(Recipe{.scans = {}, .steps = job.steps}, -1)},
            {"scans", Json::array()}};
  for (const PrepareScan& scan : job.scans) head["scans"].push_back(jsonOf(scan));
  FileWriter file(fd, task);
  file.start(Kind::job, head);
  for (const PrepareScan& scan : job.scans) {
    file.list(scan.points);
    file.list(scan.classes);
    file.list(scan.intensities);
    file.list(scan.returns);
  }
  file.finish();
}

std::optional<ReceivedJob> receiveJob(int fd) {
  FileView file = FileView::ofJob(fd);
  if (!file.good() || file.kind() != Kind::job) return std::nullopt;
  try {
    const Json head = parsed(file.head());
    ReceivedJob received{.job = {}, .memory = file.memory()};
    received.job.steps = recipeFromJson(head.at("recipe").get<std::string>(), "The job").steps;
    for (const Json& json : head.at("scans")) {
      PrepareScan& scan = received.job.scans.emplace_back(scanFrom(json));
      scan.points = file.list<Point3f>(json.at("points").get<std::uint64_t>());
      scan.classes = file.list<std::uint8_t>(json.at("classes").get<std::uint64_t>());
      scan.intensities = file.list<std::uint16_t>(json.at("intensities").get<std::uint64_t>());
      scan.returns = file.list<std::uint8_t>(json.at("returns").get<std::uint64_t>());
      requireAsMany(scan.classes.size(), scan.points.size());
      requireAsMany(scan.returns.size(), scan.points.size());
      requireAsMany(scan.intensities.size(), scan.points.size());
    }
    if (received.job.points() > UINT32_MAX - 1 || !file.ended()) return std::nullopt;
    return received;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  } catch (const Inconsistent&) {
    return std::nullopt;
  } catch (const FileError&) {  // Of the recipe.
    return std::nullopt;
  }
}

std::uint64_t jobBytes(int fd) {
  struct stat facts {};
  return ::fstat(fd, &facts) == 0 ? static_cast<std::uint64_t>(facts.st_size) : 0;
}

void sendPrepareAnswer(int fd, const PrepareAnswer& answer) {
  const Task task;
  FileWriter file(fd, task);
  file.start(Kind::answer, headOf(answer));
  for (const StepResult& step : answer.steps) {
    file.list(std::span<const std::uint64_t>(step.kept.words()));
  }
  file.list(std::span<const Point3f>(answer.normals));
  file.finish();
}

void sendPrepareAnswer(int fd, const PrepareRefusal& refusal) {
  const Task task;
  FileWriter file(fd, task);
  file.start(Kind::refusal, Json{{"messages", jsonOf(std::vector{refusal.message})}});
  file.finish();
}

std::variant<std::monostate, PrepareAnswer, PrepareRefusal> receivePrepareAnswer(
    int fd, const PrepareJob& job, const Task& task) {
  const std::uint64_t points = job.points();
  const std::uint64_t most =
      kMostHeadBytes + (job.steps.size() + 1) * (points / 8 + 16) + points * sizeof(Point3f) + 64;
  FileView file = FileView::ofAnswer(fd, most, task);
  if (!file.good()) return {};
  try {
    if (file.kind() == Kind::answer) return answerFrom(file, job, task);
    if (file.kind() != Kind::refusal) return {};
    return PrepareRefusal{messageFrom(parsed(file.head()).at("messages").at(0))};
  } catch (const nlohmann::json::exception&) {
    return {};
  } catch (const Inconsistent&) {
    return {};
  }
}

}  // namespace relievo
