// SPDX-License-Identifier: BSD-3-Clause
// Recipes of scans to prepare, under libFuzzer: one that is taken can be done, and written and read
// again it is the same; all others are refused with a FileError.
#include <string>

#include "core/base/error.h"
#include "core/prepare/recipe.h"
#include "tests/fuzz/invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace relievo;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Recipe recipe;
  try {
    recipe = recipeFromJson(text, "input.json");
  } catch (const FileError& error) {
    fuzz::checkSentence(error.what());
    return 0;
  }
  check(recipe);
  for (const int indent : {-1, 2}) {
    fuzz::require(recipeFromJson(toJson(recipe, indent), "again") == recipe,
                  "a recipe that was written is the same when it is read");
  }
  return 0;
}
