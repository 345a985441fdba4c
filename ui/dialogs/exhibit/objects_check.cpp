// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/exhibit/objects_check.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/project/openable.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

/// Nothing: there is no such file, which the exhibit's own check says.
std::optional<fs::file_time_type> writtenAt(const fs::path& file) {
  std::error_code unknown;
  if (!fs::is_regular_file(file, unknown)) return std::nullopt;
  const fs::file_time_type time = fs::last_write_time(file, unknown);
  return unknown ? std::nullopt : std::optional(time);
}

}  // namespace

ObjectsCheck::ObjectsCheck(QObject* parent) : QObject(parent) {}

void ObjectsCheck::look(const std::vector<ExhibitObject>& objects) {
  files_.clear();
  for (const ExhibitObject& object : objects) files_.push_back(object.file);
  const bool is_wanted = std::count(files_.begin(), files_.end(), under_way_) > 0;
  if (worker_.busy() && !is_wanted) worker_.cancel();
  if (!worker_.busy()) lookAtNext();
}

void ObjectsCheck::lookAtNext() {
  for (const fs::path& file : files_) {
    const auto written = writtenAt(file);
    const auto known = known_.find(file);
    if (!written || (known != known_.end() && known->second.written == *written)) continue;
    under_way_ = file;
    auto refusal = std::make_shared<std::optional<Message>>();
    worker_.start([file, refusal](const Task& task) { *refusal = openingRefusal(file, task); },
                  [this, file, refusal, time = *written] {
                    known_[file] = {time, std::move(*refusal)};
                    lookAtNext();
                    Q_EMIT looked();
                  });
    return;
  }
}

std::optional<Message> ObjectsCheck::refusalOf(const fs::path& file) const {
  const auto known = known_.find(file);
  return known == known_.end() ? std::nullopt : known->second.refusal;
}

}  // namespace relievo
