// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/expressions/FieldPath.h"

namespace robotlink {

/// A value of a stream that an expression uses.
struct ExpressionInput {
  /// The stream as in the text: with the robot ("red1/models/ball") or without ("models/ball").
  std::string stream;
  FieldPath path;
  /// The position of the field in the expression, from 1.
  int column = 1;
};

}  // namespace robotlink
