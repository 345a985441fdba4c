// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace relievo {

// The checksums that stand in a log beside its rows (docs/adr/0132-chained-checksums.md).

/// One block of a log and all before it: the checksum's line, "sum ROWS DIGITS" or
/// "finished ROWS DIGITS". Each covers the digits of the line before, its own word and count, and
/// the block's bytes, so that no block can be changed, moved or left out.
std::string checksumLine(std::string_view before, std::string_view word, std::string_view count,
                         std::string_view block);
inline constexpr std::string_view kBlockWord = "sum ";
inline constexpr std::string_view kFinishedWord = "finished ";

/// The digits at the end of such a line.
std::string digitsOf(std::string_view checksum_line);

// Of CSV logs. A recording's last lines stand in room before its rows, which is filled when all
// else is written: the checksums before cover all but it, and "finished", in it, covers it.
inline constexpr std::size_t kRoomBytes = 2048;
inline constexpr std::string_view kChecksums = "checksums sha256";
inline constexpr std::string_view kChecksumsButRoom =
    "checksums sha256, but for the 2048 bytes before the columns";
/// The room while nobody has ended the recording.
std::string emptyRoom();

/// Is this line of a CSV log's comments, without its "# ", about checksums and nothing else?
bool isChecksumLine(std::string_view comment) noexcept;

// Of HDF5 logs. Before the HDF5 file itself stand so many bytes that HDF5 leaves to whoever writes
// it (its "user block"): whether the log was finished, and then the checksum of all that follows.
inline constexpr std::size_t kUserBlockBytes = 512;
inline constexpr std::string_view kUserBlockWords = "relievo HDF5 recording; ";
/// @param digits  SHA-256 of what follows; empty: the log is not finished
std::string userBlock(std::string_view digits);

}  // namespace relievo
