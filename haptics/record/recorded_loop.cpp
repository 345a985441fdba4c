// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/recorded_loop.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <span>
#include <sstream>
#include <vector>

#include "core/base/failure.h"
#include "haptics/record/log/named_json.h"

namespace relievo {

namespace {
constexpr std::string_view kDigits = "0123456789abcdef";
constexpr std::string_view kNone = "-";

/// The bytes of a value as text, and back.
template <class T>
std::string hexOf(const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::array<unsigned char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), &value, sizeof(T));
  std::string text;
  text.reserve(2 * sizeof(T));
  for (const unsigned char byte : bytes) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

template <class T>
bool fromHex(std::string_view text, T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (text.size() != 2 * sizeof(T)) return false;
  std::array<unsigned char, sizeof(T)> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t high = kDigits.find(text[2 * i]), low = kDigits.find(text[2 * i + 1]);
    if (high == std::string_view::npos || low == std::string_view::npos) return false;
    bytes[i] = static_cast<unsigned char>(16 * high + low);
  }
  std::memcpy(static_cast<void*>(&value), bytes.data(), sizeof(T));
  return true;
}

/// Any text as one word of a line: blanks and what is no letter of ASCII as %XX.
std::string oneWord(std::string_view text) {
  std::string word;
  for (const char letter : text) {
    if (letter > ' ' && letter < '\x7f' && letter != '%') {
      word += letter;
    } else {
      word += '%' + hexOf(letter);
    }
  }
  return word;
}

bool fromWord(std::string_view word, std::string& text) {
  for (std::size_t i = 0; i < word.size(); ++i) {
    char letter = word[i];
    if (letter == '%' && !fromHex(word.substr(std::min(i + 1, word.size()), 2), letter))
      return false;
    if (word[i] == '%') i += 2;
    text += letter;
  }
  return true;
}

/// FNV-1a, 64 bits.
class Checksum {
 public:
  void add(const void* data, std::size_t bytes) {
    const std::span<const unsigned char> all(static_cast<const unsigned char*>(data), bytes);
    for (const unsigned char byte : all) sum_ = (sum_ ^ byte) * 1099511628211ULL;
  }
  std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_ = 14695981039346656037ULL;
};

/// A word with its checksum behind it: what was altered since is refused, not run.
std::string sealed(const std::string& word) {
  Checksum sum;
  sum.add(word.data(), word.size());
  return word + " " + hexOf(sum.sum());
}

/// Reads JSON that was sealed, of any build.
template <class T>
bool fromSealed(std::string_view word, std::string_view seal, T& value) {
  std::uint64_t told = 0;
  Checksum sum;
  sum.add(word.data(), word.size());
  return fromHex(seal, told) && sum.sum() == told && fromJson(word, value);
}

std::vector<std::string_view> wordsOf(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    if (end > 0) words.push_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return words;
}

[[noreturn]] void refuse(const std::string& why) {
  throw failure<MessageId::recording_not_replayed>(why);
}

template <class Number>
Number numberOf(std::string_view word) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    refuse("\"" + std::string(word) + "\" stands where a number is expected");
  }
  return value;
}

std::string textOf(double value) {
  std::array<char, 40> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() ? std::string(text.data(), end) : std::string("0");
}

RecordedScene sceneOf(const std::vector<std::string_view>& words) {
  constexpr std::size_t kPlain = 14, kAnchored = kPlain + 6;
  if (words.size() != kPlain && words.size() != kAnchored) refuse("a surface is not told in full");
  const auto real = [&](std::size_t i) { return numberOf<double>(words[i]); };
  RecordedScene scene;
  scene.id = numberOf<std::uint64_t>(words[2]);
  scene.window_id = numberOf<std::uint64_t>(words[3]);
  scene.region = {real(4), real(5), real(6), Level{numberOf<int>(words[7])}};
  scene.gain = real(8);
  const int kind = numberOf<int>(words[9]);
  if (kind < 0 || kind > 2) refuse("a surface is of no known kind");
  scene.kind = static_cast<SurfaceKind>(kind);
  scene.textured = numberOf<int>(words[10]) != 0;
  scene.checksum = numberOf<std::uint64_t>(words[11]);
  if (words[12] != kNone) scene.firmness = words[12];
  scene.map = numberOf<std::uint64_t>(words[13]);
  if (words.size() == kAnchored) {
    scene.anchor = Anchor{{real(14), real(15), real(16)}, {real(17), real(18), real(19)}};
  }
  return scene;
}
}  // namespace

std::uint64_t sceneChecksum(const HapticSpace& space) {
  Checksum sum;
  sum.add(space.samples.data(), sizeof(space.samples));
  sum.add(space.marks.data(), sizeof(space.marks));
  sum.add(space.origins.data(), sizeof(space.origins));
  sum.add(space.firmness.data(), sizeof(space.firmness));
  if (space.texture.present) sum.add(space.texture.rise_um.data(), sizeof(space.texture.rise_um));
  sum.add(&space.device_per_view, sizeof(double));
  sum.add(&space.device_translation, sizeof(DeviceMm));
  return sum.sum();
}

