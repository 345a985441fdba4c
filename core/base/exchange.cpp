// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/exchange.h"

#include <algorithm>

namespace relievo {
namespace {

// The first byte of what is told.
constexpr char kGoesOn = 0, kStopped = 1;

}  // namespace

std::vector<std::string> Exchange::gathered(const std::string& mine) {
  std::vector<std::string> all = gather(mine);
  for (const std::string& one : all) {
    sent_bytes_ += one.size() * static_cast<std::uint64_t>(ranks_ - 1);
  }
  const auto first = std::find_if(all.begin(), all.end(),
                                  [](const std::string& one) { return one.front() == kStopped; });
  if (first != all.end()) {
    is_over_ = true;
    stopped_ = Stopped{.rank = static_cast<int>(first - all.begin()),
                       .exit_code = static_cast<unsigned char>(first->at(1)),
                       .sentence = first->substr(2)};
  }
  return all;
}

std::vector<std::string> Exchange::share(std::string_view mine) {
  std::vector<std::string> all = gathered(kGoesOn + std::string(mine));
  if (stopped_) throw OtherProcessStopped{};
  for (std::string& one : all) one.erase(0, 1);
  return all;
}

void Exchange::finish() {
  share({});
  is_over_ = true;
}

void Exchange::stop(int exit_code, const std::string& sentence) {
  if (is_over_) return;
  gathered(std::string{kStopped, static_cast<char>(exit_code)} + sentence);
}

}  // namespace relievo
