// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "colortool/samples/Samples.h"
#include "robotlink/base/Error.h"

namespace colortool {

// Edits of the color classes of samples. Each function returns the changed samples; strokes stay with the
// name of their class when its number changes. Class numbers run from 1 to the number of classes; class 0,
// the background, always exists. Numbers must be valid, this is not checked. All functions are pure: any
// thread may call them.

/// Number of strokes of a class.
std::size_t strokesOf(const Samples& samples, int colorClass);
/// Returns a name that no class has, such as "class 9".
std::string freeClassName(const ColorClasses& classes);

/// Adds a class at the end. Fails on a name that cannot be or is taken, and if there are ColorClasses::kMax.
robotlink::Result<Samples> withNewClass(Samples samples, NamedColor added);
/// Fails on an invalid name, and on one that another class has.
robotlink::Result<Samples> withRenamedClass(Samples samples, int colorClass, const std::string& name);
/// Changes the color in which views show a class; the table is not affected.
Samples withRecoloredClass(Samples samples, int colorClass, robotlink::Rgb color);
/// Removes a class together with its strokes.
Samples withoutClass(Samples samples, int colorClass);
/// Gives a class the number `to`; the classes in between move by one.
Samples withMovedClass(Samples samples, int colorClass, int to);
/// Replaces the classes by `classes`. Classes that exist in the samples only and have strokes are appended,
/// so that no stroke is lost.
Samples withClasses(Samples samples, const ColorClasses& classes);

}  // namespace colortool
