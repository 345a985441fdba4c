// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace relievo {

// A file's name is bytes; JSON and zip files hold UTF-8 (docs/adr/0135-names-are-bytes.md).

/// The name as UTF-8: unchanged if it is that already, but for bytes that are not, and for the
/// characters U+EF80 to U+EFFF themselves, each byte 0x80 + n is the character U+EF80 + n.
std::string textOfName(std::string_view name);

/// The name that textOfName() gave this text.
std::string nameFromText(std::string_view text);

/// The name for people and for lines of text: one line of UTF-8, in which a byte that is no UTF-8
/// or steers a terminal, and a line's end, is %XX. Two names may look alike.
std::string escapedName(std::string_view name);

}  // namespace relievo
