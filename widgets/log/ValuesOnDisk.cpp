// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/ValuesOnDisk.h"

#include <algorithm>

#include "robotlink/session/Session.h"

namespace widgets {

std::optional<std::pair<double, double>> valuesOnDisk(robotlink::Session& session,
                                                      const std::vector<std::string>& streams, double begin) {
  // Less is the rounding of times.
  constexpr double kLeast = 0.01;
  const auto* archive = session.history().archive();
  const auto archived = archive != nullptr ? archive->stretch() : std::nullopt;
  if (!archived) return std::nullopt;
  double from = robotlink::seconds(archived->from);
  const double to = std::min(begin, robotlink::seconds(archived->to));
  for (const std::string& path : streams) {
    const auto* stream = session.store().find(path);
    if (stream == nullptr) return std::nullopt;
    from = std::max(from, robotlink::seconds(stream->since));
  }
  return to - from > kLeast ? std::optional(std::pair(from, to)) : std::nullopt;
}

}  // namespace widgets
