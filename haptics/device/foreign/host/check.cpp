// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/host/check.h"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sched.h>
#include <algorithm>
#include <array>
#include <cfenv>
#include <clocale>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>
#include <vector>

#include "haptics/device/foreign/host/loaded_plugin.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::foreign {

namespace {
constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kMostStepNs = 5 * kMs;

/// Empty: passed.
struct Verdict {
  std::string why;
  bool skipped = false;
};

std::string troubleText(const Trouble& trouble) {
  constexpr std::array<const char*, static_cast<std::size_t>(HostTrouble::count)> kTexts{
      "",
      "it cannot be loaded: ",
      "it exports no relievo_device_entry",
      "it is of another major version",
      "a structure is too small, or a function or a name is missing",
      "init failed",
      "the device is unknown",
      "open or limits failed: ",
      "limits are impossible",
      "an exception left a function"};
  return kTexts[static_cast<std::size_t>(trouble.what)] + trouble.text;
}

Trouble loadAndBegin(LoadedPlugin& plugin, const std::string& file) {
  const Trouble trouble = plugin.load(file);
  return trouble.what == HostTrouble::none ? plugin.begin() : trouble;
}

/// Everything that is done without a device being opened, as far as it goes.
void goThrough(const std::string& file) {
  LoadedPlugin plugin;
  if (loadAndBegin(plugin, file).what != HostTrouble::none) return;
  for (const relievo_device_name& name : plugin.scan()) {
    relievo_device* const device = plugin.create(name.id);
    if (isWhole(device)) plugin.destroy(device);
  }
}

Verdict checkTable(const CheckAsk& ask) {
  LoadedPlugin plugin;
  return {troubleText(plugin.load(ask.file))};
}

Verdict checkBeginning(const CheckAsk& ask) {
  LoadedPlugin plugin;
  return {troubleText(loadAndBegin(plugin, ask.file))};
}

Verdict checkScan(const CheckAsk& ask) {
  LoadedPlugin plugin;
  if (const Trouble trouble = loadAndBegin(plugin, ask.file); trouble.what != HostTrouble::none) {
    return {troubleText(trouble)};
  }
  constexpr std::size_t kRoom = 64;
  const auto scanned = [&](std::uint32_t room, std::vector<relievo_device_name>& names) {
    names.assign(kRoom, {});
    std::memset(names.data(), 0x5a, kRoom * sizeof(relievo_device_name));
    for (std::size_t i = 0; i < room; ++i) names[i].struct_size = sizeof(relievo_device_name);
    return plugin.entry().scan(names.data(), room);
  };
  std::vector<relievo_device_name> names;
  const std::uint32_t there = scanned(0, names);
  for (const std::uint32_t room : {0U, 1U, static_cast<std::uint32_t>(kRoom) - 1}) {
    if (scanned(room, names) != there) return {"the number of devices depends on the room"};
    const auto* const beyond = reinterpret_cast<const unsigned char*>(names.data() + room);
    const std::size_t bytes = (kRoom - room) * sizeof(relievo_device_name);
    if (!std::all_of(beyond, beyond + bytes, [](unsigned char byte) { return byte == 0x5a; })) {
      return {"it writes beyond the room that it was given"};
    }
    const std::size_t filled = std::min<std::size_t>(room, there);
    for (std::size_t i = 0; i < filled; ++i) {
      const bool ends = std::memchr(names[i].id, 0, sizeof(names[i].id)) != nullptr &&
                        std::memchr(names[i].name, 0, sizeof(names[i].name)) != nullptr;
      if (!ends || !isId(names[i].id)) return {"an id is not of [a-z0-9._-]"};
    }
  }
  return {};
}

Verdict checkUnknownId(const CheckAsk& ask) {
  LoadedPlugin plugin;
  if (const Trouble trouble = loadAndBegin(plugin, ask.file); trouble.what != HostTrouble::none) {
    return {troubleText(trouble)};
  }
  return {plugin.create("no.such-device_0") == nullptr ? "" : "it makes a device of an unknown id"};
}

Verdict checkExtension(const CheckAsk& ask) {
  LoadedPlugin plugin;
  if (const Trouble trouble = loadAndBegin(plugin, ask.file); trouble.what != HostTrouble::none) {
    return {troubleText(trouble)};
  }
  const std::vector<relievo_device_name> names = plugin.scan();
  if (names.empty()) return {"it found no device to ask", true};
  relievo_device* const device = plugin.create(names.front().id);
  if (!isWhole(device)) return {"it makes no whole device of an id that it found"};
  const void* const extension = device->get_extension(device->self, "relievo.no-such/1");
  plugin.destroy(device);
  return {extension == nullptr ? "" : "it has an extension that does not exist"};
}

std::size_t entriesOf(const char* folder) {
  std::error_code error;
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(folder, error), {}));
}

