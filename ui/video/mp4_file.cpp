// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <span>
#include <vector>

#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "core/io/worker/spawn.h"
#include "ui/video/mp4_boxes.h"
#include "ui/video/video_file.h"
#include "ui/video/video_formats.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

constexpr int kPollMs = 50;
constexpr std::size_t kWordsKept = 4096;

std::string numberText(double value) {
  std::array<char, 40> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() ? std::string(text.data(), end) : std::string("0");
}

/// Never a program of the folder one happens to be in.
fs::path findFfmpeg() {
  const char* const path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
    if (!folder.starts_with('/')) continue;
    fs::path program = fs::path(folder) / "ffmpeg";
    std::error_code missing;
    if (fs::is_regular_file(program, missing) && ::access(program.c_str(), X_OK) == 0) {
      return program;
    }
  }
  return {};
}

std::vector<std::string> packing(VideoProfile profile) {
  // The pictures' own RGB is that of screens; what is turned into luma and chroma must say so.
  const std::vector<std::string> colours{"-vf",
                                         "scale=out_color_matrix=bt709:out_range=tv",
                                         "-colorspace",
                                         "bt709",
                                         "-color_trc",
                                         "bt709",
                                         "-color_primaries",
                                         "bt709",
                                         "-color_range",
                                         "tv"};
  std::vector<std::string> words;
  switch (profile) {
    case VideoProfile::archive:
      return {"-c:v", "libx264rgb", "-qp", "0", "-preset", "medium"};
    case VideoProfile::anaglyph:
      words = {"-c:v", "libx264", "-pix_fmt", "yuv444p", "-crf", "14", "-preset", "medium"};
      break;
    case VideoProfile::talk:
    case VideoProfile::images:
      words = {"-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18", "-preset", "medium"};
      break;
  }
  words.insert(words.end(), colours.begin(), colours.end());
  return words;
}

constexpr int kFromInChild = 3, kToInChild = 4;
constexpr int kSoundInChild = kFromInChild;  // Of another child.

/// Where the samples come from, and what becomes of them.
std::vector<std::string> soundInput(const VideoFormat& f) {
  if (f.sound.empty()) return {"-an"};
  const std::string pipe = "pipe:" + std::to_string(kSoundInChild);
  const std::string rate = std::to_string(f.sound_rate_hz);
  return {"-f", "s16le", "-ar", rate, "-ac", "2", "-i", pipe};
}
std::vector<std::string> soundPacking(const VideoFormat& f) {
  if (f.sound.empty()) return {};
  std::vector<std::string> words{"-c:a", std::string(soundCodec(f.profile)), "-flags:a",
                                 "+bitexact"};
  if (soundCodec(f.profile) == "aac") words.insert(words.end(), {"-b:a", "192k"});
  return words;
}

/// From raw pictures to fragments of a second each, which can be cut off at any time.
std::vector<std::string> encoding(const VideoFormat& f) {
  std::vector<std::string> words{"ffmpeg",
                                 "-hide_banner",
                                 "-nostdin",
                                 "-loglevel",
                                 "error",
                                 "-f",
                                 "rawvideo",
                                 "-pixel_format",
                                 "rgb24",
                                 "-video_size",
                                 std::to_string(f.width_px) + "x" + std::to_string(f.height_px),
                                 "-framerate",
                                 numberText(f.fps),
                                 "-i",
                                 "pipe:0"};
  for (const auto& more : {soundInput(f), packing(f.profile), soundPacking(f)}) {
    words.insert(words.end(), more.begin(), more.end());
  }
  // A coder of sound begins before the first sample. How much, only a head says that waits for it.
  const std::string head = f.sound.empty() ? "empty_moov" : "delay_moov";
  const std::string frames_a_second = std::to_string(std::max(1L, std::lround(f.fps)));
  for (const std::string& word :
       {std::string("-g"), frames_a_second, std::string("-fflags"), std::string("+bitexact"),
        std::string("-flags:v"), std::string("+bitexact"), std::string("-metadata"),
        "title=" + f.title, std::string("-metadata"), "comment=" + f.state,
        std::string("-movflags"), "+frag_keyframe+" + head + "+default_base_moof",
        std::string("-f"), std::string("mp4"), std::string("pipe:1")}) {
    words.push_back(word);
  }
  return words;
}

/// What a child opens: of a file without a name its own copy of the descriptor.
fs::path inChild(const fs::path& file, int descriptor) {
  const std::string_view proc = "/proc/self/fd/";
  return file.native().starts_with(proc) ? fs::path(proc) += std::to_string(descriptor) : file;
}

