// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/ColorClasses.h"

#include <algorithm>
#include <iterator>

namespace colortool {

ColorClasses::ColorClasses(std::vector<NamedColor> classes) : ColorClasses() {
  if (classes.size() > kMost) classes.resize(kMost);
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

}  // namespace colortool