Verdict checkLeftovers(const CheckAsk& ask) {
  goThrough(ask.file);  // A library of the maker may keep what it opens once.
  const std::size_t files = entriesOf("/proc/self/fd"), threads = entriesOf("/proc/self/task");
  goThrough(ask.file);
  if (entriesOf("/proc/self/fd") != files) return {"it leaves descriptors open"};
  return {entriesOf("/proc/self/task") == threads ? "" : "it leaves threads behind"};
}

/// What belongs to the process, and not to a plug-in.
struct Surroundings {
  std::vector<void (*)(int)> handlers;
  std::string locale, folder;
  int rounding = 0, scheduling = 0;
  mode_t mask = 0;

  bool operator==(const Surroundings&) const = default;
};

Surroundings surroundings() {
  Surroundings now;
  for (int signal = 1; signal < NSIG; ++signal) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) == 0) now.handlers.push_back(action.sa_handler);
  }
  now.locale = std::setlocale(LC_ALL, nullptr);  // NOLINT(concurrency-mt-unsafe): one thread.
  std::error_code error;
  now.folder = std::filesystem::current_path(error).string();
  now.rounding = std::fegetround();
  now.scheduling = ::sched_getscheduler(0);
  now.mask = ::umask(0);
  ::umask(now.mask);
  return now;
}

Verdict checkSurroundings(const CheckAsk& ask) {
  const Surroundings before = surroundings();
  goThrough(ask.file);
  const Surroundings after = surroundings();
  if (before == after) return {};
  if (before.handlers != after.handlers) return {"it changes signal handlers"};
  if (before.rounding != after.rounding) return {"it changes the rounding mode"};
  return {before.locale != after.locale ? "it changes the locale"
                                        : "it changes the umask, the folder or the scheduling"};
}

Verdict checkSilence(const CheckAsk& ask) {
  const OwnedFd output(::memfd_create("output", MFD_CLOEXEC));
  ::dup2(output.get(), STDOUT_FILENO);
  goThrough(ask.file);
  std::fflush(stdout);
  struct stat facts {};
  const bool silent = ::fstat(output.get(), &facts) == 0 && facts.st_size == 0;
  return {silent ? "" : "it writes to the standard output"};
}

/// A device that is open for one test.
class OpenDevice {
 public:
  /// @param cuts_before  its force is cut before it is open, as a guard may do that does not know
  /// how far it is
  explicit OpenDevice(const CheckAsk& ask, bool cuts_before = false)
      : trouble_(loadAndBegin(plugin_, ask.file)) {
    if (trouble_.what != HostTrouble::none) return;
    device_ = plugin_.create(ask.device);
    if (cuts_before && isWhole(device_)) device_->cut_force(device_->self);
    if (device_ == nullptr) {
      trouble_.what = HostTrouble::no_device;
    } else if (!isWhole(device_)) {
      device_ = nullptr;
      trouble_.what = HostTrouble::incomplete;
    } else if (const relievo_status status = device_->open(device_->self); status < 0) {
      trouble_ = {HostTrouble::refuses, status, lastError(device_)};
    } else {
      trouble_ = askLimits(device_, limits_);
    }
  }
  ~OpenDevice() { plugin_.destroy(device_); }
  OpenDevice(const OpenDevice&) = delete;
  OpenDevice& operator=(const OpenDevice&) = delete;

