// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/verbs/svg.h"

namespace relievo::batch {

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string textAt(double x, double y, const std::string& anchor, const std::string& text,
                   const std::string& more) {
  return "<text x='" + fixedDigits(x, 1) + "' y='" + fixedDigits(y, 1) + "' text-anchor='" +
         anchor + "'" + more + ">" + text + "</text>\n";
}

std::string lineAt(double x1, double y1, double x2, double y2, const std::string& colour) {
  return "<line x1='" + fixedDigits(x1, 1) + "' y1='" + fixedDigits(y1, 1) + "' x2='" +
         fixedDigits(x2, 1) + "' y2='" + fixedDigits(y2, 1) + "' stroke='" + colour + "'/>\n";
}

}  // namespace relievo::batch
