// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/device_page.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace relievo::foreign {

namespace {
bool isWithin(double value, double least, double most) noexcept {
  return std::isfinite(value) && value >= least && value <= most;
}
}  // namespace

bool arePossible(const ForeignLimits& limits) noexcept {
  constexpr double kLeastExtentMm = 1, kMostExtentMm = 1000;
  constexpr double kMostStatedN = 1000, kMostStatedNPerMm = 1000, kMostStepMm = 10;
  constexpr double kMostDelayMs = 100, kLeastRateHz = 500, kMostRateHz = 4000;
  const bool reach =
      std::all_of(limits.half_extent_mm.begin(), limits.half_extent_mm.end(),
                  [](double extent) { return isWithin(extent, kLeastExtentMm, kMostExtentMm); });
  return reach && isWithin(limits.max_force_n, 0, kMostStatedN) &&
         isWithin(limits.continuous_force_n, 0, kMostStatedN) &&
         isWithin(limits.max_stiffness_n_per_mm, 0, kMostStatedNPerMm) &&
         isWithin(limits.position_step_mm, 0, kMostStepMm) &&
         isWithin(limits.force_delay_ms, 0, kMostDelayMs) &&
         isWithin(limits.rate_hz, kLeastRateHz, kMostRateHz);
}

ForceRules rulesOf(const ForeignLimits& limits) noexcept {
  const double most = limits.own_watchdog != 0 ? kMostForceN : kMostForceWithoutWatchdogN;
  return {.max_force_n = std::min(most, limits.max_force_n)};
}

HeatRules heatRulesOf(const ForeignLimits& limits) noexcept {
  const double most_n = rulesOf(limits).max_force_n;
  constexpr double kUnknownPart = 0.5;
  const bool known = limits.continuous_force_n > 0;
  return {.max_force_n = most_n,
          .continuous_force_n = known ? limits.continuous_force_n : kUnknownPart * most_n};
}

void putText(std::string_view text, HostReport& report) noexcept {
  report.text.fill('\0');
  text.copy(report.text.data(), report.text.size() - 1);
}

std::string textOf(const HostReport& report) {
  std::string text;
  for (const char c : report.text) {
    if (c == '\0') break;
    const auto byte = static_cast<unsigned char>(c);
    text += byte < 32 || byte == 127 ? ' ' : c;
  }
  return text;
}

MappedPage::~MappedPage() {
  if (page_ != nullptr) ::munmap(page_, sizeof(DevicePage));
}

bool MappedPage::map() noexcept {
  void* const memory =
      ::mmap(nullptr, sizeof(DevicePage), PROT_READ | PROT_WRITE, MAP_SHARED, fd_.get(), 0);
  if (memory == MAP_FAILED) return false;
  page_ = static_cast<DevicePage*>(memory);
  return true;
}

bool MappedPage::create() noexcept {
  fd_ = OwnedFd(::memfd_create("relievo-device", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (fd_.get() < 0 || ::ftruncate(fd_.get(), sizeof(DevicePage)) != 0) return false;
  // A page that its other user made smaller would end us by SIGBUS.
  if (::fcntl(fd_.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0) return false;
  if (!map()) return false;
  new (page_) DevicePage;
  // The loop must not wait for it to be paged in; a refusal is no error (requestRealtime).
  ::mlock(page_, sizeof(DevicePage));
  return true;
}

bool MappedPage::open(int fd) noexcept {
  struct stat facts {};
  if (::fstat(fd, &facts) != 0 || facts.st_size != sizeof(DevicePage)) return false;
  fd_ = OwnedFd(fd);
  return map() && page_->magic == DevicePage::kMagic && page_->version == DevicePage::kVersion;
}

}  // namespace relievo::foreign
