// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/json_nesting.h"

#include <cstddef>

namespace relievo {

bool isNestedDeeper(std::string_view json, int deepest) noexcept {
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text) {
      if (c == '\\') ++i;  // What is escaped ends no text.
      if (c == '"') in_text = false;
    } else if (c == '"') {
      in_text = true;
    } else if (c == '[' || c == '{') {
      if (++depth > deepest) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

}  // namespace relievo
