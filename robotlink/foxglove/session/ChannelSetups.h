// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "robotlink/foxglove/server/ServerChannel.h"

namespace google::protobuf {
class Descriptor;
}
namespace robotcontrol {
class KeyTable;
class ProcessTable;
}  // namespace robotcontrol

namespace robotlink::websocket {

// How the streams of a session are offered as channels. Pure functions.

/// The channel of a path for messages of a type, encoded as protobuf.
ChannelSetup setupOf(const std::string& path, const google::protobuf::Descriptor& type);

/// The channels of what a robot's debug keys publish, also if nothing was published yet: one for each key
/// whose type is known, and those of the stopwatches of all processes. Those that are offered already are
/// left out, since their schemas are large.
std::vector<ChannelSetup> keyChannels(const std::string& robot, const robotcontrol::KeyTable& keys,
                                      const robotcontrol::ProcessTable& processes,
                                      const std::function<bool(const std::string& path)>& isOffered);

}  // namespace robotlink::websocket
