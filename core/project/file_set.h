// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace relievo {

enum class SetMembership {
  same,    ///< Both were written by one command.
  other,   ///< They were not: a command was ended while its files took their places, or was copied.
  unsaid,  ///< One of them says nothing of its set.
};
/// "same", "other", "unsaid".
std::string_view name(SetMembership membership);

struct SetMember {
  std::filesystem::path file;
  SetMembership membership = SetMembership::unsaid;
};

/// Were both written by one command? Of a map and its origins, colours, counts, spreads and levels:
/// by the checksum of the map's content; of a figure, its eyes, heights and caption, and of tables
/// and their drawings: by the mark in their state, or the state itself. [worker]
/// @throw FileError  one of them is missing or damaged
SetMembership membershipIn(const std::filesystem::path& main, const std::filesystem::path& file);

/// The files beside `main` that have the names that our commands give to files which belong to it:
/// of MAP.tif origins, colours, intensities, counts and spreads; of MAP.L0.tif the other levels
/// with theirs; of a picture the two eyes'. Sorted by name. [worker]
/// @throw FileError  as membershipIn, of `main`
std::vector<SetMember> filesBeside(const std::filesystem::path& main);

}  // namespace relievo
