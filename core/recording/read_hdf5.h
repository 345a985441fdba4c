// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

#include "core/base/task.h"
#include "core/recording/log_check.h"
#include "core/recording/log_table.h"

// What reading CSV and HDF5 logs have in common, and the latter.
namespace relievo {

/// @return false: the member of the column cannot have this value, or the use has no place for it
bool takeValue(const LogColumn& column, LogUse use, TouchRow& row, double value);

/// @param number  of the row, from 1
FileError badRow(const std::filesystem::path& file, std::size_t number);

/// See readLog. @throw FileError, Cancelled
LogTable readHdf5Log(const std::filesystem::path& file, LogUse use, const Task& task);

/// See checkLog. @throw FileError, Cancelled
LogCheck checkHdf5Log(const std::filesystem::path& file, const Task& task = {});

}  // namespace relievo
