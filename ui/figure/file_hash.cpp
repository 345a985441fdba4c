// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/file_hash.h"

#include <QCryptographicHash>
#include <QFile>

namespace relievo {

std::string sha256Of(const std::filesystem::path& path, const Task& task) {
  constexpr qint64 kBlock = 4 << 20;
  QFile file(QFile::decodeName(path.c_str()));
  if (!file.open(QIODevice::ReadOnly)) return {};
  QCryptographicHash hash(QCryptographicHash::Sha256);
  while (!file.atEnd()) {
    task.check();
    hash.addData(file.read(kBlock));
  }
  return hash.result().toHex().toStdString();
}

}  // namespace relievo
