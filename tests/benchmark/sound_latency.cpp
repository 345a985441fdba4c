// SPDX-License-Identifier: BSD-3-Clause
// What somebody who does not look waits for: from a contact to its click, from a sentence to its
// first sound, from a button to silence. Each is taken at the monitor of an output of Debian's
// PulseAudio that nobody hears, with the wait of the recording in it, on a computer that is idle
// and on one whose cores are all busy. No sound card is in it, whose own wait comes on top.
//
// Needs pulseaudio, espeak-ng and, for the rows of Speech Dispatcher, speech-dispatcher with its
// module for espeak-ng. Printed is a table as docs/dev/sound-figures.md has it.
#include <pulse/simple.h>

#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <mutex>
#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <string>
#include <thread>
#include <vector>

#include "haptics/sound/live_sound.h"
#include "haptics/sound/sound_out.h"
#include "plugins/voice/own_voice.h"
#include "tests/plugins/voice/sound_server.h"

namespace relievo {
namespace {

using Clock = std::chrono::steady_clock;
using Waits = std::vector<double>;  // ms

double ms(Clock::duration span) {
  return std::chrono::duration<double, std::milli>(span).count();
}

/// Hears what an output plays, block by block.
class Ear {
 public:
  static constexpr int kBlock = 128;  // Frames: 2.7 ms.
  static constexpr float kLoud = 0.003F;

