// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Image.h"

namespace colortool {

/// A colour of the world by its name, as white light of full strength shows it.
struct NamedColor {
  std::string name;
  robotlink::Rgb rgb;
};

/// The classes that pixels are sorted into. Class 0 is "none"; the others are names of colours, each with the
/// colour that views show it in. A plain value, small; at most 255 classes besides "none".
class ColorClasses {
 public:
  static constexpr std::uint8_t kNone = 0;

  ColorClasses() : classes_{{"none", {0, 0, 0}}} {}
  /// Those of `palette` whose name is one of `names`, in the order of `names`; names without a colour are
  /// left out.
  static ColorClasses select(std::span<const NamedColor> palette, std::span<const std::string_view> names);

  int size() const { return static_cast<int>(classes_.size()); }
  const std::string& name(int index) const { return classes_[static_cast<std::size_t>(index)].name; }
  robotlink::Rgb shownColor(int index) const { return classes_[static_cast<std::size_t>(index)].rgb; }
  /// kNone if there is no such class.
  std::uint8_t index(std::string_view name) const;

 private:
  std::vector<NamedColor> classes_;
};

}  // namespace colortool
