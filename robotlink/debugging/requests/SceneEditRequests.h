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
/// The model's file that it names; empty if the model is to be found by its name, on the search path that
/// somebody here has chosen.
std::string fileOfSceneEdit(const robotcontrol::Request& request);

}  // namespace robotlink
