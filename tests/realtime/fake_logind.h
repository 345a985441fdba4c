// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dbus/dbus.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <mutex>
#include <string>
#include <thread>

namespace relievo::test {

/// logind as far as a program that delays sleep meets it: hands out delay locks, tells of sleep.
class FakeLogind {
 public:
  explicit FakeLogind(const std::string& address, bool grants = true) : grants_(grants) {
    connection_ = dbus_connection_open_private(address.c_str(), nullptr);
    EXPECT_NE(connection_, nullptr);
    EXPECT_TRUE(dbus_bus_register(connection_, nullptr));
    EXPECT_EQ(dbus_bus_request_name(connection_, "org.freedesktop.login1", 0, nullptr),
              DBUS_REQUEST_NAME_REPLY_PRIMARY_OWNER);
    thread_ = std::thread([this] { serve(); });
  }
  ~FakeLogind() {
    stopping_ = true;
    thread_.join();
    if (lock_ >= 0) close(lock_);
    dbus_connection_close(connection_);
    dbus_connection_unref(connection_);
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
  void serve() {
    while (!stopping_) {
      dbus_connection_read_write(connection_, 10);
      while (DBusMessage* message = dbus_connection_pop_message(connection_)) {
        if (dbus_message_is_method_call(message, "org.freedesktop.login1.Manager", "Inhibit") !=
            FALSE) {
          answer(message);
        }
        dbus_message_unref(message);
      }
      if (tell_.exchange(false)) signalSleep();
    }
  }
  void answer(DBusMessage* call) {
    std::array<const char*, 4> texts{};  // What, who, why, mode.
    dbus_message_get_args(call, nullptr, DBUS_TYPE_STRING, &texts[0], DBUS_TYPE_STRING, &texts[1],
                          DBUS_TYPE_STRING, &texts[2], DBUS_TYPE_STRING, &texts[3],
                          DBUS_TYPE_INVALID);
    DBusMessage* reply = nullptr;
    if (grants_) {
      std::array<int, 2> ends{-1, -1};
      EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
      reply = dbus_message_new_method_return(call);
      dbus_message_append_args(reply, DBUS_TYPE_UNIX_FD, &ends[1], DBUS_TYPE_INVALID);
      close(ends[1]);  // The message has a copy.
      const std::lock_guard guard(mutex_);
      if (lock_ >= 0) close(lock_);
      lock_ = ends[0];
      asked_for_ = std::string(texts[0]) + ", " + texts[3];
      ++locks_given_;
    } else {
      reply = dbus_message_new_error(call, DBUS_ERROR_ACCESS_DENIED, "not for you");
    }
    dbus_connection_send(connection_, reply, nullptr);
    dbus_connection_flush(connection_);
    dbus_message_unref(reply);
  }
  void signalSleep() {
    DBusMessage* message = dbus_message_new_signal(
        "/org/freedesktop/login1", "org.freedesktop.login1.Manager", "PrepareForSleep");
    const dbus_bool_t begins = sleeps_ ? TRUE : FALSE;
    dbus_message_append_args(message, DBUS_TYPE_BOOLEAN, &begins, DBUS_TYPE_INVALID);
    dbus_connection_send(connection_, message, nullptr);
    dbus_connection_flush(connection_);
    dbus_message_unref(message);
  }

  const bool grants_;
  DBusConnection* connection_ = nullptr;
  std::atomic<bool> stopping_{false}, tell_{false}, sleeps_{false};
  std::atomic<int> locks_given_{0};
  std::mutex mutex_;
  int lock_ = -1;
  std::string asked_for_;
  std::thread thread_;
};

}  // namespace relievo::test
