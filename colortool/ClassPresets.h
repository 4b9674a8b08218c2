// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "colortool/ColorClasses.h"
#include "robotlink/base/Error.h"

namespace colortool {

/// Colour classes to begin with, under a name that files and command lines use. Constant data.
struct ClassPreset {
  struct Color {
    std::string_view name;
    robotlink::Rgb rgb;  ///< that views show the class in
  };

  std::string_view name;          ///< "2002"
  std::string_view title;         ///< for people, English
  std::span<const Color> colors;  ///< of the classes from 1 on

  ColorClasses classes() const;
};

/// All there are; "2002" first.
///
/// 2002: the field and the robots of the four-legged league of 2002, in the colours of
/// resources/fields/2002.yaml. bhuman2009: the classes that B-Human's tables and logs of 2009 number, in the
/// order of ColorTableFile::kBHuman2009Classes.
std::span<const ClassPreset> classPresets();
/// Null if there is none of that name.
const ClassPreset* findClassPreset(std::string_view name);

/// What command lines take: the name of a preset alone, or the names of classes in the order of their
/// numbers. A class that a preset has is shown in that preset's colour, others in spare ones. Fails on names
/// that cannot be, and on those that stand there twice.
robotlink::Result<ColorClasses> chooseClasses(std::span<const std::string> names);

/// A colour for a class that has none; those of the first dozen numbers can be told apart.
robotlink::Rgb spareColor(int number);
/// What a class of which only the number is known is called and shown in: "class 9", and something behind it
/// where one of `others` has that name.
NamedColor spareClass(int number, std::span<const NamedColor> others);

}  // namespace colortool
