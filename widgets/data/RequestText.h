// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Error.h"

namespace robotlink {
class Session;
}

// Requests as JSON that a person fills in: the fields of one alternative of robotcontrol.Request. Include
// this in sources only, since it exposes protobuf.
namespace widgets {

/// A kind of request that can be written as text.
struct RequestForm {
  robotcontrol::Request::WhatCase what;
  std::string title;  ///< for users: "set goal"
  /// All of its fields with the values they have by default; of alternatives the first one.
  std::string json;
  std::string package = {};  ///< whose value the fields are; empty: they are those of the request itself
};

/// All kinds, sorted by title. Those with binary contents (color tables, parameters), which no one types, are
/// left out.
std::vector<RequestForm> requestForms();

/// All packages that a program can have, sorted: "package models/ball".
std::vector<RequestForm> packageForms();
/// The request that puts a package with the fields in the text in place of what a robot's program offers, or
/// releases it; the text then does not matter. Fails as packageFromJson() does.
robotlink::Result<robotcontrol::Request> readPackage(const std::string& package,
                                                     robotcontrol::SetPackage::Mode mode,
                                                     const std::string& robot, const std::string& json);

/// The request of this kind, for a robot (unless it is one to the simulation, the replay or the recording,
/// which are for all robots), with the fields in the text. Fails if the text is not such JSON, with the
/// field that is wrong, or if the request could not be fulfilled.
robotlink::Result<robotcontrol::Request> readRequest(robotcontrol::Request::WhatCase what,
                                                     const std::string& robot, const std::string& json);

/// The titles of all kinds, each as one word of a command line: "set-goal".
std::vector<std::string> requestWords();
/// Sends a request once. `kind`: its title or the word for it. `json`: its fields; empty: as by default.
/// `robot`: empty for the selected one. Fails if it cannot be sent; the receiver may refuse it later,
/// which the session's refusal handler gets. GUI thread.
robotlink::Result<void> publish(robotlink::Session& session, const std::string& kind, const std::string& json,
                                const std::string& robot);

}  // namespace widgets