/// How the sound of so many samples is copied.
std::vector<std::string> soundCopying(VideoProfile profile, std::int64_t samples) {
  const int in_packet = soundCodec(profile) == "aac" ? 1024 : 4096;
  // Fragments do not say how long the last packet is.
  return {"-bsf:a", "setts=duration=min(" + std::to_string(in_packet) + "\\," +
                        std::to_string(samples) + "-PTS)"};
}

/// The same pictures as an ordinary MP4, whose head stands in front: every player takes it.
/// @param sound_samples  nothing: it is silent
std::vector<std::string> repacking(const fs::path& from, const fs::path& to, VideoProfile profile,
                                   std::optional<std::int64_t> sound_samples) {
  std::vector<std::string> words{"ffmpeg", "-hide_banner", "-nostdin", "-loglevel",
                                 "error",  "-xerror",      "-y"};
  // Else what a coder of sound begins with would put the pictures off.
  if (sound_samples) words.emplace_back("-copyts");
  words.insert(words.end(), {"-i", from.string(), "-map", "0", "-c", "copy"});
  if (sound_samples) {
    for (const std::string& word : soundCopying(profile, *sound_samples)) words.push_back(word);
  }
  words.insert(words.end(),
               {"-fflags", "+bitexact", "-movflags", "+faststart", "-f", "mp4", to.string()});
  return words;
}