  explicit Ear(const std::string& server) {
    const pa_sample_spec spec{PA_SAMPLE_FLOAT32NE, 48'000, 2};
    const pa_buffer_attr buffer{.maxlength = static_cast<std::uint32_t>(-1),
                                .tlength = static_cast<std::uint32_t>(-1),
                                .prebuf = static_cast<std::uint32_t>(-1),
                                .minreq = static_cast<std::uint32_t>(-1),
                                .fragsize = kBlock * 2 * sizeof(float)};
    int error = 0;
    pa_ = pa_simple_new(server.c_str(), "ear", PA_STREAM_RECORD, "ears.monitor", "ear", &spec,
                        nullptr, &buffer, &error);
    if (pa_ == nullptr) {
      std::fprintf(stderr, "The output cannot be recorded.\n");
      std::exit(1);
    }
    thread_ = std::jthread([this](const std::stop_token& stop) { listen(stop); });
  }
  ~Ear() {
    thread_.request_stop();
    thread_.join();
    pa_simple_free(pa_);
  }
  Ear(const Ear&) = delete;
  Ear& operator=(const Ear&) = delete;

  /// When the first loud frame after a moment was there; nothing: there was none so far.
  std::optional<Clock::time_point> firstLoud(Clock::time_point after) const {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(loud_.begin(), loud_.end(),
                                    [&](const Block& block) { return block.first > after; });
    if (found == loud_.end()) return std::nullopt;
    return found->first;
  }
  /// The last one up to now.
  Clock::time_point lastLoud() const {
    const std::lock_guard lock(mutex_);
    return loud_.empty() ? Clock::time_point() : loud_.back().last;
  }

 private:
  struct Block {
    Clock::time_point first, last;
  };
  void listen(const std::stop_token& stop) {
    std::vector<float> values(kBlock * 2);
    while (!stop.stop_requested()) {
      if (pa_simple_read(pa_, values.data(), values.size() * sizeof(float), nullptr) < 0) return;
      const Clock::time_point now = Clock::now();
      int first = -1, last = -1;
      for (int i = 0; i < kBlock; ++i) {
        if (std::max(std::abs(values[2 * i]), std::abs(values[2 * i + 1])) < kLoud) continue;
        if (first < 0) first = i;
        last = i;
      }
      if (first < 0) continue;
      // The block's last frame came just now.
      const auto at = [&](int frame) {
        return now - std::chrono::microseconds((kBlock - frame) * 1'000'000LL / 48'000);
      };
      const std::lock_guard lock(mutex_);
      loud_.push_back({at(first), at(last)});
    }
  }

  pa_simple* pa_ = nullptr;
  mutable std::mutex mutex_;
  std::vector<Block> loud_;
  std::jthread thread_;
};

/// Contacts of a hand in the loop's samples, to their clicks. Lost ones are counted.
Waits contactToClick(const Ear& ear, int contacts, int& lost) {
  auto ring = std::make_unique<HeardRing>();
  sound::LiveSound live(*ring);
  live.setWindow({.id = 1, .region = {0, 0, 80, Level{0}}, .gain = 1, .heights = {0, 20}});
  live.setVolume(100);
  const auto out = sound::openSoundServer([&](std::span<sound::Frame> f) { live.render(f); });
  constexpr int kApart = 400, kDown = 40;  // Ticks.
  std::vector<Clock::time_point> began;
  const Clock::time_point start = Clock::now();
  const int ticks = (contacts + 2) * kApart;  // The first two open the stream.
  for (int tick = 0; tick < ticks; ++tick) {
    std::this_thread::sleep_until(start + std::chrono::milliseconds(tick));
    HapticSample s;
    s.tick = static_cast<std::uint64_t>(tick);
    s.time_ns = std::chrono::nanoseconds(Clock::now().time_since_epoch()).count();
    s.window_id = 1;
    const int turn = tick % kApart;
    s.contact = turn >= kApart - kDown;
    s.hip = {40, 40, s.contact ? -1 : 0.1 * (kApart - kDown - turn)};
    s.proxy = {40, 40, s.contact ? 0 : s.hip.z};
    s.proxy_view = s.hip_view = {40, 40, 10};
    s.force = {0, 0, s.contact ? 1.5 : 0};
    s.detail = 1;
    s.origin = CellStatus::measured;
    if (turn == kApart - kDown && tick > 2 * kApart) began.push_back(Clock::now());
    ring->push(s);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(kApart));
  Waits waits;
  for (const Clock::time_point contact : began) {
    const auto heard = ear.firstLoud(contact);
    if (!heard || ms(*heard - contact) > kApart - kDown) {
      ++lost;
    } else {
      waits.push_back(ms(*heard - contact));
    }
  }
  return waits;
}

/// Waits in the event loop.
bool until(const std::function<bool()>& holds, int most_ms) {
  QElapsedTimer since;
  since.start();
  while (!holds()) {
    if (since.elapsed() > most_ms) return false;
    QTest::qWait(1);
  }
  return true;
}

constexpr int kPatienceMs = 20'000;
constexpr double kQuietMs = 400;  // No pause between words is longer.

bool isQuiet(const Ear& ear) {
  return ms(Clock::now() - ear.lastLoud()) > kQuietMs;
}

/// Sentences to their first sound, and a button that cuts them to silence.
void sayAndCut(const Ear& ear, const VoiceWays& ways, int times, Waits& to_sound, Waits& to_silence,
               int& lost) {
  OwnVoice voice(ways);
  voice.setSettings({.own_voice = true, .language = "en"});
  until([] { return false; }, 1000);
  for (int i = 0; i <= times; ++i) {
    until([&] { return isQuiet(ear); }, kPatienceMs);
    const Clock::time_point asked = Clock::now();
    voice.speak(QStringLiteral("Touching, middle left, three centimetres high, and a long story "
                               "follows that nobody hears to its end, because a button cuts it."),
                SaidBecause::asked);
    std::optional<Clock::time_point> heard;
    if (!until([&] { return (heard = ear.firstLoud(asked)).has_value(); }, kPatienceMs)) {
      ++lost;
      continue;
    }
    const double sound_ms = ms(*heard - asked);
    constexpr int kTalksMs = 1200;
    until([] { return false; }, kTalksMs);
    const Clock::time_point pressed = Clock::now();
    voice.hush();
    until([&] { return isQuiet(ear); }, kPatienceMs);
    if (i == 0) continue;  // Which starts programs.
    to_sound.push_back(sound_ms);
    to_silence.push_back(std::max(0.0, ms(ear.lastLoud() - pressed)));
  }
}

/// Debian's dispatcher with its own module for espeak-ng, on a socket of its own.
class Dispatcher {
 public:
  Dispatcher() {
    QDir(folder_.path()).mkdir("modules");
    QFile config(folder_.filePath("speechd.conf"));
    if (config.open(QIODevice::WriteOnly)) {
      config.write(
          "LogLevel 1\nAudioOutputMethod \"pulse\"\nAudioPulseDevice \"default\"\n"
          "AddModule \"espeak-ng\" \"sd_espeak-ng\" \"espeak-ng.conf\"\n"
          "DefaultModule espeak-ng\n");
    }
    config.close();
    QFile::copy("/etc/speech-dispatcher/modules/espeak-ng.conf",
                folder_.filePath("modules/espeak-ng.conf"));
    process_.start("speech-dispatcher", {"-s", "-t", "0", "-C", folder_.path(), "-S", socket(),
                                         "-P", folder_.filePath("pid"), "-L", folder_.path()});
  }
  ~Dispatcher() {
    process_.kill();
    process_.waitForFinished();
  }
  QString socket() const { return folder_.filePath("socket"); }
  bool isThere() const { return QFile::exists(socket()); }

 private:
  QTemporaryDir folder_;
  QProcess process_;
};

void print(const char* what, const char* computer, Waits waits, int lost) {
  if (waits.empty()) {
    std::printf("| %s | %s | not measured | | | %d |\n", what, computer, lost);
    return;
  }
  std::sort(waits.begin(), waits.end());
  const auto part = [&](double share) {
    return waits[static_cast<std::size_t>(share * static_cast<double>(waits.size() - 1))];
  };
  std::printf("| %s | %s | %.0f | %.0f | %.0f | %d of %zu |\n", what, computer, part(0.5),
              part(0.95), waits.back(), lost, waits.size() + static_cast<std::size_t>(lost));
  std::fflush(stdout);
}

void measure(const Ear& ear, const char* computer) {
  constexpr int kContacts = 150, kSentences = 20;
  int lost = 0;
  const Waits clicks = contactToClick(ear, kContacts, lost);
  print("contact to click", computer, clicks, lost);
  const auto voices = [&](const VoiceWays& ways, const char* sound, const char* silence) {
    Waits to_sound, to_silence;
    int unheard = 0;
    sayAndCut(ear, ways, kSentences, to_sound, to_silence, unheard);
    print(sound, computer, to_sound, unheard);
    print(silence, computer, to_silence, 0);
  };
  voices({.socket = {}}, "sentence to first sound, espeak-ng", "button to silence, espeak-ng");
  Dispatcher dispatcher;
  if (!until([&] { return dispatcher.isThere(); }, kPatienceMs)) return;
  voices({.socket = dispatcher.socket().toStdString()},
         "sentence to first sound, Speech Dispatcher", "button to silence, Speech Dispatcher");
}

/// Twice as many programs as cores that do nothing but count.
class BusyCores {
 public:
  BusyCores() {
    for (unsigned i = 0; i < 2 * std::thread::hardware_concurrency(); ++i) {
      const pid_t child = fork();
      if (child == 0) {
        std::atomic<unsigned> count{0};
        while (true) ++count;
      }
      children_.push_back(child);
    }
  }
  ~BusyCores() {
    for (const pid_t child : children_) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
  }

 private:
  std::vector<pid_t> children_;
};

int run() {
  const test::SoundServer server;
  if (!until([&] { return server.isReady(); }, kPatienceMs)) {
    std::fprintf(stderr, "PulseAudio does not start: %s\n", server.log().toUtf8().constData());
    return 1;
  }
  server.sendTo(QStringLiteral("ears"));
  qputenv("PULSE_SERVER", server.address());
  const Ear ear(server.address().toStdString());
  std::printf(
      "| From, to | Computer | median ms | 95 %% | most | lost |\n|---|---|---:|---:|---:|---:|\n");
  measure(ear, "idle");
  const BusyCores busy;
  measure(ear, "busy");
  return 0;
}

}  // namespace
}  // namespace relievo

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  return relievo::run();
}
