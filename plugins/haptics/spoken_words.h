// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <string_view>

namespace relievo {

/// What haptics says - a command of a button, a fault, how the Falcon is doing - in the window's
/// language. Haptics has no Qt and says it in English, as terminals do; sentences that carry
/// numbers or names stay as they are.
QString spokenText(std::string_view words);

}  // namespace relievo
