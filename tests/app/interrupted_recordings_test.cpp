// SPDX-License-Identifier: BSD-3-Clause
// `relievo record`, interrupted at a random moment of a touch, and `relievo replay --verify` of
// what is on the disk then, as a user runs both: each kind of interruption once, or as many
// recordings as RELIEVO_RECORDINGS says, drawn with the seed RELIEVO_SEED. The Falcon is emulated
// behind the real libusb.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <thread>

#include "core/base/error.h"
#include "haptics/record/replay.h"
#include "tests/app/command_test.h"
#include "tests/emulator/mock_usb.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using emulator::FalconEmulator;
using emulator::SharedFalcon;
using std::chrono::milliseconds;

constexpr int kDevice = 6, kCannotWrite = 3;

/// `relievo` in a process of its own.
class Program {
 public:
  /// @param most_bytes  of each file that it writes, as on a disk that becomes full there
  Program(const std::vector<std::string>& arguments, const fs::path& folder,
          std::optional<rlim_t> most_bytes) {
    std::vector<std::string> words{RELIEVO_BINARY_DIR "/bin/relievo"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const std::string out = (folder / "out").string(), err = (folder / "err").string();
    child_ = fork();
    if (child_ != 0) return;
    setenv("HOME", folder.c_str(), 1);
    unsetenv("XDG_CONFIG_HOME");
    unsetenv("XDG_DATA_HOME");
    const auto redirect = [](const std::string& file, int to) {
      const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      if (opened < 0 || dup2(opened, to) < 0) _exit(125);
    };
    redirect(out, STDOUT_FILENO);
    redirect(err, STDERR_FILENO);
    if (most_bytes) {
      const rlimit limit{*most_bytes, *most_bytes};
      setrlimit(RLIMIT_FSIZE, &limit);
      signal(SIGXFSZ, SIG_IGN);  // A full disk says so by an error.
    }
    execv(argv[0], argv.data());
    _exit(126);
  }
  ~Program() {
    if (!status_) {
      signal(SIGKILL);
      wait();
    }
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void signal(int number) const { kill(child_, number); }
  bool running() {
    if (status_) return false;
    int status = 0;
    if (waitpid(child_, &status, WNOHANG) == child_) status_ = status;
    return !status_;
  }
  /// Its exit status; 128 + signal if it was killed.
  int wait() {
    int status = 0;
    if (!status_ && waitpid(child_, &status, 0) == child_) status_ = status;
    return WIFEXITED(*status_) ? WEXITSTATUS(*status_) : 128 + WTERMSIG(*status_);
  }

 private:
  static void signal(int number, void (*handler)(int)) { ::signal(number, handler); }
  pid_t child_ = -1;
  std::optional<int> status_;
};

enum class Trouble { none, stall, silent, nonsense, unplugged };
enum class Ending { itself, interrupt, terminate, hangup, killed, full };
constexpr std::array kTroubles{"none", "program stalled", "device silent", "nonsense from device",
                               "unplugged and back"};
constexpr std::array kEndings{"by itself",       "Ctrl+C", "terminated",
                              "terminal closed", "killed", "disk full"};
constexpr std::array kHands{"virtual:light", "virtual:relaxed", "virtual:firm", "mouse", "falcon"};
constexpr std::size_t kFalcon = 4;

struct Plan {
  std::size_t hand = 0;
  Trouble trouble = Trouble::none;
  Ending ending = Ending::itself;
  std::string file = "log.csv";
  std::string preset;  ///< Empty: the spring alone.
  int trouble_ms = 0, trouble_for_ms = 0, ending_ms = 0;
  rlim_t most_bytes = 0;

  std::string text() const {
    return std::string(kHands[hand]) + ", " + kTroubles[static_cast<std::size_t>(trouble)] + ", " +
           kEndings[static_cast<std::size_t>(ending)];
  }
};

/// What came of the recordings of one kind.
struct Tally {
  int recordings = 0, verified = 0, in_contact = 0, with_fault = 0;
  std::uint64_t ticks = 0;
};

class InterruptedRecordings : public test::CommandTest {
 protected:
  void SetUp() override {
    usb_.emplace();
    if (!emulator::MockUsb::works()) GTEST_SKIP() << "umockdev's library is not preloaded";
    std::ostringstream points, stroke;
    for (int row = 0; row <= 160; ++row) {
      for (int col = 0; col <= 160; ++col) {
        const double x = 0.5 * col, y = 0.5 * row;
        points << x << ' ' << y << ' ' << 2 + 1.5 * std::sin(0.5 * x) * std::cos(0.4 * y) << '\n';
      }
    }
    scan_ = write("waves.xyz", points.str());
    // Down within 0.4 s, then round and round, never quite off the surface.
    stroke << "t_s,x_mm,y_mm,z_mm\n0,40,40,12\n0.2,40,40,8\n";
    for (int i = 0; i < 400; ++i) {
      const double t = 0.4 + 0.02 * i;
      stroke << t << ',' << 40 + 9 * std::sin(3 * (t - 0.4)) << ','
             << 40 + 7 * std::sin(2 * (t - 0.4)) << ',' << -1.5 + 1.2 * std::cos(5 * (t - 0.4))
             << '\n';
    }
    stroke_ = write("stroke.csv", stroke.str());
  }

  int draw(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  template <std::size_t N>
  std::size_t drawIn(const std::array<const char*, N>&) {
    return static_cast<std::size_t>(draw(0, static_cast<int>(N) - 1));
  }

  /// Moments and the rest of a plan; a trouble is a device's own, and only a Falcon has any.
  Plan drawn(std::size_t hand, Trouble trouble, Ending ending) {
    Plan plan{.hand = hand, .trouble = trouble, .ending = ending, .preset = {}};
    if (hand != kFalcon && trouble > Trouble::stall) plan.trouble = Trouble::stall;
    constexpr std::array kPresets{"", "smooth", "soft_stone", "bronze", "exact"};
    plan.preset = kPresets[static_cast<std::size_t>(draw(0, 4))];
    // HDF5 keeps rows four thousand at a time: less is not there yet when the program is killed.
    if (ending != Ending::killed && ending != Ending::full && draw(0, 4) == 0) plan.file = "log.h5";
    plan.trouble_ms = draw(500, 1200);
    plan.trouble_for_ms = draw(5, 300);
    plan.ending_ms = plan.trouble_ms + draw(0, 800);
    plan.most_bytes = static_cast<rlim_t>(draw(450'000, 800'000));
    return plan;
  }

  void plugIn() {
    falcon_ = std::make_shared<SharedFalcon>(
        emulator::EmulatorOptions{.firmware_loaded = true, .homed = true});
    falcon_->with([](FalconEmulator& f) { f.body.pullToward({0, 0, 158}); });
    usb_->plugIn(falcon_);
  }
  /// The hand that holds the Falcon, as the stroke leads the others.
  void lead(double t_s) {
    if (!falcon_) return;
    falcon_->with([t_s](FalconEmulator& f) {
      const double in = std::clamp((t_s - 0.2) / 0.3, 0.0, 1.0);
      f.body.pullToward({in * 9 * std::sin(3 * t_s), in * 7 * std::sin(2 * t_s), 158 - in * 50});
    });
  }
  void begin(const Plan& plan, const Program& program) {
    if (plan.trouble == Trouble::stall) program.signal(SIGSTOP);
    if (plan.trouble == Trouble::silent) {
      falcon_->with([](FalconEmulator& f) { f.troubles.silent = true; });
    }
    if (plan.trouble == Trouble::nonsense) {
      falcon_->with([](FalconEmulator& f) { f.troubles.impossible_encoders = true; });
    }
    if (plan.trouble == Trouble::unplugged) usb_->unplug();
  }
  void end(const Plan& plan, const Program& program) {
    if (plan.trouble == Trouble::stall) program.signal(SIGCONT);
    if (plan.trouble == Trouble::unplugged) return plugIn();
    if (!falcon_) return;
    falcon_->with(
        [](FalconEmulator& f) { f.troubles.silent = f.troubles.impossible_encoders = false; });
  }

  /// Does the file hold some hundred? Of HDF5 the disk tells nothing before there are thousands.
  bool hasRows(const Plan& plan) const {
    constexpr std::uintmax_t kHeaderAndRows = 100'000;
    std::error_code not_there;
    const std::uintmax_t size = fs::file_size(path(plan.file), not_there);
    return !not_there && (size > kHeaderAndRows || !plan.file.ends_with(".csv"));
  }
  /// @return the exit status
  int record(const Plan& plan) {
    falcon_.reset();
    usb_.emplace();
    // One that is to be ended goes on until it is, however late that comes.
    const char* const seconds = plan.ending == Ending::itself ? "2.2" : "300";
    std::vector<std::string> words{
        "record",      scan_,      "--unit",          "mm",        "--view", "top", "--region",
        "10,10,60,60", "--device", kHands[plan.hand], "--seconds", seconds,  "-o",  path(plan.file),
        "--report",    "json"};
    if (!plan.preset.empty()) words = test::joined(words, {"--preset", plan.preset});
    if (plan.hand == kFalcon) {
      plugIn();
    } else {
      words = test::joined(words, {"--stroke", stroke_});
    }
    fs::remove(path(plan.file));
    Program program(words, folder_.path(),
                    plan.ending == Ending::full ? std::optional(plan.most_bytes) : std::nullopt);
    // The file is made just before the loop starts, whose first rows may take a busy machine long.
    while (program.running() && !hasRows(plan)) {
      std::this_thread::sleep_for(milliseconds(2));
    }
    const Clock::time_point start = Clock::now();
    const auto until = [&](int ms) {
      while (program.running() && Clock::now() < start + milliseconds(ms)) {
        lead(std::chrono::duration<double>(Clock::now() - start).count());
        std::this_thread::sleep_for(milliseconds(2));
      }
    };
    const bool ends_in_trouble = plan.ending_ms < plan.trouble_ms + plan.trouble_for_ms;
    if (plan.trouble != Trouble::none) {
      until(plan.trouble_ms);
      begin(plan, program);
      until(ends_in_trouble ? plan.ending_ms : plan.trouble_ms + plan.trouble_for_ms);
      if (!ends_in_trouble) end(plan, program);
    }
    constexpr std::array kSignals{0, SIGINT, SIGTERM, SIGHUP, SIGKILL, 0};
    if (const int signal = kSignals[static_cast<std::size_t>(plan.ending)]; signal != 0) {
      until(plan.ending_ms);
      program.signal(signal);
    }
    // A stopped process hears nothing but SIGKILL before it goes on.
    if (plan.trouble != Trouble::none && ends_in_trouble) end(plan, program);
    until(600'000);
    const int exit_code = program.wait();
    usb_.reset();
    return exit_code;
  }

  void expectVerified(const Plan& plan, Tally& tally) {
    const int exit_code = record(plan);
    const std::string said = test::bytesOf(path("err"));
    LogTable log;
    try {
      log = readLog(path(plan.file));
    } catch (const FileError& error) {
      ADD_FAILURE() << plan.text() << ": " << error.what() << " The program ended with "
                    << exit_code << " and said: " << said;
      return;
    }
    if (log.rows.empty()) {
      ADD_FAILURE() << plan.text() << ": no row. " << said;
      return;
    }
    ++tally.recordings;
    tally.ticks += log.rows.size();
    tally.in_contact += log.rows.back().contact ? 1 : 0;
    tally.with_fault += wasTroubled(log) ? 1 : 0;
    if (plan.ending == Ending::killed) {
      EXPECT_EQ(exit_code, 128 + SIGKILL) << plan.text();
    } else if (plan.ending == Ending::full) {
      EXPECT_EQ(exit_code, kCannotWrite) << plan.text() << said;
    } else {
      EXPECT_TRUE(exit_code == 0 || exit_code == kDevice)
          << plan.text() << ": " << exit_code << said;
    }
    const test::CommandResult replay =
        test::runRelievo({"replay", path(plan.file), "--verify", "--report", "json"});
    const auto report = nlohmann::json::parse(replay.out, nullptr, false);
    const bool same = replay.exit_code == 0 && report.is_object() && report["identical"] == true &&
                      report["ticks"] == log.rows.size();
    tally.verified += same ? 1 : 0;
    EXPECT_TRUE(same) << plan.text() << ", " << plan.file << ", preset \"" << plan.preset
                      << "\", trouble at " << plan.trouble_ms << " ms for " << plan.trouble_for_ms
                      << ", end at " << plan.ending_ms << ": exit " << replay.exit_code << "\n"
                      << replay.out << replay.err;
  }
  /// Does it tell of a fault or of a start from zero?
  static bool wasTroubled(const LogTable& log) {
    const std::array words{std::string("resumed after"),
                           std::string(describe(DeviceFault::timeout)),
                           std::string(describe(DeviceFault::disconnected)),
                           std::string(describe(DeviceFault::protocol)),
                           std::string(describe(DeviceFault::not_ready))};
    return std::any_of(log.events.begin(), log.events.end(), [&](const LogEvent& event) {
      return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        return event.text.find(word) != std::string::npos;
      });
    });
  }

  std::mt19937 random_;
  std::string scan_, stroke_;
  std::optional<emulator::MockUsb> usb_;
  std::shared_ptr<SharedFalcon> falcon_;
};

int numberFrom(const char* variable, int otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

TEST_F(InterruptedRecordings, AllVerify) {
  const int seed = numberFrom("RELIEVO_SEED", 1);
  random_.seed(static_cast<unsigned>(seed));
  std::cout << "seed " << seed << '\n';
  struct Kind {
    std::size_t hand;
    Trouble trouble;
    Ending ending;
  };
  constexpr std::array<Kind, 14> kEachOnce{{
      {0, Trouble::none, Ending::interrupt},
      {kFalcon, Trouble::none, Ending::interrupt},
      {1, Trouble::stall, Ending::itself},
      {kFalcon, Trouble::silent, Ending::itself},
      {kFalcon, Trouble::unplugged, Ending::itself},
      {2, Trouble::none, Ending::killed},
      {0, Trouble::stall, Ending::killed},
      {kFalcon, Trouble::silent, Ending::killed},
      {1, Trouble::none, Ending::full},
      {kFalcon, Trouble::nonsense, Ending::full},
      {3, Trouble::stall, Ending::terminate},
      {kFalcon, Trouble::unplugged, Ending::interrupt},
      {0, Trouble::none, Ending::hangup},
      {kFalcon, Trouble::nonsense, Ending::itself},
  }};
  const int recordings = numberFrom("RELIEVO_RECORDINGS", static_cast<int>(kEachOnce.size()));
  std::map<std::string, Tally> tallies;
  for (int i = 0; i < recordings; ++i) {
    const auto which = static_cast<std::size_t>(i);
    const Kind kind = which < kEachOnce.size()
                          ? kEachOnce[which]
                          : Kind{drawIn(kHands), static_cast<Trouble>(drawIn(kTroubles)),
                                 static_cast<Ending>(drawIn(kEndings))};
    const Plan plan = drawn(kind.hand, kind.trouble, kind.ending);
    expectVerified(plan, tallies[plan.text()]);
  }
  Tally all;
  std::cout << "| hand, trouble, end | recordings | verify | touching at the end | with fault or "
               "pause | ticks |\n|---|---|---|---|---|---|\n";
  const auto show = [](const std::string& name, const Tally& t) {
    std::cout << "| " << name << " | " << t.recordings << " | " << t.verified << " | "
              << t.in_contact << " | " << t.with_fault << " | " << t.ticks << " |\n";
  };
  for (const auto& [name, tally] : tallies) {
    show(name, tally);
    all.recordings += tally.recordings;
    all.verified += tally.verified;
    all.in_contact += tally.in_contact;
    all.with_fault += tally.with_fault;
    all.ticks += tally.ticks;
  }
  show("all", all);
  EXPECT_EQ(all.verified, recordings);
  EXPECT_GT(2 * all.in_contact, recordings) << "most ends are in contact";
}

}  // namespace
}  // namespace relievo
