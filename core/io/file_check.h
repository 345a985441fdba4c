// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace relievo {

/// Size of a file that can be read: a regular file (or a link to one), not empty, readable.
/// Never waits, not even on a FIFO without a writer. [any thread]
/// @throw FileError  missing, a directory, a device or pipe, without permission, or empty
std::uint64_t checkedFileSize(const std::filesystem::path& file);

/// At most the first `limit` bytes. @throw FileError  as above
std::string readHead(const std::filesystem::path& file, std::size_t limit);

/// Words from a file as a message may show them: bytes that are no UTF-8, and characters that
/// would steer a terminal, are question marks.
std::string printable(std::string_view text);

/// The first 60 bytes of a line without the space around it, as a message may show them.
std::string shownStart(std::string_view line);

/// File name without folders, for messages; printable.
std::string shownName(const std::filesystem::path& file);

/// "960 000": digits in groups of three.
std::string grouped(std::uint64_t number);

}  // namespace relievo
