// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/ShownMap.h"

#include "robotcontrol/Driving.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"

namespace widgets {

std::shared_ptr<const robotcontrol::GroundMap> shownMap(robotlink::Session& session) {
  const auto* stream = session.store().find(robotlink::streams::kMap);
  const auto* message = session.store().latest(robotlink::streams::kMap, session.timeline().shown());
  if (message == nullptr && stream != nullptr && !stream->messages.empty())
    message = &stream->messages.front();
  return message == nullptr ? nullptr
                            : std::dynamic_pointer_cast<const robotcontrol::GroundMap>(message->value);
}

}  // namespace widgets
