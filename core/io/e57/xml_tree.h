// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

/// One element of an XML text.
struct XmlElement {
  std::string name;
  std::map<std::string, std::string, std::less<>> attributes;
  std::string text;  ///< Of the element itself, without that of its children.
  std::vector<XmlElement> children;

  const XmlElement* child(std::string_view child_name) const noexcept;         ///< First, or null.
  std::string_view attribute(std::string_view attribute_name) const noexcept;  ///< Or empty.
};

struct XmlError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The whole text as a tree. Document types (and with them entities of the file's own) are
/// refused, and so are trees deeper than 64 or larger than a million elements.
/// @throw XmlError  with line and reason
XmlElement parseXml(std::string_view text);

}  // namespace relievo
