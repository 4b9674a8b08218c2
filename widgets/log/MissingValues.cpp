// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/MissingValues.h"

#include <algorithm>
#include <tuple>

#include "robotlink/session/Session.h"

namespace widgets {

using Why = MissingValues::Why;

std::vector<MissingValues> missingValues(robotlink::Session& session, const std::vector<std::string>& streams,
                                         std::pair<double, double> times,
                                         const std::optional<std::pair<double, double>>& unread) {
  // Smaller differences are due to the rounding of times.
  constexpr double kLeast = 0.01;
  const auto* archive = session.history().archive();
  const auto archived = archive != nullptr ? archive->stretch() : std::nullopt;
  if (!archived) return {};
  double from = robotlink::seconds(archived->from);
  for (const std::string& path : streams) {
    const auto* stream = session.store().find(path);
    if (stream == nullptr) return {};
    from = std::max(from, robotlink::seconds(stream->since));
  }
  std::vector<MissingValues> missing;
  const auto add = [&](double begin, double end, Why why) {
    begin = std::max(begin, from);
    if (end - begin > kLeast) missing.push_back({begin, end, why});
  };
  if (unread)
    add(unread->first, unread->second, Why::kUnread);
  else
    add(from, std::min(times.first, robotlink::seconds(archived->to)), Why::kTooMany);
  for (const robotlink::Stretch& hole : archive->holes())
    add(robotlink::seconds(hole.from), std::min(times.second, robotlink::seconds(hole.to)), Why::kLost);
  return missing;
}

std::vector<MissingValues> joined(std::vector<MissingValues> missing) {
  std::ranges::sort(missing, {}, [](const MissingValues& each) { return std::tuple(each.why, each.from); });
  std::vector<MissingValues> all;
  for (const MissingValues& each : missing) {
    if (!all.empty() && all.back().why == each.why && each.from <= all.back().to)
      all.back().to = std::max(all.back().to, each.to);
    else
      all.push_back(each);
  }
  return all;
}

}  // namespace widgets
