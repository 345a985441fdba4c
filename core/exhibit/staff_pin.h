// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace relievo {

/// What is kept of the number that ends an exhibit: a checksum. It keeps hands off the settings; a
/// number of a few digits can be found by trying all, so the file is for the staff's eyes alone.
struct StaffPin {
  std::string salt;    ///< 1 to 64 characters.
  std::string sha256;  ///< Of salt, ':' and the digits: 64 hexadecimal digits.
};

inline constexpr std::size_t kFewestPinDigits = 4, kMostPinDigits = 12;

/// 4 to 12 digits.
bool isPin(std::string_view digits) noexcept;

/// @pre isPin(digits)
StaffPin staffPinOf(std::string_view digits, std::string_view salt);
/// The same with a new salt by chance. @pre isPin(digits)
StaffPin newStaffPin(std::string_view digits);

/// The entry of the number: digits one by one, five tries, then a minute without any. Time is an
/// argument. [one thread]
class StaffLock {
 public:
  static constexpr int kTries = 5;
  static constexpr double kWaitS = 60;

  explicit StaffLock(StaffPin pin) : pin_(std::move(pin)) {}

  enum class Answer { open, wrong, waits };
  /// Ignored while it waits, and beyond the longest number.
  void digit(char digit, double now_s);
  void erase();
  void clear() { digits_.clear(); }
  /// Tries what was entered, which is then forgotten.
  Answer enter(double now_s);

  std::size_t entered() const noexcept { return digits_.size(); }
  int triesLeft() const noexcept { return tries_left_; }
  /// 0: a number can be entered.
  double waitsS(double now_s) const noexcept;

 private:
  StaffPin pin_;
  std::string digits_;
  int tries_left_ = kTries;
  double closed_until_s_ = 0;
};

}  // namespace relievo
