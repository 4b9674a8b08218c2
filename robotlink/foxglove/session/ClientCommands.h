// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/foxglove/protocol/ClientMessages.h"

namespace robotcontrol {
class Request;
class SolutionTable;
}  // namespace robotcontrol

namespace robotlink::websocket {

// The topics on which clients publish commands for a robot; only the newest message of each counts:
//   ROBOT/remote/motion  robotcontrol.RemoteMotion: how it moves, and its head
//   ROBOT/remote/drive   robotcontrol.DriveRequest: only how fast; 0 is to stand
//   ROBOT/remote/goal    robotcontrol.DriveGoal
// as JSON with the names of the .proto files, or serialized.

/// The topics, for sentences.
std::string commandTopics();
/// Fails if the topic is not one of these, or the schema is that of another type.
Result<void> checkCommandChannel(const ClientChannel& channel);
/// Why a robot with these solutions ignores the motion that a client commands: another solution than "obey"
/// controls it. Empty: it does not, or that is not known. A solution of another name may follow commands,
/// too.
std::string whyIgnored(const robotcontrol::Request& request, const robotcontrol::SolutionTable& solutions);
/// The request that such a message makes. Fails if it is no such message or makes no sense.
Result<robotcontrol::Request> commandOf(const ClientChannel& channel, std::string_view payload);

}  // namespace robotlink::websocket
