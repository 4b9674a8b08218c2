// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace widgets {

/// The valid range of an object's property. A plain value.
struct PropertyRule {
  double minimum, maximum;
  /// Whether the minimum itself is too small: masses and sizes are above 0.
  bool isAbove = false;
};

/// The rule of a property by its name ("mass", "size", "friction", ...); other ones may have any number.
PropertyRule propertyRule(const std::string& name);

/// Reads the numbers that were typed for a property, separated by blanks. Fails, in words for users, if there
/// are not `count` of them, one is not as the rule says, or no body has them as its inertia. `title` and
/// `unit` are for these words.
robotlink::Result<std::vector<double>> propertyNumbers(const QString& typed, const std::string& name,
                                                       int count, const QString& title, const QString& unit);

}  // namespace widgets