/// Pictures go to ffmpeg, what it makes comes back and is written here: so a full disk is met by
/// somebody who knows where the file can be cut.
class Mp4File : public VideoFile {
 public:
  Mp4File(const OutputFile& place, const VideoFormat& format)
      : program_(findFfmpeg()), place_(place), file_(place.path), part_(place), format_(format) {
    if (program_.empty()) {
      throw failure<MessageId::ffmpeg_missing>();
    }
    out_.reset(::open(part_.path().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (out_.get() < 0) {
      throw failure<MessageId::video_not_written>(file_, std::strerror(errno));
    }
    start();
  }

  void add(const RgbaImage& frame, const Task& task) override {
    raw_.clear();
    for (std::size_t i = 0; i + 3 < frame.rgba.size(); i += 4) {
      raw_.insert(raw_.end(), {frame.rgba[i], frame.rgba[i + 1], frame.rgba[i + 2]});
    }
    std::span<const std::uint8_t> left = raw_;
    while (!left.empty()) {
      task.check();
      exchange(POLLOUT);
      const ssize_t sent = ::send(in_.get(), left.data(), left.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (sent > 0) left = left.subspan(static_cast<std::size_t>(sent));
      if (sent < 0 && errno != EAGAIN && errno != EINTR) encoderFailed(task);
    }
    ++frames_;
  }

  void finish(const Task& task) override {
    in_.reset();
    while (exchange(0)) task.check();
    while (!child_.reap(false)) {
      task.check();
      ::usleep(1000);
    }
    if (!child_.exited() || child_.number() != 0 || boxes_.wholeFrames() != frames_) {
      encoderFailed(task);
    }
    if (::close(::dup(out_.get())) != 0) diskFull(errno);  // Some file systems tell only now.
    out_.reset();
    repack(task);
  }

  std::uint64_t frames() const noexcept override { return frames_; }
  bool isPartKept() const noexcept override { return is_part_kept_; }

 private:
  void start() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      throw failure<MessageId::encoder_unreachable>(std::strerror(errno));
    }
    in_.reset(ends[0]);
    const OwnedFd child_in(raised(ends[1]));
    OwnedFd child_out, child_words;
    makePipe(encoded_, child_out);
    makePipe(words_, child_words);
    ProgramStart words{.program = program_,
                       .arguments = encoding(format_),
                       .more_environment = {},
                       .fds = {{child_in.get(), 0}, {child_out.get(), 1}, {child_words.get(), 2}}};
    OwnedFd sound;
    if (!format_.sound.empty()) {
      sound.reset(raised(::open(format_.sound.c_str(), O_RDONLY | O_CLOEXEC)));
      if (sound.get() < 0) throw failure<MessageId::video_not_written>(file_, std::strerror(errno));
      words.fds.push_back({sound.get(), kSoundInChild});
    }
    child_.start(words);
  }

  double secondsAdded() const { return static_cast<double>(frames_) / format_.fps; }
  std::optional<std::int64_t> soundSamples() const {
    if (format_.sound.empty()) return std::nullopt;
    return std::llround(secondsAdded() * format_.sound_rate_hz);
  }

  /// Waits for room for pictures or for something to write. @return false: nothing more will come
  bool exchange(short wanted) {
    std::array<pollfd, 3> sources{{{encoded_.get(), POLLIN, 0},
                                   {words_open_ ? words_.get() : -1, POLLIN, 0},
                                   {in_.get(), wanted, 0}}};
    ::poll(sources.data(), sources.size(), kPollMs);
    if (words_open_ && sources[1].revents != 0) {
      words_open_ = readAvailable(words_.get(), said_);
      if (said_.size() > kWordsKept) said_.erase(0, said_.size() - kWordsKept);
    }
    if (sources[0].revents == 0) return true;
    std::array<std::uint8_t, 1U << 16U> bytes{};
    for (;;) {
      const ssize_t got = ::read(encoded_.get(), bytes.data(), bytes.size());
      if (got < 0) return errno == EAGAIN || errno == EINTR;
      if (got == 0) return false;
      keep(std::span(bytes).first(static_cast<std::size_t>(got)));
    }
  }

  void keep(std::span<const std::uint8_t> bytes) {
    std::span<const std::uint8_t> left = bytes;
    while (!left.empty()) {
      const ssize_t written = ::write(out_.get(), left.data(), left.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) diskFull(errno);
      boxes_.add(left.first(static_cast<std::size_t>(written)));
      left = left.subspan(static_cast<std::size_t>(written));
    }
  }

  [[noreturn]] void diskFull(int error_number) {
    child_.kill();
    frames_ = boxes_.wholeFrames();
    const Message why = error_number == ENOSPC
                            ? said<MessageId::disk_full>()
                            : said<MessageId::quoted>(std::strerror(error_number));
    const auto whole = static_cast<off_t>(boxes_.wholeBytes());
    if (frames_ > 0 && ::ftruncate(out_.get(), whole) == 0) {
      out_.reset();
      part_.commit();
      is_part_kept_ = true;
      const NumberArgument length_s{
          .value = secondsAdded(), .digits = 1, .form = NumberArgument::Form::trimmed};
      if (error_number == ENOSPC) {
        throw failure<MessageId::video_stopped_disk_full>(length_s, frames_, file_);
      }
      throw failure<MessageId::video_stopped_kept>(why, length_s, frames_, file_);
    }
    throw failure<MessageId::video_stopped_lost>(why);
  }

  [[noreturn]] void encoderFailed(const Task& task) {
    in_.reset();
    for (int i = 0; i < 20 && exchange(0); ++i) task.check();
    child_.kill();
    const std::string words = lastPrintableLine(said_);
    if (words.empty()) throw failure<MessageId::ffmpeg_failed>();
    throw failure<MessageId::ffmpeg_failed_saying>(words);
  }

  /// Takes as much room again for a moment; where there is none, the fragments are kept as they
  /// are: most players take them, too.
  void repack(const Task& task) {
    AtomicFile ordinary(place_);
    const OwnedFd from(raised(::open(part_.path().c_str(), O_RDONLY | O_CLOEXEC)));
    const OwnedFd to(raised(::open(ordinary.path().c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)));
    // Where it finds no room, the fragments are kept: nothing that anybody has to read.
    const OwnedFd words(raised(::open("/dev/null", O_WRONLY | O_CLOEXEC)));
    ChildProcess packer;
    packer.start({.program = program_,
                  .arguments = repacking(inChild(part_.path(), kFromInChild),
                                         inChild(ordinary.path(), kToInChild), format_.profile,
                                         soundSamples()),
                  .more_environment = {},
                  .fds = {{from.get(), kFromInChild}, {to.get(), kToInChild}, {words.get(), 2}}});
    while (!packer.reap(false)) {
      task.check();
      ::usleep(5000);
    }
    const bool done = packer.exited() && packer.number() == 0;
    (done ? ordinary : part_).commit();
  }

  fs::path program_;
  OutputFile place_;
  fs::path file_;
  AtomicFile part_;
  VideoFormat format_;
  OwnedFd out_, in_, encoded_, words_;  // Ours.
  bool words_open_ = true, is_part_kept_ = false;
  std::string said_;
  Mp4Boxes boxes_;
  std::vector<std::uint8_t> raw_;
  std::uint64_t frames_ = 0;
  ChildProcess child_;
};

}  // namespace

std::string_view soundCodec(VideoProfile profile) noexcept {
  return profile == VideoProfile::archive ? "alac" : "aac";
}

bool haveFfmpeg() {
  return !findFfmpeg().empty();
}

std::unique_ptr<VideoFile> openMp4(const OutputFile& file, const VideoFormat& format) {
  if (file.path.extension() != ".mp4") {
    throw failure<MessageId::video_name>();
  }
  return std::make_unique<Mp4File>(file, format);
}

std::unique_ptr<VideoFile> openVideo(const OutputFile& file, const VideoFormat& format) {
  return format.profile == VideoProfile::images ? openImageSequence(file.path, format)
                                                : openMp4(file, format);
}

}  // namespace relievo
