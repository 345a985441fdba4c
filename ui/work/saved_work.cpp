// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/saved_work.h"

#include "ui/work/document.h"

namespace relievo {

void SavedWork::noteSaved(const QString& project_file) {
  project_file_ = project_file;
  saved_ = workIn(document_.project(), !project_file_.isEmpty());
  is_in_no_file_ = false;
}

void SavedWork::clear() {
  project_file_.clear();
  saved_.reset();
  is_in_no_file_ = false;
}

bool SavedWork::hasUnsaved() const {
  // While the first file is being opened nothing has been noted yet, and there is no work.
  if (!document_.isOpen() || !saved_) return false;
  return is_in_no_file_ || !(workIn(document_.project(), !project_file_.isEmpty()) == *saved_);
}

}  // namespace relievo
