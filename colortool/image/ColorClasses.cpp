// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/ColorClasses.h"

#include <algorithm>
#include <iterator>

namespace colortool {

ColorClasses::ColorClasses(std::vector<NamedColor> classes) : ColorClasses() {
  if (classes.size() > kMax) classes.resize(kMax);
  std::ranges::move(classes, std::back_inserter(classes_));
}

ColorClasses ColorClasses::select(std::span<const NamedColor> palette,
                                  std::span<const std::string_view> names) {
  std::vector<NamedColor> classes;
  for (const std::string_view name : names) {
    const auto found = std::ranges::find(palette, name, &NamedColor::name);
    if (found != palette.end()) classes.push_back(*found);
  }
  return ColorClasses(std::move(classes));
}

std::uint8_t ColorClasses::index(std::string_view name) const {
  const auto found = std::ranges::find(classes_, name, &NamedColor::name);
  return found == classes_.end() ? kNone : static_cast<std::uint8_t>(found - classes_.begin());
}

std::vector<std::string> ColorClasses::names() const {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < classes_.size(); ++i) names.push_back(classes_[i].name);
  return names;
}

ColorClasses unite(const ColorClasses& first, const ColorClasses& second) {
  std::vector<NamedColor> classes(first.colors().begin(), first.colors().end());
  for (const NamedColor& one : second.colors()) {
    if (first.index(one.name) == ColorClasses::kNone) classes.push_back(one);
  }
  return ColorClasses(std::move(classes));
}

std::vector<std::uint8_t> classNumbers(const ColorClasses& from, const ColorClasses& to) {
  std::vector<std::uint8_t> numbers;
  for (int i = 0; i < from.size(); ++i) numbers.push_back(to.index(from.name(i)));
  return numbers;
}

std::string classNameProblem(std::string_view name) {
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  if (name.empty()) return "a class needs a name";
  if (name == "none" || name == "background")
    return "'" + std::string(name) + "' stands for pixels of no class and cannot be one";
  if (std::ranges::any_of(name, isControl)) return "a class's name has control characters";
  if (name.front() == ' ' || name.back() == ' ') return "a class's name begins or ends with a space";
  return {};
}

}  // namespace colortool
