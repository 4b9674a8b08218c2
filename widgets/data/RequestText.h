// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Error.h"

// Requests as JSON that a person fills in: the fields of one alternative of robotcontrol.Request. Include
// this in sources only, since it exposes protobuf.
namespace widgets {

/// A kind of request that can be written as text.
struct RequestForm {
  robotcontrol::Request::WhatCase what;
  std::string title;  ///< for users: "set goal"
  /// All of its fields with the values they have by default; of alternatives the first one.
  std::string json;
};

/// All kinds, sorted by title. Those with binary contents (color tables, parameters), which no one types, are
/// left out.
std::vector<RequestForm> requestForms();

/// The request of this kind, for a robot (unless it is one to the simulation, the replay or the recording,
/// which are asked for all robots), with the fields in the text. Fails if the text is no such JSON, with the
/// field that is wrong, or if nobody could fulfill the request.
robotlink::Result<robotcontrol::Request> readRequest(robotcontrol::Request::WhatCase what,
                                                     const std::string& robot, const std::string& json);

}  // namespace widgets
