// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/embedded.h"

#include <algorithm>
#include <array>
#include <utility>

namespace relievo {
namespace {

constexpr std::string_view kNamespace = "urn:relievo:";
constexpr std::array<std::pair<char, std::string_view>, 5> kEntities{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&apos;"}}};

}  // namespace

std::string markupText(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    const auto* const entity = std::find_if(kEntities.begin(), kEntities.end(),
                                            [c](const auto& e) { return e.first == c; });
    if (entity == kEntities.end()) {
      safe += c;
    } else {
      safe += entity->second;
    }
  }
  return safe;
}

std::string stateElement(std::string_view json) {
  const std::string key(kStateKey);
  return "<" + key + " xmlns:relievo=\"" + std::string(kNamespace) + "\">" + markupText(json) +
         "</" + key + ">";
}

std::string withState(std::string svg, std::string_view json) {
  const std::size_t element = svg.find("<svg");
  const std::size_t end = svg.find('>', element) + 1;
  svg.insert(end, "\n<metadata>" + stateElement(json) + "</metadata>");
  return svg;
}

std::string stateLine(std::string_view json) {
  return std::string(kStateKey).append(" ").append(json);
}

}  // namespace relievo
