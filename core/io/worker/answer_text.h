// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include "core/cloud/scan.h"
#include "core/io/las/las_unit.h"

namespace relievo {

/// What a worker says beside its arrays, packed one after the other.
class Packer {
 public:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  void put(const std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::string bytes_;
};

/// The same on the other side, which believes nothing: what is not there makes it not good().
class Unpacker {
 public:
  explicit Unpacker(std::string bytes) : bytes_(std::move(bytes)) {}
  template <class T>
  T get() {
    T value{};
    take(&value, sizeof(T));
    return value;
  }
  std::string text();
  bool good() const noexcept { return good_; }

 private:
  void take(void* out, std::size_t bytes);

  std::string bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

void pack(const ScanInfo& info, Packer& packer);
void pack(const LasSystem& system, Packer& packer);
// @return  false if it makes no sense
bool unpack(Unpacker& unpacker, ScanInfo& info);
bool unpack(Unpacker& unpacker, LasSystem& system);

}  // namespace relievo
