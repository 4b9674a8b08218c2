// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/TimelineCommands.h"

#include <algorithm>
#include <cmath>

#include "app/core/ChangeSteps.h"
#include "app/core/CommandValues.h"
#include "app/core/HistoryKeeper.h"
#include "app/core/OpenPlatform.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;
using robotlink::Session;

/// Logs have an instant of their own, at which programs run.
Result<void> checkNoLog(Session& session, const std::string& instead) {
  if (session.store().find(robotlink::streams::kReplay) == nullptr) return {};
  return failure("timeline.log", "a log is open; use " + instead, {}, {instead});
}

/// Returns the number of steps from a command's argument.
Result<int> stepsOf(double count) {
  if (count != 0 && std::trunc(count) == count && std::abs(count) <= 1e6) return static_cast<int>(count);
  return failure("timeline.count",
                 "the count must be a whole number other than 0; negative counts go backward");
}

Result<std::uint64_t> bytesOfMib(double mib) {
  if (mib >= 0 && mib <= 1e9) return static_cast<std::uint64_t>(mib * (1U << 20U));
  return failure("timeline.bytes", "the size must be a number of MiB, 0 or more");
}

Result<void> seek(Session& session, double seconds) {
  if (!std::isfinite(seconds) || std::abs(seconds) > 1e9) {
    return failure("timeline.time", "the time must be a number of seconds");
  }
  const auto& timeline = session.timeline();
  const auto time = robotlink::fromSeconds(seconds);
  session.history().show((seconds < 0 ? timeline.newest() : timeline.origin()) + time);
  return {};
}

}  // namespace

void addTimelineCommands(robotlink::CommandTable& commands, OpenPlatform& open, ChangeSteps& steps) {
  Session& session = open.session();
  commands.attach("timeline.pause", [&session](const Values&) -> Result<void> {
    if (auto ready = checkNoLog(session, "log.pause"); !ready) return ready;
    session.history().pause();
    return {};
  });
  commands.attach("timeline.live", [&session](const Values&) -> Result<void> {
    session.history().goLive();
    return {};
  });
  commands.attach("timeline.seek", [&session](const Values& values) -> Result<void> {
    if (auto ready = checkNoLog(session, "log.jump SECONDS"); !ready) return ready;
    return seek(session, number(values, 0));
  });
  commands.attach("timeline.step", [&session](const Values& values) -> Result<void> {
    if (auto ready = checkNoLog(session, "log.step"); !ready) return ready;
    const auto count = stepsOf(number(values, 0));
    if (!count) return tl::unexpected(count.error());
    return session.history().stepFrames(session.selectedRobot(), *count);
  });
  commands.attach("timeline.step-message", [&session](const Values& values) -> Result<void> {
    if (auto ready = checkNoLog(session, "log.step-message STREAM"); !ready) return ready;
    const auto count = stepsOf(number(values, 1));
    if (!count) return tl::unexpected(count.error());
    return session.history().step(text(values, 0), *count);
  });
  commands.attach("timeline.step-change", [&steps](const Values& values) {
    ChangeSteps::Step step{text(values, 0), text(values, 1) == "next"};
    if (values.size() > 2) step.limit = number(values, 2);
    return steps.begin(step);
  });
  commands.attach("timeline.memory", [&open](const Values& values) -> Result<void> {
    const auto bytes = bytesOfMib(number(values, 0));
    return bytes ? open.history().setMemory(*bytes) : tl::unexpected(bytes.error());
  });
  commands.attach("timeline.disk", [&open](const Values& values) -> Result<void> {
    const auto bytes = bytesOfMib(number(values, 0));
    return bytes ? open.history().setDisk(*bytes) : tl::unexpected(bytes.error());
  });
}

}  // namespace app
