// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace relievo {

/// Text of an XML element with its five entities as the characters that they stand for.
std::string withoutEntities(std::string_view text);

}  // namespace relievo
