// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfPaths.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace simcore {
using tinyxml2::XMLElement;

namespace {

/// The angles of a rotation, x y z w of any length: first roll, then pitch, then yaw.
std::array<double, 3> anglesOf(double x, double y, double z, double w) {
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  if (!(length > 0)) return {};
  x /= length, y /= length, z /= length, w /= length;
  const double sine = std::clamp(2 * (w * y - z * x), -1.0, 1.0);
  // If the x-axis points straight up or down, only the sum of roll and yaw is known.
  if (std::abs(sine) > 1 - 1e-12)
    return {0, std::copysign(robotlink::kPi / 2, sine), std::copysign(2 * std::atan2(x, w), -sine)};
  return {std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)), std::asin(sine),
          std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))};
}

}  // namespace

std::string objectPath(const XMLElement& element) {
  std::string path;
  const tinyxml2::XMLNode* node = &element;
  for (; node != nullptr && node->ToElement() != nullptr; node = node->Parent()) {
    const std::string name = nameOf(*node->ToElement());
    if (!name.empty()) path = path.empty() ? name : name + "/" + path;
  }
  return path;
}

int sourceLine(const XMLElement& element) {
  const tinyxml2::XMLNode* at = &element;
  // An element that was added while a file was read has the line of its parent.
  while (at->GetUserData() == nullptr && at->GetLineNum() <= 0 && at->Parent() != nullptr) at = at->Parent();
  const auto set = reinterpret_cast<std::uintptr_t>(at->GetUserData());
  return set != 0 ? static_cast<int>(set) : at->GetLineNum();
}

void setSourceLine(XMLElement& element, int line) {
  element.SetUserData(
      reinterpret_cast<void*>(static_cast<std::uintptr_t>(line)));  // NOLINT(performance-no-int-to-ptr)
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

bool isBool(const std::string& text) {
  return isTrue(text) || text == "0" || text == "false" || text == "False" || text == "FALSE";
}

std::vector<std::string> wordsOf(const XMLElement& element) {
  std::vector<std::string> result;
  std::istringstream stream(element.GetText() != nullptr ? element.GetText() : "");
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

bool isFiniteNumber(const std::string& word) {
  char* end = nullptr;
  return std::isfinite(std::strtod(word.c_str(), &end)) && end == word.c_str() + word.size();
}

bool hasQuaternion(const XMLElement& pose) {
  const char* const format = pose.Attribute("rotation_format");
  return format != nullptr && std::string_view(format) == "quat_xyzw";
}

std::optional<std::array<double, 6>> poseIn(const XMLElement& pose) {
  std::istringstream stream(trimmedText(&pose));
  std::vector<double> numbers(hasQuaternion(pose) ? 7 : 6);
  for (double& number : numbers) stream >> number;
  std::string rest;
  if (stream.fail() || stream >> rest) return std::nullopt;
  std::array<double, 6> result{};
  std::copy_n(numbers.begin(), result.size(), result.begin());
  if (hasQuaternion(pose)) {
    std::ranges::copy(anglesOf(numbers[3], numbers[4], numbers[5], numbers[6]), result.begin() + 3);
  } else if (isTrue(pose.Attribute("degrees") != nullptr ? pose.Attribute("degrees") : "")) {
    for (std::size_t i = 3; i < result.size(); ++i) result[i] = robotlink::radians(result[i]);
  }
  return result;
}

std::string layoutIn(const std::string& text, const std::filesystem::path& file) {
  const bool isPath = text.find('/') != std::string::npos || text.ends_with(".yaml");
  return isPath ? (file.parent_path() / text).lexically_normal().string() : text;
}

}  // namespace simcore
