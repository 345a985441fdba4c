// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/message/message.h"

namespace relievo {

/// "Cannot write FILE: <why>. It was left as it is."
struct NotReplaceable : WriteError {
  NotReplaceable(const std::filesystem::path& file, const Message& because);
  Message why;  ///< For whoever says it in a sentence of his own.
};

/// Whoever writes a file beside its place and renames it asks this first: a pipe, a device or a
/// folder of that name, also behind a symbolic link as /dev/stdout is one, would be gone. A link to
/// a file stays a link; what it points to is replaced. [any thread]
/// @return the place that the finished file takes: `file` itself, or what its links lead to
/// @throw NotReplaceable  there is something that is no regular file, or one that is read-only
std::filesystem::path requireReplaceable(const std::filesystem::path& file);

/// A file that is read for what is written, and what people call it, after "is".
struct FileRead {
  std::filesystem::path file;
  std::string what = {};  ///< Nothing: it is the scan itself.
};

/// Before any work: what is written must not take the place of what it is made from. One file
/// however it is called: relative paths and links count. [any thread]
/// @throw ArgumentError  `out` is one of `inputs`; empty names are no file
void requireNotAnInput(const std::filesystem::path& out, const std::vector<FileRead>& inputs);

/// Likewise, no two of what one command writes may be one file, there already or not. [any thread]
/// @throw ArgumentError  naming it; empty names are no file
void requireDifferentFiles(const std::vector<std::filesystem::path>& outputs);

}  // namespace relievo
