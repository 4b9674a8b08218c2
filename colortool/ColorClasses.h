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
  bool operator==(const NamedColor&) const = default;
};

/// The classes that pixels are sorted into. Class 0 is "none"; the others are names of colours, each with the
/// colour that views show it in. A plain value, small; at most kMax classes besides "none".
class ColorClasses {
 public:
  static constexpr std::uint8_t kNone = 0;
  static constexpr int kMax = 255;

  ColorClasses() : classes_{{"none", {0, 0, 0}}} {}
  /// Classes from 1 on; those after kMax are left out.
  explicit ColorClasses(std::vector<NamedColor> classes);
  /// Those of `palette` whose name is one of `names`, in the order of `names`; names without a colour are
  /// left out.
  static ColorClasses select(std::span<const NamedColor> palette, std::span<const std::string_view> names);

  /// With class 0.
  int size() const { return static_cast<int>(classes_.size()); }
  const std::string& name(int index) const { return classes_[static_cast<std::size_t>(index)].name; }
  robotlink::Rgb shownColor(int index) const { return classes_[static_cast<std::size_t>(index)].rgb; }
  /// kNone if there is no such class.
  std::uint8_t index(std::string_view name) const;
  /// The classes from 1 on: class n is colors()[n - 1]. Valid as long as this is.
  std::span<const NamedColor> colors() const { return std::span(classes_).subspan(1); }
  /// The same, their names alone.
  std::vector<std::string> names() const;

  bool operator==(const ColorClasses&) const = default;

 private:
  std::vector<NamedColor> classes_;
};

/// The classes of `first`, and after them those that only `second` has, by name.
ColorClasses unite(const ColorClasses& first, const ColorClasses& second);
/// For each class of `from`, 0 included, the number of the one of the same name in `to`, or kNone; what
/// ColorTable::translated() takes.
std::vector<std::uint8_t> classNumbers(const ColorClasses& from, const ColorClasses& to);

/// Why a class cannot be called so, as a sentence; empty if it can. "none" and "background" stand for pixels
/// of no class in files and on command lines.
std::string classNameProblem(std::string_view name);

}  // namespace colortool
