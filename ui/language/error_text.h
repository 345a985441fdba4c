// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <QString>

namespace relievo {

/// What is wrong, in the window's language where the error carries a message of the catalogue
/// (core/message); else in English, so that it can be searched for. [any thread]
QString spokenError(const std::exception& error);
/// The same for the screen, with the catalogue's code at its end if there is one: "... (E401)".
QString shownError(const std::exception& error);
/// Of words that are in the window's language already.
QString shownError(const QString& text, const QString& code);

}  // namespace relievo
