// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/exhibit/exhibit.h"
#include "core/exhibit/visit.h"
#include "core/message/message.h"

namespace relievo {

/// What an order of a visit says to the visitor, by itself; empty: nothing, or what others say.
/// @param language  tag, of the exhibit's
std::vector<Message> visitWords(const Visit::Order& order, const Exhibit& exhibit,
                                const std::string& language);

}  // namespace relievo
