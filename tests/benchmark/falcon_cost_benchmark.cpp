// SPDX-License-Identifier: BSD-3-Clause
// What an open Falcon costs: processor time of the same process without and with one, on a mocked
// port through the real libusb. A bare process that nobody asks (the loop stopped), then the whole
// program with its window, its loop running, forces off. Each pair in turn, three times, medians.
// xvfb-run -a build/release/benchmark/falcon_cost_benchmark
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <QByteArray>
#include <QSettings>
#include <QTemporaryDir>
#include <string>
#include <thread>

#include "tests/app/program_window.h"
#include "tests/emulator/idle_client.h"
#include "tests/emulator/mock_usb.h"

namespace {

using namespace relievo;  // NOLINT(google-build-using-namespace): a program of one file.

constexpr double kSeconds = 5;
constexpr int kRounds = 3;

void sleepSeconds(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// Of another process, user and system.
double processorSeconds(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(stat, text);
  unsigned long user = 0, system = 0;  // NOLINT(google-runtime-int)
  std::sscanf(text.c_str() + text.rfind(')') + 2,
              "%*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu", &user, &system);
  return static_cast<double>(user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

int idle(bool with) {
  const auto share = emulator::idleProcessorShare(with, kSeconds);
  if (!share) return 1;
  std::printf("%.6f\n", *share * kSeconds);
  return 0;
}

double idleSeconds(const std::string& self, bool with) {
  std::FILE* child = popen((self + (with ? " with" : " without")).c_str(), "r");
  double seconds = 0;
  if (child == nullptr || std::fscanf(child, "%lf", &seconds) != 1) std::exit(1);
  pclose(child);
  return seconds;
}

double programSeconds(const char* device) {
  QTemporaryDir home;
  qputenv("HOME", home.path().toUtf8());
  qputenv("XDG_CONFIG_HOME", home.filePath("config").toUtf8());
  {
    QSettings settings(home.filePath("config/relievo/relievo.ini"), QSettings::IniFormat);
    settings.setValue("plugins/haptics_plugin",
                      QByteArray(R"({"device": ")").append(device).append("\"}").toBase64());
  }
  test::ProgramWindow program({RELIEVO_SOURCE_DIR "/data/samples/panel.ply"});
  while (!program.title().starts_with("panel")) sleepSeconds(0.1);
  sleepSeconds(3);
  const double before = processorSeconds(program.process());
  sleepSeconds(kSeconds);
  const double used = processorSeconds(program.process()) - before;
  program.key("q", true);
  while (program.runs()) sleepSeconds(0.05);
  return used;
}

void compare(const char* what, const std::function<double()>& without,
             const std::function<double()>& with) {
  std::array<double, kRounds> a{}, b{};
  for (int i = 0; i < kRounds; ++i) {
    a[static_cast<std::size_t>(i)] = without();
    b[static_cast<std::size_t>(i)] = with();
  }
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  std::printf("%-28s without %6.1f ms/s, with %6.1f ms/s, ratio %.2f (bar: 2)\n", what,
              1e3 * a[kRounds / 2] / kSeconds, 1e3 * b[kRounds / 2] / kSeconds,
              b[kRounds / 2] / a[kRounds / 2]);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) return idle(std::string(argv[1]) == "with");
  if (std::getenv("LD_PRELOAD") == nullptr) {  // NOLINT(concurrency-mt-unsafe)
    setenv("LD_PRELOAD", "libumockdev-preload.so.0", 1);
    execv(argv[0], argv);
    return 1;
  }
  emulator::MockUsb usb;
  usb.plugIn(std::make_shared<emulator::SharedFalcon>(
      emulator::EmulatorOptions{.firmware_loaded = true, .homed = true}));
  const std::string self = std::filesystem::read_symlink("/proc/self/exe");
  compare(
      "a process, loop stopped", [&] { return idleSeconds(self, false); },
      [&] { return idleSeconds(self, true); });
  compare(
      "the program, loop running", [] { return programSeconds("mouse"); },
      [] { return programSeconds("falcon:0"); });
  return 0;
}
