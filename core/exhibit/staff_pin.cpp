// SPDX-License-Identifier: BSD-3-Clause
#include "core/exhibit/staff_pin.h"

#include <algorithm>
#include <random>

#include "core/hash/sha256.h"

namespace relievo {
namespace {

bool isDigit(char c) noexcept {
  return c >= '0' && c <= '9';
}

}  // namespace

bool isPin(std::string_view digits) noexcept {
  return digits.size() >= kFewestPinDigits && digits.size() <= kMostPinDigits &&
         std::all_of(digits.begin(), digits.end(), isDigit);
}

StaffPin newStaffPin(std::string_view digits) {
  constexpr int kSaltLetters = 16;
  constexpr std::string_view kLetters = "0123456789abcdef";
  std::random_device random;
  std::string salt;
  for (int i = 0; i < kSaltLetters; ++i) salt += kLetters[random() % kLetters.size()];
  return staffPinOf(digits, salt);
}

StaffPin staffPinOf(std::string_view digits, std::string_view salt) {
  return {std::string(salt), sha256OfText(std::string(salt) + ":" + std::string(digits))};
}

void StaffLock::digit(char digit, double now_s) {
  if (waitsS(now_s) > 0 || !isDigit(digit) || digits_.size() >= kMostPinDigits) return;
  digits_ += digit;
}

void StaffLock::erase() {
  if (!digits_.empty()) digits_.pop_back();
}

StaffLock::Answer StaffLock::enter(double now_s) {
  const std::string digits = std::move(digits_);
  digits_.clear();
  if (waitsS(now_s) > 0) return Answer::waits;
  if (isPin(digits) && staffPinOf(digits, pin_.salt).sha256 == pin_.sha256) {
    tries_left_ = kTries;
    return Answer::open;
  }
  if (--tries_left_ > 0) return Answer::wrong;
  tries_left_ = kTries;
  closed_until_s_ = now_s + kWaitS;
  return Answer::waits;
}

double StaffLock::waitsS(double now_s) const noexcept {
  return std::max(0.0, closed_until_s_ - now_s);
}

}  // namespace relievo
