// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hdf5.h>

#include <array>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/recording/event_row.h"

// What writing and reading HDF5 logs have in common.
namespace relievo::hdf5 {

/// The library serves one thread at a time.
inline std::mutex& library() {
  static std::mutex one;
  return one;
}

[[noreturn]] void throwRefused();  ///< @throw WriteError
/// @throw WriteError  a call of the library failed
void require(herr_t status);

/// An HDF5 identifier and what closes it.
class Id {
 public:
  Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id_ < 0) throwRefused();
  }
  ~Id() {
    if (id_ >= 0) close_(id_);
  }
  Id(Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  Id& operator=(Id&&) = delete;
  operator hid_t() const {
    return id_;
  }  // NOLINT(google-explicit-constructor): the library's type.

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

inline Id textType(std::size_t bytes) {
  Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type, bytes));
  require(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

inline constexpr const char* kStateSet = "relievo:state";  // As in the CSV's comment.
inline constexpr const char* kEventsSet = "events";
inline constexpr const char* kLinesSet = "lines";  // Of keep().
inline constexpr std::size_t kLineBytes = 128;
using KeptLine = std::array<char, kLineBytes>;

inline Id eventType() {
  Id type(H5Tcreate(H5T_COMPOUND, sizeof(EventRow)), H5Tclose);
  const Id text = textType(sizeof(EventRow::text));
  require(H5Tinsert(type, "time_s", HOFFSET(EventRow, time_s), H5T_NATIVE_DOUBLE));
  require(H5Tinsert(type, "tick", HOFFSET(EventRow, tick), H5T_NATIVE_DOUBLE));
  require(H5Tinsert(type, "text", HOFFSET(EventRow, text), text));
  return type;
}

/// Of each block a line of core/recording/log_checksum.h, whose count is that of rows, events and
/// lines so far; of the first, of what stands before the rows, all 0.
inline constexpr const char* kChecksumsSet = "checksums";
inline constexpr std::string_view kNothingYet = "0 0 0";

template <class T>
void appendBytes(std::string& to, const T* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  to.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

/// What the first checksum covers: texts in order, each behind its length, then the surface.
inline void appendText(std::string& to, std::string_view text) {
  to.append(std::to_string(text.size())).append("\n").append(text);
}

}  // namespace relievo::hdf5
