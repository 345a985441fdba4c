// SPDX-License-Identifier: BSD-3-Clause
// Somebody else's program against the emulated Falcon, on a real kernel by USB/IP: libnifalcon's
// `findfalcons`, which knows nothing of our reading of the protocol, has to load its own firmware,
// run its loops and print the encoders that the emulator turned. For whoever has installed it: it
// is found on the PATH, or named by RELIEVO_FINDFALCONS; docs/dev/testing.md.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <thread>

#include "tests/emulator/usbip_server.h"

namespace relievo::emulator {
namespace {

namespace fs = std::filesystem;

/// Empty: nobody has installed it.
fs::path theirProgram() {
  if (const char* const named = std::getenv("RELIEVO_FINDFALCONS")) return named;
  const char* const folders = std::getenv("PATH");
  std::istringstream path(folders == nullptr ? "" : folders);
  for (std::string folder; std::getline(path, folder, ':');) {
    const fs::path program = fs::path(folder) / "findfalcons";
    if (access(program.c_str(), X_OK) == 0) return program;
  }
  return {};
}

TEST(FindFalcons, RunsItsLoopsAndReadsTheEncodersThatWereTurned) {
  const fs::path program = theirProgram();
  if (program.empty()) {
    GTEST_SKIP() << "libnifalcon's findfalcons is neither on the PATH nor named by "
                    "RELIEVO_FINDFALCONS";
  }
  ASSERT_EQ(access(program.c_str(), X_OK), 0) << program << " cannot be run";
  const auto falcon = std::make_shared<SharedFalcon>();
  const std::array<int, 3> turned = falcon->with([](FalconEmulator& f) {
    f.body.beHomed();
    f.body.hold({3, -5, 131});
    return f.body.encoders();
  });
  const int socket = attachToVhci();
  if (socket < 0) {
    GTEST_SKIP() << "a virtual port needs root and the kernel module vhci_hcd: modprobe vhci-hcd";
  }
  const std::jthread server(
      [&](const std::stop_token& stop) { UsbipServer(socket, falcon, false).serve(stop); });
  std::this_thread::sleep_for(std::chrono::seconds(3));  // The kernel asks for its descriptors.

  std::FILE* const pipe = popen(("timeout 120 '" + program.string() + "' 2>&1").c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string said;
  int loops = 0, as_turned = 0;
  for (std::array<char, 400> line{}; std::fgets(line.data(), line.size(), pipe) != nullptr;) {
    int loop = 0;
    std::array<int, 3> read{};
    if (std::sscanf(line.data(), "Loops: %d | Enc1: %d | Enc2: %d | Enc3: %d", &loop, &read[0],
                    &read[1], &read[2]) == 4) {
      loops = std::max(loops, loop);
      const bool same = std::equal(read.begin(), read.end(), turned.begin(), [](int a, int b) {
        return static_cast<std::int16_t>(a) == static_cast<std::int16_t>(b);
      });
      as_turned += same ? 1 : 0;
    } else {
      said += line.data();
    }
  }
  const int status = pclose(pipe);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << said;
  EXPECT_EQ(loops, 3000) << said;
  // The first loops may still show what stood there before an answer had come.
  EXPECT_GE(as_turned, 2900) << said;
  falcon->with([](FalconEmulator& f) {
    EXPECT_EQ(f.uploads(), 1) << "with its own firmware";
    EXPECT_EQ(f.badCommands(), 0);
    for (const int light : {2, 4, 8}) {
      EXPECT_TRUE(std::any_of(f.commands().begin(), f.commands().end(),
                              [light](const SeenCommand& c) { return c.lights == light; }))
          << light;
    }
    f.unplug();
  });
}

}  // namespace
}  // namespace relievo::emulator
