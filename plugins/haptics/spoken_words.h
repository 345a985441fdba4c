// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <string_view>

namespace relievo {

/// What haptics says - a command of a button, a fault, how the Falcon is doing, what its self test
/// and calibration find and ask for, what is wrong with its firmware - in the window's language.
/// Haptics has no Qt and says it in English, as terminals do. Numbers, names of files and the
/// system's own reasons are carried over as they are; a sentence that is not known stays English.
/// [GUI thread]
QString spokenText(std::string_view words);

}  // namespace relievo
