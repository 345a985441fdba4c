// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/report_text.h"

#include "core/provenance/name_text.h"

namespace relievo::batch {
namespace {

void nameTexts(Json& part) {
  if (part.is_string()) {
    part = textOfName(part.get_ref<const std::string&>());
  } else if (part.is_structured()) {
    for (Json& inner : part) nameTexts(inner);
  }
}

}  // namespace

std::string counted(std::uint64_t count, const char* one, const char* more) {
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

std::string reportText(Json report) {
  nameTexts(report);
  return report.dump(2);
}

}  // namespace relievo::batch
