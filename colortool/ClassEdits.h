// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "colortool/Samples.h"
#include "robotlink/base/Error.h"

namespace colortool {

// What a person does with the classes of samples. All of them yield the changed samples; strokes stay with
// the class of their name. Class numbers are from 1 to the number of classes; 0, background, is always there.
// Any thread.

std::size_t strokesOf(const Samples& samples, int colorClass);
/// "class 9": a name that no class has.
std::string freeClassName(const ColorClasses& classes);

/// After the others. Fails on a name that cannot be or is taken, and if there are ColorClasses::kMax.
robotlink::Result<Samples> withNewClass(Samples samples, NamedColor added);
robotlink::Result<Samples> withRenamedClass(Samples samples, int colorClass, const std::string& name);
Samples withRecoloredClass(Samples samples, int colorClass, robotlink::Rgb color);
/// Its strokes go with it.
Samples withoutClass(Samples samples, int colorClass);
/// The classes in between move by one.
Samples withMovedClass(Samples samples, int colorClass, int to);
/// Those of `classes`; after them, so that nothing is lost, those that only the samples have and that have
/// strokes.
Samples withClasses(Samples samples, const ColorClasses& classes);

}  // namespace colortool
