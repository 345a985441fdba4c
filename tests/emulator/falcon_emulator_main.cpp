// SPDX-License-Identifier: BSD-3-Clause
// relievo-falcon-emulator: a virtual Falcon for the real kernel, by USB/IP; docs/user/falcon.md.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <iostream>
#include <string>
#include <thread>

#include "tests/emulator/usbip_server.h"

namespace {

using relievo::emulator::EmulatorOptions;
using relievo::emulator::FalconEmulator;
using relievo::emulator::SharedFalcon;
using relievo::emulator::UsbipServer;

int help() {
  std::cout << "relievo-falcon-emulator [--port N | --vhci] [--loaded] [--homed]\n"
               "  A virtual Novint Falcon. Needs the kernel module vhci_hcd: modprobe vhci-hcd\n\n"
               "  --port N  serve on this TCP port of this computer (3240); then, as root:\n"
               "            usbip attach -r 127.0.0.1 -b 1-1\n"
               "  --vhci    attach to this kernel's first virtual port at once (root)\n"
               "  --loaded  its firmware runs already\n"
               "  --homed   and all arms have found their zero\n\n"
               "While it runs, lines of input move it: 'X Y Z' holds the grip there (mm from the "
               "base; the\n"
               "middle is 0 0 125), 'button N' presses (0 plus, 1 forward, 2 centre, 3 minus), "
               "'release',\n"
               "'unplug', 'replug', 'quit'.\n";
  return 0;
}

int fail(const std::string& what) {
  std::cerr << "relievo-falcon-emulator: " << what << ": " << std::strerror(errno) << '\n';
  return 6;
}

/// Lines of input are the hand.
void followInput(SharedFalcon& falcon, std::stop_source& stop) {
  for (std::string line; std::getline(std::cin, line);) {
    double x = 0, y = 0, z = 0;
    int button = 0;
    falcon.with([&](FalconEmulator& f) {
      if (std::sscanf(line.c_str(), "%lf %lf %lf", &x, &y, &z) == 3) {
        f.body.carry({x, y, z});
      } else if (std::sscanf(line.c_str(), "button %d", &button) == 1 && button >= 0 &&
                 button < 4) {
        f.buttons |= 1 << button;
      } else if (line == "release") {
        f.buttons = 0;
      } else if (line == "unplug") {
        f.unplug();
      } else if (line == "replug") {
        f.powerCycle();
        f.plugIn();
      } else if (line != "quit") {
        std::cerr << "relievo-falcon-emulator: not understood: " << line << '\n';
      }
    });
    if (line == "quit") {
      stop.request_stop();
      return;
    }
  }
  // The end of the input is no end: a service has none.
}

/// @return 0: it is none
int portNumber(const std::string& text) {
  int port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  const bool good = error == std::errc() && end == text.data() + text.size();
  return good && port > 0 && port <= 65535 ? port : 0;
}

/// @return below 0: stopped, or failed as errno tells
int acceptUntil(const std::stop_token& stop, int server) {
  constexpr int kLookMs = 100;  // At the stop token.
  while (!stop.stop_requested()) {
    pollfd waiting{.fd = server, .events = POLLIN, .revents = 0};
    const int ready = poll(&waiting, 1, kLookMs);
    if (ready > 0) return accept4(server, nullptr, nullptr, SOCK_CLOEXEC);
    if (ready < 0 && errno != EINTR) return -1;
  }
  return -1;
}

int listenOn(int port) {
  const int server = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  setsockopt(server, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const bool bound = server >= 0 &&
                     bind(server, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
                     listen(server, 1) == 0;
  return bound ? server : -1;
}

}  // namespace

int main(int argc, char** argv) {
  EmulatorOptions options;
  int port = 3240;
  bool vhci = false;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--help") return help();
    if (option == "--loaded") {
      options.firmware_loaded = true;
    } else if (option == "--homed") {
      options.firmware_loaded = options.homed = true;
    } else if (option == "--vhci") {
      vhci = true;
    } else if (option == "--port" && i + 1 < argc) {
      port = portNumber(argv[++i]);
      if (port == 0) {
        std::cerr << "relievo-falcon-emulator: '" << argv[i]
                  << "' is no port; nothing is served. Give a number from 1 to 65535.\n";
        return 1;
      }
    } else {
      std::cerr << "relievo-falcon-emulator: '" << option << "' is not understood; see --help.\n";
      return 1;
    }
  }
  const auto falcon = std::make_shared<SharedFalcon>(options);
  std::stop_source stop;
  const int server = vhci ? -1 : listenOn(port);
  if (!vhci && server < 0) return fail("port " + std::to_string(port));
  std::thread input([&] { followInput(*falcon, stop); });
  if (!vhci)
    std::cout << "Serving on port " << port << "; usbip attach -r 127.0.0.1 -b 1-1" << std::endl;
  int result = 0;
  while (!stop.stop_requested() && result == 0) {
    if (!falcon->with([](FalconEmulator& f) { return f.plugged(); })) {
      usleep(50'000);
      continue;
    }
    const int connection =
        vhci ? relievo::emulator::attachToVhci() : acceptUntil(stop.get_token(), server);
    if (connection < 0 && stop.stop_requested()) break;
    if (connection < 0) {
      result =
          fail(vhci ? "the kernel's virtual port (is vhci-hcd loaded, are you root?)" : "accept");
      break;
    }
    const int yes = 1;
    setsockopt(connection, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    if (vhci) std::cout << "Attached.\n";
    UsbipServer(connection, falcon, !vhci).serve(stop.get_token());
  }
  std::cout.flush();
  if (result != 0) _exit(result);  // The other thread waits for a line that may never come.
  input.join();
  return 0;
}
