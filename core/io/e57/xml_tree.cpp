// SPDX-License-Identifier: BSD-3-Clause
// The only file that sees Expat.
#include "core/io/e57/xml_tree.h"

#include <expat.h>

#include <limits>
#include <memory>

namespace relievo {
namespace {

constexpr std::size_t kMaxDepth = 64;
constexpr std::size_t kMaxElements = 1'000'000;

/// What grows while Expat calls. No exception may pass through it, so errors are kept.
struct Building {
  XML_Parser parser = nullptr;
  std::vector<XmlElement> open{XmlElement{}};  ///< From a nameless root down to the current one.
  std::size_t elements = 0;
  std::string error;

  void fail(const char* reason) noexcept {
    try {
      if (error.empty()) error = reason;
    } catch (...) {  // Short of memory; the parser's own error will do.
      error.clear();
    }
    XML_StopParser(parser, XML_FALSE);
  }
};

template <class Action>
void guarded(void* data, Action action) noexcept {
  auto& building = *static_cast<Building*>(data);
  try {
    action(building);
  } catch (const std::exception& error) {
    building.fail(error.what());
  }
}

void startElement(void* data, const XML_Char* name, const XML_Char** attributes) {
  guarded(data, [&](Building& building) {
    if (building.open.size() > kMaxDepth || ++building.elements > kMaxElements) {
      building.fail("too many elements");
      return;
    }
    XmlElement element;
    element.name = name;
    for (; *attributes != nullptr; attributes += 2)
      element.attributes[attributes[0]] = attributes[1];
    building.open.push_back(std::move(element));
  });
}

void endElement(void* data, const XML_Char* /*name*/) {
  guarded(data, [](Building& building) {
    XmlElement done = std::move(building.open.back());
    building.open.pop_back();
    building.open.back().children.push_back(std::move(done));
  });
}

void characters(void* data, const XML_Char* text, int length) {
  guarded(data, [&](Building& building) {
    building.open.back().text.append(text, static_cast<std::size_t>(length));
  });
}

void startDocumentType(void* data, const XML_Char* /*name*/, const XML_Char* /*system*/,
                       const XML_Char* /*public_name*/, int /*has_internal*/) {
  static_cast<Building*>(data)->fail("a document type is not allowed");
}

}  // namespace

const XmlElement* XmlElement::child(std::string_view child_name) const noexcept {
  for (const XmlElement& element : children) {
    if (element.name == child_name) return &element;
  }
  return nullptr;
}

std::string_view XmlElement::attribute(std::string_view attribute_name) const noexcept {
  const auto found = attributes.find(attribute_name);
  return found == attributes.end() ? std::string_view{} : std::string_view(found->second);
}

XmlElement parseXml(std::string_view text) {
  if (text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw XmlError("too long");
  }
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(nullptr), &XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  Building building;
  building.parser = parser.get();
  XML_SetUserData(parser.get(), &building);
  XML_SetElementHandler(parser.get(), startElement, endElement);
  XML_SetCharacterDataHandler(parser.get(), characters);
  XML_SetStartDoctypeDeclHandler(parser.get(), startDocumentType);
  const XML_Status status =
      XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
  if (status != XML_STATUS_OK) {
    const std::string reason =
        building.error.empty() ? XML_ErrorString(XML_GetErrorCode(parser.get())) : building.error;
    throw XmlError("line " + std::to_string(XML_GetCurrentLineNumber(parser.get())) + ": " +
                   reason);
  }
  return std::move(building.open.front().children.front());
}

}  // namespace relievo
