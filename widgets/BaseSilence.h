// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "robotlink/base/Clock.h"

namespace robotlink {
class StreamStore;
}

namespace widgets {

/// s without a word of its base, which speaks ten times a second, from which on a robot counts as silent.
inline constexpr double kSilentAfter = 1.5;

/// How many seconds a robot's base has been silent at the instant that is shown: what is shown of the robot
/// is so old. Unset while it speaks, and for robots that have no such base.
std::optional<double> baseSilence(const robotlink::StreamStore& store, const std::string& robot,
                                  robotlink::Instant shown);

/// "p3dx last heard 12 s ago"; empty while the robot is not silent.
QString silenceText(const std::string& robot, std::optional<double> silence);

}  // namespace widgets
