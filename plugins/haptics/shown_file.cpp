// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/shown_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "core/provenance/name_text.h"

namespace relievo {
namespace {

QString escaped(const QString& name) {
  return QString::fromStdString(escapedName(QFile::encodeName(name).toStdString()));
}

}  // namespace

QString shownFileName(const QString& path) {
  return escaped(QFileInfo(path).fileName());
}

QString shownFilePath(const QString& path) {
  return escaped(QDir::toNativeSeparators(path));
}

}  // namespace relievo
