// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotcontrol {
class Request;
}

namespace robotlink {

// Validates EditScene requests and finds the files that they name, for the table of RequestKinds.cpp.

/// Returns the problem with such a request, independent of the scene; empty if it is valid.
std::string wrongSceneEdit(const robotcontrol::Request& request);
/// Returns the model's file that it names; empty if the model is to be found by its name, on the search path
/// that a local user has chosen.
std::string fileOfSceneEdit(const robotcontrol::Request& request);

}  // namespace robotlink
