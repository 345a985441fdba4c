// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace relievo {

/// The files that names stand for, each once, sorted by their absolute paths: so that neither the
/// order of the names nor how they were named shows in what is made. A name is one of
/// - a file that is there: that file;
/// - a folder: the files in it that end in .las, .laz or .ply, in small letters or large;
/// - a pattern with * or ? in file or folders' names: what fits it;
/// - a text file (.txt, .lst, .list) whose first entry ends so: the files it names, one a line,
/// from
///   its own folder; lines that begin with # are none;
/// - a tile index (.vpc, .geojson, .json) whose features say where their files are ("href" of an
///   asset, or "location"), from its own folder.
/// A single name of a file that is no list stays as it is given. [worker]
/// @throw FileError  a name stands for nothing, a list names what is not there, or an index is
///                   damaged or names addresses of the network
std::vector<std::filesystem::path> filesNamed(const std::vector<std::filesystem::path>& names);

}  // namespace relievo