  const Trouble& trouble() const { return trouble_; }
  const ForeignLimits& limits() const { return limits_; }
  relievo_device& operator*() const { return *device_; }

 private:
  LoadedPlugin plugin_;
  Trouble trouble_;
  relievo_device* device_ = nullptr;
  ForeignLimits limits_;
};

/// What one step did.
struct Step {
  relievo_status status = RELIEVO_OK;
  relievo_sample sample{};
  std::int64_t took_ns = 0, ended_ns = 0;
  long allocated = 0;
};

/// Steps without a force, at the device's rate, in a thread of their own.
std::vector<Step> stepsOf(const OpenDevice& open, double seconds) {
  constexpr double kMostSteps = 100'000;
  const double rate = open.limits().rate_hz;
  std::vector<Step> steps(static_cast<std::size_t>(std::clamp(seconds * rate, 10.0, kMostSteps)));
  std::thread([&] {
    constexpr std::array<double, 3> kNoForce{};
    std::int64_t next_ns = monotonicNs();
    for (Step& step : steps) {
      step.sample.struct_size = sizeof(relievo_sample);
      const long before = allocations();
      const std::int64_t began_ns = monotonicNs();
      step.status = (*open).step((*open).self, kNoForce.data(), began_ns, &step.sample);
      step.ended_ns = monotonicNs();
      step.took_ns = step.ended_ns - began_ns;
      step.allocated = allocations() - before;
      next_ns = std::max(next_ns + static_cast<std::int64_t>(1e9 / rate), monotonicNs());
      sleepUntil(next_ns);
    }
  }).join();
  return steps;
}

Verdict checkLimits(const CheckAsk& ask) {
  const OpenDevice open(ask);
  return {troubleText(open.trouble())};
}

/// Half of the steps, so that a computer that was busy for a moment is no fault of the plug-in.
Verdict checkDuration(const CheckAsk& ask) {
  const OpenDevice open(ask);
  if (open.trouble().what != HostTrouble::none) return {troubleText(open.trouble())};
  std::vector<Step> steps = stepsOf(open, ask.seconds);
  const auto late = std::count_if(steps.begin(), steps.end(),
                                  [](const Step& step) { return step.took_ns > kMostStepNs; });
  return {2 * static_cast<std::size_t>(late) > steps.size() ? "steps take longer" : ""};
}

Verdict checkAllocations(const CheckAsk& ask) {
  if (allocations() < 0) return {"allocations are not counted in this build", true};
  const OpenDevice open(ask);
  if (open.trouble().what != HostTrouble::none) return {troubleText(open.trouble())};
  const std::vector<Step> steps = stepsOf(open, ask.seconds);
  const bool any =
      std::any_of(steps.begin(), steps.end(), [](const Step& step) { return step.allocated > 0; });
  return {any ? "step allocates memory" : ""};
}

Verdict checkPlaces(const CheckAsk& ask) {
  const OpenDevice open(ask);
  if (open.trouble().what != HostTrouble::none) return {troubleText(open.trouble())};
  std::int64_t last_ns = 0;
  bool any = false;
  for (const Step& step : stepsOf(open, ask.seconds)) {
    if (step.status != RELIEVO_OK) continue;
    any = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const double place = step.sample.position_mm[i];
      if (!std::isfinite(place)) return {"a place is not finite"};
      if (std::abs(place) > 2 * open.limits().half_extent_mm[i]) return {"a place is out of reach"};
    }
    const std::int64_t time_ns = step.sample.time_ns;
    if (time_ns > step.ended_ns) return {"a place is of the future"};
    if (step.ended_ns - step.took_ns - time_ns > 20 * kMs) return {"a place is older than 20 ms"};
    if (time_ns < last_ns) return {"the time of places goes back"};
    last_ns = time_ns;
  }
  return any ? Verdict{} : Verdict{"no step gave a place"};
}

