// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/message/language.h"

namespace relievo {

// What Qt Linguist's files say, by English sentence, ascending; made at build time by
// make_sentences.
std::span<const TranslatedSentence> sentencesDe();
std::span<const TranslatedSentence> sentencesHi();

}  // namespace relievo
