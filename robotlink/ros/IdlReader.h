// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "robotlink/base/Error.h"
#include "robotlink/ros/Definition.h"

namespace robotlink::ros {

/// Reads a message definition in OMG IDL (.idl) with those of everything that it contains, as logs and
/// servers have them (schema encodings ros2idl and omgidl): several files, each perhaps behind a line of '='
/// and a line "IDL: name". Read are modules, structs, enumerations, typedefs and constants; annotations are
/// ignored except @value. Arrays of several dimensions have all their values in one list. Not read are
/// unions, bit masks, structs with a base, optional members, and sequences of lists.
///
/// Errors have the line in the text; the file in them is `name`. Pure function.
Result<Definitions> readIdl(const std::string& name, std::string_view text);

}  // namespace robotlink::ros