Verdict checkJumps(const CheckAsk& ask) {
  const OpenDevice open(ask);
  if (open.trouble().what != HostTrouble::none) return {troubleText(open.trouble())};
  const relievo_sample* last = nullptr;
  const std::vector<Step> steps = stepsOf(open, ask.seconds);
  for (const Step& step : steps) {
    if (step.status != RELIEVO_OK) continue;
    if (last != nullptr) {
      double square = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        square += std::pow(step.sample.position_mm[i] - last->position_mm[i], 2);
      }
      const double ms = 1e-6 * static_cast<double>(step.sample.time_ns - last->time_ns);
      constexpr double kMostMmPerMs = 5;
      if (std::sqrt(square) > kMostMmPerMs * std::max(1.0, ms)) return {"a place jumps"};
    }
    last = &step.sample;
  }
  return {};
}

Verdict checkCut(const CheckAsk& ask) {
  const OpenDevice open(ask, true);
  if (open.trouble().what != HostTrouble::none) return {troubleText(open.trouble())};
  std::atomic<bool> stepped{false};
  std::thread stepping([&] {
    stepsOf(open, ask.seconds);
    stepped.store(true);
  });
  int cuts = 0, late = 0, refused = 0;
  while (!stepped.load() || cuts == 0) {
    const std::int64_t began_ns = monotonicNs();
    if ((*open).cut_force((*open).self) < 0) ++refused;
    if (monotonicNs() - began_ns > kMostStepNs) ++late;
    ++cuts;
    sleepUntil(began_ns + 10 * kMs);
  }
  stepping.join();
  (*open).close((*open).self);
  (*open).cut_force((*open).self);  // Whatever it says now.
  if (refused > 0) return {"cut_force fails"};
  return {2 * late > cuts ? "cut_force takes longer" : ""};
}

Verdict checkReopening(const CheckAsk& ask) {
  const OpenDevice open(ask);
  if (open.trouble().what != HostTrouble::none) return {troubleText(open.trouble())};
  relievo_device& device = *open;
  device.close(device.self);
  device.close(device.self);
  return {device.open(device.self) < 0 ? "it does not open again" : ""};
}

struct NamedCheck {
  std::string_view code;
  Verdict (*run)(const CheckAsk&);
};
constexpr std::array<NamedCheck, 15> kFunctions{{{"C01", checkTable},
                                                 {"C02", checkBeginning},
                                                 {"C03", checkScan},
                                                 {"C04", checkUnknownId},
                                                 {"C05", checkExtension},
                                                 {"C06", checkLeftovers},
                                                 {"C07", checkSurroundings},
                                                 {"C08", checkSilence},
                                                 {"C20", checkLimits},
                                                 {"C21", checkDuration},
                                                 {"C22", checkAllocations},
                                                 {"C23", checkPlaces},
                                                 {"C24", checkJumps},
                                                 {"C25", checkCut},
                                                 {"C26", checkReopening}}};

std::string lineOf(const Verdict& verdict) {
  if (verdict.skipped) return "skipped\t" + verdict.why + "\n";
  if (verdict.why.empty()) return "passed\t\n";
  std::string why = verdict.why;  // A plug-in's own words may be in it.
  for (char& c : why) {
    if (static_cast<unsigned char>(c) < 32) c = ' ';
  }
  return "failed\t" + why + "\n";
}
}  // namespace

int check(const CheckAsk& ask) {
  const auto* const found = std::find_if(kFunctions.begin(), kFunctions.end(),
                                         [&](const NamedCheck& c) { return c.code == ask.code; });
  if (found == kFunctions.end()) return 2;
  Verdict verdict;
  try {
    verdict = found->run(ask);
  } catch (...) {
    verdict = {"an exception left a function"};
  }
  const std::string line = lineOf(verdict);
  return ::write(kAnswerFd, line.data(), line.size()) > 0 ? 0 : 2;
}

}  // namespace relievo::foreign
