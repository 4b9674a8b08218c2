// SPDX-License-Identifier: GPL-3.0-or-later
// Validates requests that manipulate a simulated world, for the table of RequestKinds.cpp.
// Each function returns a sentence for users, or nothing; a request of another kind is not passed to it.
#pragma once

#include <string>

namespace robotcontrol {
class Request;
}

namespace robotlink {

std::string wrongTurn(const robotcontrol::Request& request);
std::string wrongThrow(const robotcontrol::Request& request);
std::string wrongPin(const robotcontrol::Request& request);
std::string wrongDrag(const robotcontrol::Request& request);
std::string wrongPush(const robotcontrol::Request& request);
std::string wrongForceReading(const robotcontrol::Request& request);
std::string wrongSnapshots(const robotcontrol::Request& request);
/// The file that a request for a snapshot names; empty: none.
std::string fileOfSnapshot(const robotcontrol::Request& request);

}  // namespace robotlink
