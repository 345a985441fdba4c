// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dbus/dbus.h>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <mutex>
#include <string>

#include "tests/realtime/bus_service.h"

namespace relievo::test {

/// logind as far as a program that delays sleep meets it: hands out delay locks, tells of sleep.
class FakeLogind {
 public:
  explicit FakeLogind(const std::string& address, bool grants = true)
      : grants_(grants),
        service_(
            address, "org.freedesktop.login1",
            [this](BusService& service, DBusMessage* message) {
              if (dbus_message_is_method_call(message, "org.freedesktop.login1.Manager",
                                              "Inhibit") != FALSE) {
                answer(service, message);
              }
            },
            [this](BusService& service) {
              if (tell_.exchange(false)) signalSleep(service);
            }) {}
  ~FakeLogind() {
    const std::lock_guard guard(mutex_);
    if (lock_ >= 0) close(lock_);
    lock_ = -1;
  }
  FakeLogind(const FakeLogind&) = delete;
  FakeLogind& operator=(const FakeLogind&) = delete;

  void tell(bool sleeps) {
    sleeps_ = sleeps;
    tell_ = true;
  }
  /// Somebody holds a delay lock: the computer would not sleep yet.
  bool isDelayed() {
    const std::lock_guard guard(mutex_);
    if (lock_ < 0) return false;
    pollfd end{.fd = lock_, .events = 0, .revents = 0};
    return poll(&end, 1, 0) == 0;  // Hung up once the last other end is closed.
  }
  int locksGiven() const { return locks_given_; }
  std::string askedFor() {
    const std::lock_guard guard(mutex_);
    return asked_for_;
  }

 private:
  void answer(BusService& service, DBusMessage* call) {
    std::array<const char*, 4> texts{};  // What, who, why, mode.
    dbus_message_get_args(call, nullptr, DBUS_TYPE_STRING, &texts[0], DBUS_TYPE_STRING, &texts[1],
                          DBUS_TYPE_STRING, &texts[2], DBUS_TYPE_STRING, &texts[3],
                          DBUS_TYPE_INVALID);
    if (!grants_) {
      service.refuse(call);
      return;
    }
    std::array<int, 2> ends{-1, -1};
    EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    DBusMessage* reply = dbus_message_new_method_return(call);
    dbus_message_append_args(reply, DBUS_TYPE_UNIX_FD, &ends[1], DBUS_TYPE_INVALID);
    close(ends[1]);  // The message has a copy.
    {
      const std::lock_guard guard(mutex_);
      if (lock_ >= 0) close(lock_);
      lock_ = ends[0];
      asked_for_ = std::string(texts[0]) + ", " + texts[3];
      ++locks_given_;
    }
    service.send(reply);
  }
  void signalSleep(BusService& service) {
    DBusMessage* message = dbus_message_new_signal(
        "/org/freedesktop/login1", "org.freedesktop.login1.Manager", "PrepareForSleep");
    const dbus_bool_t begins = sleeps_ ? TRUE : FALSE;
    dbus_message_append_args(message, DBUS_TYPE_BOOLEAN, &begins, DBUS_TYPE_INVALID);
    service.send(message);
  }

  const bool grants_;
  std::atomic<bool> tell_{false}, sleeps_{false};
  std::atomic<int> locks_given_{0};
  std::mutex mutex_;
  int lock_ = -1;
  std::string asked_for_;
  BusService service_;  // Last: its thread uses the others.
};

}  // namespace relievo::test
