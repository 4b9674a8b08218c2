// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace widgets {

/// An expression for an error over time, in the unit in which tables show it (mm or degrees); see
/// robotlink/expressions/EXPRESSIONS.md. `path` is the stream's path below the robot, such as that of a
/// shadow, `package` the package that it has. Empty: no expression says it, such as what needs to be matched.
///
/// It compares with the newest truth; the figures compare with the truth of the reading on which a message is
/// based. The two differ while things move.
std::string errorFormula(const std::string& robot, const std::string& path, const std::string& package,
                         const std::string& quantity);

}  // namespace widgets
