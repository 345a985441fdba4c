// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/read_scans.h"

#include <algorithm>
#include <QFile>

#include "ui/work/file_names.h"

namespace relievo {
namespace {

/// What was read of a file does not depend on its unit, nor on whether it is used.
bool sameRead(const PrepareInput& a, const PrepareInput& b) {
  return a.file == b.file && a.read == b.read && a.accept_incomplete == b.accept_incomplete;
}

}  // namespace

void ReadScans::add(const PrepareInput& input, std::shared_ptr<const ReadScan> scan) {
  scans_.emplace_back(input, std::move(scan));
}

std::shared_ptr<const ReadScan> ReadScans::held(const PrepareInput& input) const {
  const auto found = std::find_if(scans_.begin(), scans_.end(),
                                  [&](const auto& known) { return sameRead(known.first, input); });
  return found == scans_.end() ? nullptr : found->second;
}

LengthUnit ReadScans::unitOf(const PrepareInput& input) const {
  if (input.unit) return *input.unit;
  const ReadScan* const read = find(input);
  return read != nullptr ? read->scan->info.unit.value_or(LengthUnit::mm) : LengthUnit::mm;
}

QString ReadScans::nameOf(const PrepareInput& input) const {
  const QString file = shownName(QFile::decodeName(input.file.c_str()));
  if (input.read.parts.size() != 1) return file;
  const ReadScan* const read = find(input);
  const bool named = read != nullptr && read->scan->info.parts.size() == 1 &&
                     !read->scan->info.parts[0].name.empty();
  return QStringLiteral("%1 / %2").arg(
      file, named ? QString::fromStdString(read->scan->info.parts[0].name)
                  : QString::number(input.read.parts[0]));
}

}  // namespace relievo
