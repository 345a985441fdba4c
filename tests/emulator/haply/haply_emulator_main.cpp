// SPDX-License-Identifier: BSD-3-Clause
// relievo-haply-emulator: Haply's Inverse Service with an arm and a hand, without either;
// docs/user/devices.md.
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <thread>

#include "tests/emulator/haply/inverse_service.h"

namespace {

using relievo::emulator::allHaplyFaults;
using relievo::emulator::HaplyFault;
using relievo::emulator::HaplyWorld;
using relievo::emulator::InverseService;

int help() {
  std::cout
      << "relievo-haply-emulator [--port N] [--events N] [--version V] [--minverse] [--id ID]\n"
         "  Haply's Inverse Service with an Inverse3, without either.\n\n"
         "  --port N     serve on this TCP port of this computer (10001; 0: any)\n"
         "  --events N   its channel of events on this one (10020, and any if\n"
         "               the other one is not the usual; 0: any)\n"
         "  --version V  of the service: 3.5.0.0, 3.4.8, 3.0.5\n"
         "  --minverse   the smaller arm\n"
         "  --id ID      of the device: 049D\n\n"
         "While it runs, lines of input move it: 'X Y Z' holds the grip there (mm; right, up,\n"
         "toward you; the middle is 0 0 0), 'pull X Y Z' pulls it there and lets it be pushed,\n"
         "'button a' presses (a, b, c), 'release', 'fault NAME' plants a fault, 'fault none'\n"
         "takes it back, 'event NAME' tells an event (device-battery-low, device-sleep;\n"
         "ebrake_triggered, stall_detected and other types of safety), 'log' writes what the\n"
         "motors showed, 'quit'. The faults are:\n ";
  for (const HaplyFault fault : allHaplyFaults()) std::cout << ' ' << nameOf(fault);
  std::cout << '\n';
  return 0;
}

/// @return false: there is none of that name
bool plant(HaplyWorld& world, const std::string& name) {
  if (name == nameOf(HaplyFault::none)) {
    world.fault = HaplyFault::none;
    return true;
  }
  for (const HaplyFault fault : allHaplyFaults()) {
    if (name != nameOf(fault)) continue;
    world.fault = fault;
    world.fault_after = world.messages;
    return true;
  }
  return false;
}

/// Each change of force: when (ns, monotonic), x y z in N, why.
void writeLog(const HaplyWorld& world) {
  for (const HaplyWorld::Shown& shown : world.log) {
    std::printf("%lld %.4f %.4f %.4f %s\n", static_cast<long long>(shown.time_ns), shown.force[0],
                shown.force[1], shown.force[2], shown.why);
  }
  std::printf("%zu changes, largest %.4f N, %llu messages\n", world.log.size(), world.largest_n,
              static_cast<unsigned long long>(world.messages));
  std::fflush(stdout);
}

/// @return false: not understood
bool follow(HaplyWorld& world, const std::string& line) {
  HaplyWorld::Triple place{};
  if (std::sscanf(line.c_str(), "%lf %lf %lf", place.data(), &place[1], &place[2]) == 3) {
    world.hold(place);
  } else if (std::sscanf(line.c_str(), "pull %lf %lf %lf", place.data(), &place[1], &place[2]) ==
             3) {
    world.pullToward(place);
  } else if (line == "button a") {
    world.button_a = true;
  } else if (line == "button b") {
    world.button_b = true;
  } else if (line == "button c") {
    world.button_c = true;
  } else if (line == "release") {
    world.button_a = world.button_b = world.button_c = false;
  } else if (line.starts_with("event device-")) {
    world.tellEvent(line.substr(6));
  } else if (line.starts_with("event ")) {
    world.tellEvent("device-safety-triggered", line.substr(6));
  } else if (line == "log") {
    writeLog(world);
  } else if (line.starts_with("fault ")) {
    return plant(world, line.substr(6));
  } else {
    return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr std::uint16_t kUsualPort = 10001, kUsualEventsPort = 10020;
  std::uint16_t port = kUsualPort;
  std::optional<std::uint16_t> events_port;
  std::string version = "3.5.0.0", type = "inverse3", id = "049D";
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    const std::string value = i + 1 < argc ? argv[i + 1] : "";
    if (option == "--help") return help();
    if (option == "--minverse") {
      type = "minverse";
      continue;
    }
    std::uint16_t number = 0;
    const auto read = std::from_chars(value.data(), value.data() + value.size(), number);
    const bool is_number = read.ec == std::errc() && read.ptr == value.data() + value.size();
    const bool is_port = option == "--port" || option == "--events";
    if (value.empty() || (is_port && !is_number) ||
        (!is_port && option != "--version" && option != "--id")) {
      std::cerr << "relievo-haply-emulator: '" << option << "' is not understood; see --help.\n";
      return 1;
    }
    if (option == "--port") port = number;
    if (option == "--events") events_port = number;
    if (option == "--version") version = value;
    if (option == "--id") id = value;
    ++i;
  }
  std::signal(SIGPIPE, SIG_IGN);  // Whoever goes away while it is answered.
  try {
    const std::uint16_t usual = port == kUsualPort ? kUsualEventsPort : std::uint16_t{0};
    InverseService service(port, events_port.value_or(usual));
    service.with([&](HaplyWorld& world) {
      world.version = version;
      world.type = type;
      world.id = id;
    });
    std::cout << "Serving on port " << service.port() << ", events on " << service.eventsPort()
              << std::endl;
    for (std::string line; std::getline(std::cin, line) && line != "quit";) {
      if (!service.with([&](HaplyWorld& world) { return follow(world, line); })) {
        std::cerr << "relievo-haply-emulator: not understood: " << line << '\n';
      }
    }
    // The end of the input is no end: a service has none.
    while (std::cin.eof()) std::this_thread::sleep_for(std::chrono::seconds(1));
  } catch (const std::exception& error) {
    std::cerr << "relievo-haply-emulator: port " << port << ": " << error.what() << '\n';
    return 6;
  }
  return 0;
}
