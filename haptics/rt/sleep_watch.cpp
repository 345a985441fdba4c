// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/rt/sleep_watch.h"

#include <dbus/dbus.h>
#include <unistd.h>

namespace relievo {

namespace {
constexpr const char* kName = "org.freedesktop.login1";
constexpr const char* kPath = "/org/freedesktop/login1";
constexpr const char* kManager = "org.freedesktop.login1.Manager";
}  // namespace

struct SleepWatch::Impl {
  DBusConnection* bus = nullptr;
  dbus_uint32_t asked = 0;  // Serial of the question under way; 0: none.
  int lock = -1;            // As long as it is open, sleep waits.
  std::string note;

  Impl() {
    DBusError error{};
    dbus_error_init(&error);
    bus = dbus_bus_get_private(DBUS_BUS_SYSTEM, &error);
    if (bus == nullptr) {
      note = error.message != nullptr ? error.message : "there is no system bus";
      dbus_error_free(&error);
      return;
    }
    dbus_connection_set_exit_on_disconnect(bus, FALSE);
    // Without an error to fill it does not wait for the bus.
    dbus_bus_add_match(bus,
                       "type='signal',sender='org.freedesktop.login1',"
                       "interface='org.freedesktop.login1.Manager',member='PrepareForSleep'",
                       nullptr);
    askForDelay();
  }
  ~Impl() {
    unlock();
    if (bus == nullptr) return;
    dbus_connection_close(bus);
    dbus_connection_unref(bus);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void unlock() {
    if (lock >= 0) close(lock);
    lock = -1;
  }

  void askForDelay() {
    DBusMessage* call = dbus_message_new_method_call(kName, kPath, kManager, "Inhibit");
    if (call == nullptr) return;
    const char* what = "sleep";
    const char* who = "relievo";
    const char* why = "The haptic device's motors go to zero force first.";
    const char* mode = "delay";
    if (dbus_message_append_args(call, DBUS_TYPE_STRING, &what, DBUS_TYPE_STRING, &who,
                                 DBUS_TYPE_STRING, &why, DBUS_TYPE_STRING, &mode,
                                 DBUS_TYPE_INVALID) != FALSE) {
      dbus_connection_send(bus, call, &asked);
      dbus_connection_flush(bus);
    }
    dbus_message_unref(call);
  }

  void takeAnswer(DBusMessage* answer) {
    asked = 0;
    int descriptor = -1;
    if (dbus_message_get_type(answer) == DBUS_MESSAGE_TYPE_METHOD_RETURN &&
        dbus_message_get_args(answer, nullptr, DBUS_TYPE_UNIX_FD, &descriptor, DBUS_TYPE_INVALID) !=
            FALSE) {
      unlock();
      lock = descriptor;
      note.clear();
      return;
    }
    const char* words = nullptr;
    dbus_message_get_args(answer, nullptr, DBUS_TYPE_STRING, &words, DBUS_TYPE_INVALID);
    note = words != nullptr ? words : "logind refuses";
  }

  News take(DBusMessage* message) {
    if (asked != 0 && dbus_message_get_reply_serial(message) == asked) {
      takeAnswer(message);
      return News::none;
    }
    dbus_bool_t begins = FALSE;
    if (dbus_message_is_signal(message, kManager, "PrepareForSleep") == FALSE ||
        dbus_message_get_args(message, nullptr, DBUS_TYPE_BOOLEAN, &begins, DBUS_TYPE_INVALID) ==
            FALSE) {
      return News::none;
    }
    if (begins != FALSE) return News::about_to_sleep;
    askForDelay();  // For the next time.
    return News::woken;
  }
};

SleepWatch::SleepWatch() : impl_(std::make_unique<Impl>()) {}

SleepWatch::~SleepWatch() = default;

SleepWatch::News SleepWatch::poll() {
  if (impl_->bus == nullptr) return News::none;
  dbus_connection_read_write(impl_->bus, 0);
  News news = News::none;
  while (news == News::none) {
    DBusMessage* message = dbus_connection_pop_message(impl_->bus);
    if (message == nullptr) break;
    news = impl_->take(message);
    dbus_message_unref(message);
  }
  return news;
}

bool SleepWatch::delays() const {
  return impl_->lock >= 0;
}

void SleepWatch::letSleep() {
  impl_->unlock();
}

const std::string& SleepWatch::note() const {
  return impl_->note;
}

}  // namespace relievo
