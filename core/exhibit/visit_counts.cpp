// SPDX-License-Identifier: BSD-3-Clause
#include "core/exhibit/visit_counts.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/failure.h"
#include "core/base/json_nesting.h"
#include "core/io/formats/text_file.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = 16U << 20U;
constexpr int kDeepest = 8;
constexpr double kTenth = 10;

fs::path fileIn(const fs::path& folder) {
  return folder / "counts.json";
}

/// @throw Error, nlohmann::json::exception
VisitCounts::Days daysIn(const fs::path& file) {
  const std::string text = readTextFile(file, kMostBytes);
  if (isNestedDeeper(text, kDeepest)) throw failure<MessageId::exhibit_none>(file.string());
  VisitCounts::Days days;
  const Json json = Json::parse(text);
  for (const auto& [day, objects] : json.at("days").items()) {
    for (const auto& [object, count] : objects.items()) {
      days[day][object] = {count.at("starts").get<std::int64_t>(),
                           count.at("touched_s").get<double>()};
    }
  }
  return days;
}

}  // namespace

VisitCounts::VisitCounts(fs::path folder) : folder_(std::move(folder)) {
  const fs::path file = fileIn(folder_);
  std::error_code unknown;
  if (!fs::exists(file, unknown)) return;
  try {
    days_ = daysIn(file);
  } catch (const std::exception&) {
    const fs::path aside = folder_ / "counts.damaged.json";
    fs::rename(file, aside, unknown);
    problem_ = said<MessageId::exhibit_records_damaged>(PathArgument(file), PathArgument(aside));
  }
}

void VisitCounts::start(const std::string& day, const std::string& object) {
  ++days_[day][object].starts;
  changed_ = true;
}

void VisitCounts::touch(const std::string& day, const std::string& object, double seconds) {
  if (!(seconds > 0)) return;
  days_[day][object].touched_s += seconds;
  changed_ = true;
}

void VisitCounts::save() {
  if (!changed_) return;
  while (days_.size() > kMostDays) days_.erase(days_.begin());
  Json days = Json::object();
  for (const auto& [day, objects] : days_) {
    for (const auto& [object, count] : objects) {
      days[day][object] = {{"starts", count.starts},
                           {"touched_s", std::round(kTenth * count.touched_s) / kTenth}};
    }
  }
  std::error_code unknown;  // Whoever writes into it says so.
  fs::create_directories(folder_, unknown);
  writeTextFile(fileIn(folder_),
                Json{{"relievo_exhibit_counts", 1}, {"days", days}}.dump(2) + "\n");
  changed_ = false;
}

}  // namespace relievo
