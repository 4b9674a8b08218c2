// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.pb.h>

#include <string>

#include "robotlink/ros/Definition.h"

namespace robotlink::ros {

/// Whether enumerations are made of the names of values.
enum class Enumerations { kNone, kNamed };

/// The full name of the Protobuf type for a struct: "sensor_msgs/Image" becomes PACKAGE.sensor_msgs.Image.
std::string typeName(const std::string& structName, const std::string& package);

/// Describes the Protobuf type for one struct, in a file named as the struct. It imports the files of the
/// structs that it contains, and google.protobuf.Timestamp and Duration. Field `i` has the number
/// fieldNumber(i); uint8[] becomes bytes, smaller integers those of 32 bits.
google::protobuf::FileDescriptorProto describe(const std::string& structName, const Struct& definition,
                                               const std::string& package, Enumerations enumerations);

int fieldNumber(std::size_t index);

}  // namespace robotlink::ros
