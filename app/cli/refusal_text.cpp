// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/refusal_text.h"

#include <string_view>

namespace relievo::batch {

std::string refusalText(std::string sentence) {
  const auto replace = [&sentence](std::string_view from, std::string_view to) {
    const std::size_t at = sentence.find(from);
    if (at != std::string::npos) sentence.replace(at, from.size(), to);
    return at != std::string::npos;
  };
  if (replace("Could not convert: ", "") && replace(" = ", ": '")) {
    sentence += "' is not a number that it takes";
  } else if (replace(": Value ", ": ")) {
    replace(" not in range ", " is not from ");
  } else if (replace(" not in {", "' is none of ")) {
    replace(": ", ": '");
    sentence.pop_back();
  }
  return sentence + ". Nothing was done.";
}

}  // namespace relievo::batch
