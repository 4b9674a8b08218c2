// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

// The units of the numbers in messages, for plots: a table by the fields' names, which repeats the comments
// in the schemas.
namespace widgets {

/// Unit of a number in messages of a type: "rad", "m/s"; empty if it has none or none is known. `field` is a
/// path as in PlotSource: "joints[head.pan].position".
QString unitOf(const std::string& type, const std::string& field);

}  // namespace widgets
