// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace relievo {

/// Tells that the computer is about to sleep, and delays it until the motors are at zero: logind's
/// delay lock, over D-Bus. logind waits for five seconds at most. Without logind nothing is told,
/// and note() says so. Never waits once it is made. [one thread]
class SleepWatch {
 public:
  enum class News : std::uint8_t { none, about_to_sleep, woken };

  SleepWatch();
  ~SleepWatch();  ///< Delays no longer.
  SleepWatch(const SleepWatch&) = delete;
  SleepWatch& operator=(const SleepWatch&) = delete;

  News poll();                      ///< What came first since the last call.
  bool delays() const;              ///< The computer would wait for us now.
  void letSleep();                  ///< All is at zero.
  const std::string& note() const;  ///< Why nothing is told; empty: it is.

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
