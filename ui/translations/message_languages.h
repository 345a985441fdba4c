// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/message/language.h"

namespace relievo {

/// English, German and Hindi, with all the sentences of the catalogue. [any thread]
std::span<const MessageLanguage> messageLanguages();

/// That of a tag, "de" or "de_AT" or "de-AT"; English, if there is none such.
const MessageLanguage& messageLanguage(std::string_view tag);

}  // namespace relievo
