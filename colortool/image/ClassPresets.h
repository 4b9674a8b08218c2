// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "colortool/image/ColorClasses.h"
#include "robotlink/base/Error.h"

namespace colortool {

/// A predefined list of color classes with the name by which files and command lines refer to it. Constant
/// data.
struct ClassPreset {
  /// A class of a preset.
  struct Color {
    std::string_view name;
    /// The color in which views show the class.
    robotlink::Rgb rgb;
  };

  /// The name in files and on command lines: "2002".
  std::string_view name;
  /// The title that users see, in English.
  std::string_view title;
  /// The classes from 1 on.
  std::span<const Color> colors;

  ColorClasses classes() const;
};

/// Returns all presets; "2002" is the first.
///
/// 2002: the field and the robots of the four-legged league of 2002, in the colors of
/// resources/fields/2002.yaml. bhuman2009: the classes of B-Human's tables (ColorTableFile) and logs of 2009.
std::span<const ClassPreset> classPresets();
/// Returns null if there is no preset of that name.
const ClassPreset* findClassPreset(std::string_view name);

/// The preset that fits things of these colors, such as a field: the one with most of its classes among them;
/// of several, or if none has any, the first one.
const ClassPreset& presetFor(std::span<const std::string> colors);

/// Interprets the class list of a command line: the name of a preset alone, or the names of classes in the
/// order of their numbers. A class that also occurs in a preset gets the color of that preset, any other a
/// spare color. Fails on invalid names and on duplicates.
robotlink::Result<ColorClasses> chooseClasses(std::span<const std::string> names);

/// A display color for a class that has none; the colors of the first dozen numbers are easy to distinguish.
robotlink::Rgb spareColor(int number);
/// Name and display color for a class of which only the number is known: "class 9", with a suffix if one of
/// `others` already has that name.
NamedColor spareClass(int number, std::span<const NamedColor> others);

}  // namespace colortool
