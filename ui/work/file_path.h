// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <QString>

#include "ui/work/file_names.h"

namespace relievo {

/// The very file that a path of Qt names, every byte of it.
inline std::filesystem::path pathOf(const QString& file) {
  return bytesOfPath(file);
}

}  // namespace relievo
