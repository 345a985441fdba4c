// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace relievo {

// Values as they lie in memory, for files and processes of one program on machines of one kind.

template <class T>
std::string_view plainBytes(const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}
template <class T>
std::string_view plainBytes(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Takes values from the beginning of bytes; what is too short gives nothing.
class PlainBytes {
 public:
  explicit PlainBytes(std::string_view bytes) : rest_(bytes) {}

  template <class T>
  bool take(T& value) {
    return takeBytes(&value, sizeof(T));
  }
  template <class T>
  bool take(std::vector<T>& values, std::size_t count) {
    if (rest_.size() / sizeof(T) < count) return false;
    values.resize(count);
    return takeBytes(values.data(), count * sizeof(T));
  }
  bool take(std::string& text, std::size_t count) {
    if (rest_.size() < count) return false;
    text = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return true;
  }
  std::string_view rest() const { return rest_; }

 private:
  bool takeBytes(void* to, std::size_t bytes) {
    if (rest_.size() < bytes) return false;
    if (bytes > 0) std::memcpy(to, rest_.data(), bytes);
    rest_.remove_prefix(bytes);
    return true;
  }
  std::string_view rest_;
};

}  // namespace relievo
