// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace relievo::dhd {

/// What is needed of Force Dimension's library libdhd, version 3: what it must have, and what it
/// may have. Types and meanings as its documentation has them; nothing of it is copied or shipped
/// (docs/adr/0180). Lengths are metres, forces newtons; an id of -1 is the current device and is
/// never used. Functions return 0 or a positive number, or a negative one after a failure.
struct DhdLibrary {
  int (*device_count)() = nullptr;
  int (*open_id)(char) = nullptr;  ///< @return the id
  int (*close)(char) = nullptr;
  int (*system_type)(char) = nullptr;
  const char* (*system_name)(char) = nullptr;
  int (*position)(double*, double*, double*, char) = nullptr;
  int (*set_force)(double, double, double, char) = nullptr;
  unsigned int (*button_mask)(char) = nullptr;
  int (*status)(int*, char) = nullptr;  ///< Writes 17 numbers.
  int (*last_error)() = nullptr;        ///< Of the calling thread.
  const char* (*last_error_text)() = nullptr;
  int (*enable_force)(unsigned char, char) = nullptr;
  int (*set_gravity_compensation)(int, char) = nullptr;

  // May be missing.
  int (*open_serial)(int) = nullptr;
  int (*enable_expert_mode)() = nullptr;
  int (*set_watchdog)(unsigned char, char) = nullptr;  ///< Units of 125 us.
  int (*set_max_force)(double, char) = nullptr;

  std::string file;     ///< Which one it is.
  std::string problem;  ///< Why there is none; empty: it is there.
};

/// Where it is looked for, in this order: what `setting` names, an absolute path, and then nowhere
/// else; where the system finds libraries; the two folders that people copy it to.
/// @param home  the user's folder; empty: unknown
std::vector<std::string> libraryPlaces(const std::string& setting, const std::string& home);

/// The first that can be loaded. One that lacks a function counts as none, and is named. It stays
/// loaded. [one thread, before any device]
DhdLibrary loadLibrary(const std::string& setting, const std::string& home);

}  // namespace relievo::dhd
