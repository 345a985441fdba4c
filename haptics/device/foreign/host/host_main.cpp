// SPDX-License-Identifier: BSD-3-Clause
// relievo-device-host: loads one plug-in for haptic devices. Only relievo starts it.
//   drive FILE ID                         runs a device over the page at descriptor 3
//   scan FILE                             tells its devices on descriptor 3
//   check FILE CODE ID SECONDS            runs one test, and tells its verdict on descriptor 3
// Descriptor 4 ends with relievo; descriptor 5 is what is loaded, and FILE says where it was.
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <charconv>
#include <csignal>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "haptics/device/foreign/host/check.h"
#include "haptics/device/foreign/host/drive.h"
#include "haptics/device/foreign/host/loaded_plugin.h"

namespace relievo::foreign {
namespace {

constexpr int kUsageExit = 2, kAloneExit = 4;

/// One field of a line: what would end it becomes a space.
std::string field(std::string_view text) {
  std::string shown;
  for (const char c : text.substr(0, 200)) {
    shown += static_cast<unsigned char>(c) < 32 || c == 127 ? ' ' : c;
  }
  return shown;
}

int scan(const std::string& file) {
  LoadedPlugin plugin;
  Trouble trouble = plugin.load(file);
  if (trouble.what == HostTrouble::none) trouble = plugin.begin();
  std::string told;
  if (trouble.what != HostTrouble::none) {
    told = "trouble\t" + std::to_string(static_cast<int>(trouble.what)) + "\t" +
           std::to_string(trouble.number) + "\t" + field(trouble.text) + "\n";
  } else {
    const relievo_device_entry_t& entry = plugin.entry();
    told = "plugin\t" + field(entry.name) + "\t" + field(entry.version) + "\t" +
           field(entry.maker) + "\t" + field(entry.licence) + "\n";
    for (const relievo_device_name& name : plugin.scan()) {
      if (isId(name.id)) told += "device\t" + std::string(name.id) + "\t" + field(name.name) + "\n";
    }
  }
  return ::write(kAnswerFd, told.data(), told.size()) > 0 ? 0 : kUsageExit;
}

double numberOf(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Where no guard runs: a hanging plug-in must not outlive relievo.
void endWithRelievo() {
  std::thread([] {
    pollfd life{.fd = kLifeFd, .events = POLLIN, .revents = 0};
    while (::poll(&life, 1, -1) < 0) {
    }
    ::_exit(kAloneExit);
  }).detach();
}

int run(const std::vector<std::string>& words) {
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return kUsageExit;
  ::close_range(kPluginFd + 1, ~0U, 0);
  // Ours alone: a program that a plug-in starts has none of them.
  for (const int own : {kPageFd, kLifeFd, kPluginFd}) ::fcntl(own, F_SETFD, FD_CLOEXEC);
  // A line that the plug-in writes to a terminal or a pipe that is gone is no reason to end or stop
  // with a force on.
  for (const int signal : {SIGPIPE, SIGTTOU, SIGTTIN, SIGTSTP}) ::signal(signal, SIG_IGN);
  if (words.size() == 3 && words[0] == "drive") return drive(words[1], words[2]);
  endWithRelievo();
  if (words.size() == 2 && words[0] == "scan") return scan(words[1]);
  if (words.size() == 5 && words[0] == "check") {
    return check({words[1], words[2], words[3], numberOf(words[4])});
  }
  return kUsageExit;
}

}  // namespace
}  // namespace relievo::foreign

int main(int count, char** words) {
  if (count < 2) return 2;
  return relievo::foreign::run({words + 1, words + count});
}
