// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/ColorClasses.h"

#include <algorithm>

namespace colortool {

ColorClasses ColorClasses::select(std::span<const NamedColor> palette,
                                  std::span<const std::string_view> names) {
  ColorClasses classes;
  for (const std::string_view name : names) {
    const auto found = std::ranges::find(palette, name, &NamedColor::name);
    if (found != palette.end() && classes.size() < 256) classes.classes_.push_back(*found);
  }
  return classes;
}

std::uint8_t ColorClasses::index(std::string_view name) const {
  const auto found = std::ranges::find(classes_, name, &NamedColor::name);
  return found == classes_.end() ? kNone : static_cast<std::uint8_t>(found - classes_.begin());
}

}  // namespace colortool
