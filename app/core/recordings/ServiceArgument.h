// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/foxglove/protocol/ClientMessages.h"
#include "robotlink/foxglove/protocol/ServerMessages.h"

namespace app {

// Services whose arguments and answers are JSON objects, without messages of their own. Pure functions.

/// A member that the argument of a service may have.
struct ArgumentMember {
  std::string name;
  /// Whether its value is a whole number that is not negative; else it is a text.
  bool isNumber = false;
};

/// The service of a name, "recordings/read", with a schema of its argument, "recordings.ReadRequest".
robotlink::websocket::Service jsonService(const std::string& name,
                                          const std::vector<ArgumentMember>& members);

/// The argument of a call of such a service; an empty payload is {}. Fails, with a sentence for the caller,
/// for what is no JSON object, for a member that is none of these, and for a value of another type.
robotlink::Result<nlohmann::json> argumentOfCall(const std::string& name,
                                                 const std::vector<ArgumentMember>& members,
                                                 const robotlink::websocket::ServiceCallRequest& call);

/// The text of a member of an argument; empty if it has none.
std::string textMember(const nlohmann::json& argument, const char* member);
/// The number of a member of an argument; `otherwise` if it has none.
std::uint64_t numberMember(const nlohmann::json& argument, const char* member, std::uint64_t otherwise);

}  // namespace app
