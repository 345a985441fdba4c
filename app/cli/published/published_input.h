// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/cli/verb.h"

namespace CLI {
class Option;
}

namespace relievo::batch {

/// A word where a file is expected may be the address of a published map: it is looked at while
/// words are read, and from then on the verb has its map.json of this computer (docs/adr/0200).
/// @throw FileError, WebLost  by the parser
CLI::Option* mayBeWebAddress(CLI::Option* file);
/// Takes that back, for words that a file holds: whoever wrote it does not decide which server is
/// asked.
void leaveWebAddress(CLI::Option* file);
/// The file, or the address that it is kept for: what people called it.
std::string calledInput(const std::string& file);

/// What `info` says of map.json of a published map. @throw FileError, WebLost
CommandResult infoOfPublished(const std::string& file, const Task& task);

}  // namespace relievo::batch
