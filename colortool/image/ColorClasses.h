// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Image.h"

namespace colortool {

/// A named color of the world, as it appears under white light of full strength.
struct NamedColor {
  /// Unique within a list of colors, see classNameProblem().
  std::string name;
  robotlink::Rgb rgb;
  bool operator==(const NamedColor&) const = default;
};

/// The classes that pixels are sorted into. Class 0 is "none"; the others are names of colors, each with the
/// color that views show it in. A plain value, small; at most kMax classes besides "none".
class ColorClasses {
 public:
  /// The class of pixels that belong to no color.
  static constexpr std::uint8_t kNone = 0;
  static constexpr int kMax = 255;

  ColorClasses() : classes_{{"none", {0, 0, 0}}} {}
  /// Classes from 1 on; those after kMax are left out.
  explicit ColorClasses(std::vector<NamedColor> classes);
  /// Returns the colors of `palette` whose names occur in `names`, in the order of `names`. Names that the
  /// palette lacks are dropped.
  static ColorClasses select(std::span<const NamedColor> palette, std::span<const std::string_view> names);

  /// Number of classes, including class 0.
  int size() const { return static_cast<int>(classes_.size()); }
  /// `index` must be less than size().
  const std::string& name(int index) const { return classes_[static_cast<std::size_t>(index)].name; }
  /// The color in which views show a class.
  robotlink::Rgb shownColor(int index) const { return classes_[static_cast<std::size_t>(index)].rgb; }
  /// Returns kNone if there is no such class.
  std::uint8_t index(std::string_view name) const;
  /// The classes from 1 on: class n is colors()[n - 1]. Valid as long as this object.
  std::span<const NamedColor> colors() const { return std::span(classes_).subspan(1); }
  /// The names of the classes from 1 on.
  std::vector<std::string> names() const;

  bool operator==(const ColorClasses&) const = default;

 private:
  /// Indexed by class number; the first one is "none".
  std::vector<NamedColor> classes_;
};

/// Returns the classes of `first`, followed by those whose names only `second` has.
ColorClasses unite(const ColorClasses& first, const ColorClasses& second);
/// Maps the classes of `from`, including 0, to those of `to` by name; the result at n is the number in `to`,
/// or kNone. ColorTable::translated() takes such a map.
std::vector<std::uint8_t> classNumbers(const ColorClasses& from, const ColorClasses& to);

/// Returns a sentence that says why a name is not allowed for a class; empty if it is allowed. "none" and
/// "background" are reserved for pixels of no class in files and on command lines.
std::string classNameProblem(std::string_view name);

}  // namespace colortool
