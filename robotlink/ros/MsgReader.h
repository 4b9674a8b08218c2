// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "robotlink/base/Error.h"
#include "robotlink/ros/Definition.h"

namespace robotlink::ros {

/// The version of ROS that a definition was written for; the versions share names of types, but not all of
/// their meanings.
enum class Version { kRos1, kRos2 };

/// Reads a message definition (.msg) with those of everything that it contains, as logs and servers have them
/// (schema encodings ros1msg and ros2msg): the message's own first, each further one behind a line of '=' and
/// a line "MSG: package/Name". Default values are accepted and ignored: messages hold all values. Constants
/// right before an integer field of their type are taken for the names of its values, if one of them is 0.
///
/// Errors have the line in the text; the file in them is `name`. Pure function.
Result<Definitions> readMsg(const std::string& name, std::string_view text, Version version);

}  // namespace robotlink::ros
