// SPDX-License-Identifier: BSD-3-Clause
#include "core/exhibit/rotating_log.h"

#include <ctime>
#include <fstream>
#include <utility>

#include "core/provenance/name_text.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

fs::path numbered(const fs::path& file, int number) {
  fs::path name = file;
  return name += "." + std::to_string(number);
}

std::string formatted(const char* form, const std::tm& time) {
  std::string text(32, '\0');
  text.resize(std::strftime(text.data(), text.size(), form, &time));
  return text;
}

}  // namespace

RotatingLog::RotatingLog(fs::path file, Limits limits) : file_(std::move(file)), limits_(limits) {}

void RotatingLog::rotate() const {
  std::error_code unknown;
  if (fs::file_size(file_, unknown) < limits_.bytes || unknown) return;
  fs::remove(numbered(file_, limits_.kept), unknown);
  for (int n = limits_.kept; n > 1; --n) {
    fs::rename(numbered(file_, n - 1), numbered(file_, n), unknown);
  }
  fs::rename(file_, numbered(file_, 1), unknown);
}

bool RotatingLog::write(const std::string& time, const std::string& words) {
  std::error_code unknown;
  fs::create_directories(file_.parent_path(), unknown);
  rotate();
  std::ofstream out(file_, std::ios::app | std::ios::binary);
  out << time << ' ' << escapedName(words) << '\n';
  return static_cast<bool>(out.flush());
}

std::string utcNow() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  return gmtime_r(&now, &parts) == nullptr ? std::string() : formatted("%Y-%m-%dT%H:%M:%SZ", parts);
}

std::string localDay() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  return localtime_r(&now, &parts) == nullptr ? std::string() : formatted("%Y-%m-%d", parts);
}

}  // namespace relievo
