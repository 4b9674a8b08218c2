// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "robotlink/base/Error.h"
#include "robotlink/ros/Definition.h"

namespace robotlink::ros {

/// Limits of what one message may contain; definitions come from untrusted files. Protobuf supports 100
/// levels.
inline constexpr int kMaxDepth = 64;
inline constexpr std::size_t kMaxFields = 10'000;

/// Finds the struct of each field of `root` and of what it contains. In `parsed` the name of a field's struct
/// is as it was written: with its package, or short for one of the same package. Structs that the root does
/// not contain are left out. Fails if a struct is missing or contains itself, or over the limits.
Result<Definitions> resolved(const std::map<std::string, Struct>& parsed, const std::string& root);

}  // namespace robotlink::ros
