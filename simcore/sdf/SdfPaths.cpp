// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfPaths.h"

#include <tinyxml2.h>

namespace simcore {
using tinyxml2::XMLElement;

std::string objectPath(const XMLElement& element) {
  std::string path;
  const tinyxml2::XMLNode* node = &element;
  for (; node != nullptr && node->ToElement() != nullptr; node = node->Parent()) {
    const std::string name = nameOf(*node->ToElement());
    if (!name.empty()) path = path.empty() ? name : name + "/" + path;
  }
  return path;
}

std::string trimmedText(const XMLElement* element) {
  const std::string text = element != nullptr && element->GetText() != nullptr ? element->GetText() : "";
  constexpr const char* kSpace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpace);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::string childText(const XMLElement& element, const char* name) {
  return trimmedText(element.FirstChildElement(name));
}

std::string nameOf(const XMLElement& element) {
  return element.Attribute("name") != nullptr ? element.Attribute("name") : "";
}

bool isTrue(const std::string& text) {
  return text == "true" || text == "1" || text == "True" || text == "TRUE";
}

std::string layoutIn(const std::string& text, const std::filesystem::path& file) {
  const bool isPath = text.find('/') != std::string::npos || text.ends_with(".yaml");
  return isPath ? (file.parent_path() / text).lexically_normal().string() : text;
}

}  // namespace simcore
