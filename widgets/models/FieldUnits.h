// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

namespace widgets {

/// The unit of a number in messages of a type, as their schemas say it in words: "rad", "m/s"; empty if it
/// has none, or if none is known. `field` is a path such as PlotSource has: "joints[head.pan].position".
QString unitOf(const std::string& type, const std::string& field);

}  // namespace widgets