std::string sceneLine(const RecordedScene& s) {
  std::string line = "replay scene " + std::to_string(s.id) + " " + std::to_string(s.window_id);
  for (const double v : {s.region.x_mm, s.region.y_mm, s.region.side_mm}) line += " " + textOf(v);
  line += " " + std::to_string(s.region.level.value) + " " + textOf(s.gain) + " " +
          std::to_string(static_cast<int>(s.kind)) + (s.textured ? " 1 " : " 0 ") +
          std::to_string(s.checksum) + " " +
          (s.firmness.empty() ? std::string(kNone) : s.firmness) + " " + std::to_string(s.map);
  if (s.anchor) {
    const ViewMm& p = s.anchor->point;
    const DeviceMm& at = s.anchor->at;
    for (const double v : {p.x, p.y, p.z, at.x, at.y, at.z}) line += " " + textOf(v);
  }
  return line + "\n";
}

std::string firmnessLine(std::string_view sha256, std::string_view file) {
  return "replay firmness " + std::string(sha256) + " " + oneWord(file) + "\n";
}

std::string mapLine(std::uint64_t map, std::string_view state) {
  return "replay map " + std::to_string(map) + " " + oneWord(state) + "\n";
}

std::string optionsLine(const HapticOptions& options) {
  return "replay options " + std::to_string(options.id) + " " + sealed(toJson(options)) + "\n";
}

std::string guideLine(const GuidePath& path) {
  return "replay guide " + std::to_string(path.id) + " " + sealed(toJson(path)) + "\n";
}

std::string snapshotLine(const CoreSnapshot& snapshot, std::int64_t first_ns,
                         std::string_view build) {
  return "replay core " + std::string(build) + " " + std::to_string(first_ns) + " " +
         sealed(toJson(snapshot)) + "\n";
}

std::string changeLine(const HapticSample* before, const HapticSample& now) {
  const bool same = before != nullptr && before->scene_id == now.scene_id &&
                    before->options_id == now.options_id && before->fault == now.fault &&
                    before->resumed == now.resumed;
  if (same) return {};
  return "replay at " + std::to_string(now.tick) + " " + std::to_string(now.scene_id) + " " +
         std::to_string(now.options_id) + " " + std::to_string(static_cast<int>(now.fault)) +
         (now.resumed ? " 1\n" : " 0\n");
}

namespace {
/// The words of each line "replay ..." with at least four.
template <class Take>
void forEachReplayLine(std::string_view footer, const Take& take) {
  while (!footer.empty()) {
    const std::size_t end = std::min(footer.find('\n'), footer.size());
    const std::vector<std::string_view> words = wordsOf(footer.substr(0, end));
    footer.remove_prefix(std::min(end + 1, footer.size()));
    if (words.size() >= 4 && words[0] == "replay") take(words);
  }
}
}  // namespace

RecordedFiles recordedFiles(std::string_view footer) {
  RecordedFiles files;
  forEachReplayLine(footer, [&files](const std::vector<std::string_view>& words) {
    if (words[1] == "map") {
      if (!fromWord(words[3], files.maps[numberOf<std::uint64_t>(words[2])])) {
        refuse("what it says of a map is damaged");
      }
    } else if (words[1] == "firmness") {
      if (!fromWord(words[3], files.firmness[std::string(words[2])])) {
        refuse("the name of its raster of firmness is damaged");
      }
    }
  });
  return files;
}

std::map<std::uint64_t, GuidePath> recordedGuides(std::string_view footer) {
  std::map<std::uint64_t, GuidePath> guides;
  forEachReplayLine(footer, [&guides](const std::vector<std::string_view>& words) {
    if (words[1] != "guide") return;
    const auto id = numberOf<std::uint64_t>(words[2]);
    GuidePath path;
    const bool fits = words.size() == 5 && fromSealed(words[3], words[4], path) && path.id == id;
    if (!fits) throw failure<MessageId::guide_damaged>();
    guides[id] = path;
  });
  return guides;
}

const GuidePath* guideNamed(const std::map<std::uint64_t, GuidePath>& guides,
                            const HapticOptions& options) {
  if (options.guide.path == 0) return nullptr;
  const auto found = guides.find(options.guide.path);
  if (found == guides.end()) throw failure<MessageId::guide_damaged>();
  return &found->second;
}

std::string recordedBuild(std::string_view footer) {
  std::string build;
  forEachReplayLine(footer, [&build](const std::vector<std::string_view>& words) {
    if (words[1] == "core") build = words[2];
  });
  return build;
}

std::map<std::uint64_t, LoopChange> loopChanges(std::string_view footer) {
  std::map<std::uint64_t, LoopChange> changes;
  forEachReplayLine(footer, [&changes](const std::vector<std::string_view>& words) {
    if (words[1] != "at") return;
    const int fault = words.size() == 7 ? numberOf<int>(words[5]) : -1;
    if (fault < 0 || fault > static_cast<int>(DeviceFault::not_ready)) {
      refuse("what changed at one of its ticks is damaged");
    }
    changes[numberOf<std::uint64_t>(words[2])] = {
        numberOf<std::uint64_t>(words[3]), numberOf<std::uint64_t>(words[4]),
        static_cast<DeviceFault>(fault), numberOf<int>(words[6]) != 0};
  });
  return changes;
}

