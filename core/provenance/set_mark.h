// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace relievo {

/// What a file says of the files that one command wrote with it (docs/adr/0131).
struct SetMark {
  std::string id;              ///< The same in all of them; empty: it does not say.
  std::string caption_sha256;  ///< Of the caption beside a picture, without its line end.
};

/// @param shared  what follows from everything that the files of the set show
/// @param caption  of the picture that says it, if there is one
SetMark setMark(std::string_view shared, std::string_view caption = {});

/// Provenance::made or Project::made with a mark.
/// @param made  a JSON object; empty: a new one
std::string markedMade(std::string_view made, const SetMark& mark);

/// The mark in a state, a provenance or a project as JSON; empty: it has none.
/// @throw FileError  the state is damaged; `source` names it
SetMark markIn(std::string_view state, const std::string& source);

}  // namespace relievo
