// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>
#include <sys/types.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace relievo::test {

/// A system bus of the test's own. libdbus reads its address once per process: make one for all.
class MessageBus {
 public:
  MessageBus() {
    // Its number comes first, so that this one process can be ended.
    pipe_ = ::popen(
        "sh -c 'echo $$; exec dbus-daemon --session --nofork --print-address=1 2>/dev/null'", "r");
    std::array<char, 512> line{};
    if (std::fgets(line.data(), line.size(), pipe_) != nullptr) process_ = std::atoi(line.data());
    if (std::fgets(line.data(), line.size(), pipe_) != nullptr) address_ = line.data();
    while (!address_.empty() && address_.back() == '\n') address_.pop_back();
    ::setenv("DBUS_SYSTEM_BUS_ADDRESS", address_.c_str(), 1);
  }
  ~MessageBus() {
    if (process_ > 1) ::kill(process_, SIGTERM);
    ::pclose(pipe_);
    ::unsetenv("DBUS_SYSTEM_BUS_ADDRESS");
  }
  MessageBus(const MessageBus&) = delete;
  MessageBus& operator=(const MessageBus&) = delete;
  const std::string& address() const { return address_; }

 private:
  std::FILE* pipe_ = nullptr;
  pid_t process_ = 0;
  std::string address_;
};

}  // namespace relievo::test
