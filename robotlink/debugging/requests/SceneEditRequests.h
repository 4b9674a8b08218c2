// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotcontrol {
class Request;
}

namespace robotlink {

// What the table of kinds of requests knows of EditScene.

/// What is wrong with such a request, whatever the scene is; empty: nothing.
std::string wrongSceneEdit(const robotcontrol::Request& request);
/// The model's file that it names; empty if the model is to be found by its name, on the search path that
/// somebody here has chosen.
std::string fileOfSceneEdit(const robotcontrol::Request& request);

}  // namespace robotlink