bool ChangeCursor::at(std::uint64_t tick) {
  new_fault_ = false;
  const auto change = changes_.find(tick);
  if (change == changes_.end()) return false;
  new_fault_ = change->second.fault != now_.fault;
  now_ = change->second;
  return true;
}

void ChangeCursor::tell(HapticCore& core, const HapticOptions& options,
                        DeviceReading& reading) const {
  if (now_.resumed) core.resume();
  if (new_fault_ || !options.force.forces_on) reading.fault = now_.fault;
}

std::optional<RecordedLoop> recordedLoop(std::string_view footer) {
  RecordedLoop loop;
  loop.build = recordedBuild(footer);
  if (loop.build.empty()) return std::nullopt;
  forEachReplayLine(footer, [&](const std::vector<std::string_view>& words) {
    if (words[1] == "core") {
      if (words.size() == 5) {
        refuse("it was made by build " + loop.build +
               ", which kept its state in a form that only that build reads");
      }
      if (words.size() != 6 || !fromSealed(words[4], words[5], loop.start)) {
        refuse("its start is damaged");
      }
      loop.first_ns = numberOf<std::int64_t>(words[3]);
    } else if (words[1] == "options" && words.size() == 5) {
      HapticOptions options;
      if (!fromSealed(words[3], words[4], options)) refuse("its options are damaged");
      loop.options[numberOf<std::uint64_t>(words[2])] = options;
    } else if (words[1] == "scene") {
      const RecordedScene scene = sceneOf(words);
      loop.scenes[scene.id] = scene;
    }
  });
  loop.changes = loopChanges(footer);
  loop.files = recordedFiles(footer);
  loop.guides = recordedGuides(footer);
  return loop;
}

HapticOptions asTheLoopHad(HapticOptions options, std::uint64_t id) {
  options.id = id;
  if ((id & kLeavingBit) != 0) options.force.forces_on = false;
  if ((id & kPathlessBit) != 0) options.guide = {};
  options.stop.window_silent = (id & kSilentBit) != 0;
  return options;
}

namespace {
const RecordedScene& sceneNamed(const RecordedLoop& loop, std::uint64_t id) {
  const auto found = loop.scenes.find(id);
  if (found == loop.scenes.end()) refuse("it does not tell surface " + std::to_string(id));
  return found->second;
}

HapticOptions optionsNamed(const RecordedLoop& loop, std::uint64_t id) {
  const auto found = loop.options.find(id & ~(kLeavingBit | kSilentBit | kPathlessBit));
  if (found == loop.options.end()) refuse("it does not tell options " + std::to_string(id));
  return asTheLoopHad(found->second, id);
}
}  // namespace

ReplayResult replayLoop(const RecordedLoop& loop, const LogTable& log,
                        const std::function<const HapticSpace&(const RecordedScene&)>& space,
                        const std::function<void(const HapticSample&, double t_s)>& each,
                        const Task& task) {
  if (log.rows.empty()) refuse("it has no rows");
  ReplayResult result;
  HapticCore core = loop.start.core;
  std::uint64_t scene = loop.start.scene_id;
  const HapticSpace* now = &space(sceneNamed(loop, scene));
  const HapticSpace* before = now;
  // Made only if it is felt: it may be of a map that the recording's state does not tell of.
  if (core.looksBackFrom(*now) && loop.scenes.contains(loop.start.previous_scene_id)) {
    before = &space(sceneNamed(loop, loop.start.previous_scene_id));
  }
  ChangeCursor changes(loop.changes);
  HapticOptions options;
  std::uint64_t tick = loop.start.tick;
  for (const TouchRow& row : log.rows) {
    constexpr std::uint64_t kTicksPerCheck = 1024;
    if (result.ticks++ % kTicksPerCheck == 0) task.check();
    if (row.tick != tick) refuse("samples were dropped before tick " + std::to_string(tick));
    if (changes.at(tick)) {
      options = optionsNamed(loop, changes.now().options_id);
      if (changes.now().scene_id != scene) {
        scene = changes.now().scene_id;
        before = now;
        now = &space(sceneNamed(loop, scene));
      }
    }
    DeviceReading reading = readingOf(row, loop.first_ns);
    changes.tell(core, options, reading);
    const std::int64_t now_ns = loop.first_ns + nanosecondsOf(row);
    const GuidePath* path = guideNamed(loop.guides, options);
    HapticSample sample = loop.start.gradual
                              ? core.tick(*now, *before, options, reading, now_ns, path)
                              : core.tick(*now, options, reading, now_ns, path);
    compare(sample, row, log, result, each);
    ++tick;
  }
  return result;
}

}  // namespace relievo
