// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <QString>

namespace relievo {

/// What core says is wrong, in the window's language where it is one of the frequent cases: no such
/// file, no permission, empty, cut, unknown format, too little memory, full disk. Other sentences
/// stay English, so that they can be searched for. [any thread]
QString spokenError(const QString& english);
QString spokenError(const std::exception& error);
/// The same for the screen, with the catalogue's code at its end if there is one: "... (E401)".
QString shownError(const QString& english, const QString& code);
QString shownError(const std::exception& error);

}  // namespace relievo
