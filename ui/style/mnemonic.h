// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace relievo {

/// What a text says without its mnemonic, for places that have none: "&Open" -> "Open",
/// "खोलें… (&O)" -> "खोलें…".
QString withoutMnemonic(QString text);

}  // namespace relievo
