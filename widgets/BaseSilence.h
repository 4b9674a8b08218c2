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

/// After this time without a message of its base, which sends ten times per second, a robot counts as silent,
/// s.
inline constexpr double kSilentAfter = 1.5;

/// For how many seconds a robot's base has been silent at the shown instant, which is the age of everything
/// that is shown of it. Unset if the robot is not silent, or if it has no such base.
std::optional<double> baseSilence(const robotlink::StreamStore& store, const std::string& robot,
                                  robotlink::Instant shown);

/// Returns "p3dx last heard 12 s ago"; empty if messages of the robot arrive.
QString silenceText(const std::string& robot, std::optional<double> silence);

}  // namespace widgets
