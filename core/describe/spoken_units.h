// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "core/message/language.h"

namespace relievo {

/// A text for eyes as one says it: "Press depth 2.50 mm" becomes "Press depth 2.5 millimetres", and
/// "300 × 200 mm" "30 centimetres by 20 centimetres". Numbers without a unit, names of files and
/// all else stay. [any thread]
/// @param language  that of the text
std::string spokenUnits(const MessageLanguage& language, std::string_view text);

}  // namespace relievo
