// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

// A parsed ROS message definition (.msg or .idl). Plain values.
namespace robotlink::ros {

/// The type of one value.
enum class Kind {
  kBool,
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
  kString,
  /// UTF-16.
  kWstring,
  /// Seconds and nanoseconds since the epoch, 32 bits each.
  kTime,
  /// Seconds and nanoseconds of a difference of times, 32 bits each.
  kDuration,
  /// A message, or struct.
  kStruct
};

/// How many values a field holds.
enum class Shape {
  kSingle,
  /// A fixed-length array; its length is in the definition and not on the wire.
  kArray,
  /// A count, then as many values.
  kSequence
};

struct Field {
  std::string name;
  Kind kind = Kind::kStruct;
  /// The key of a struct in Definitions; empty for other kinds.
  std::string structName;
  Shape shape = Shape::kSingle;
  /// The number of values of an array; the maximum for a sequence, 0 if it has none.
  std::uint64_t count = 0;
  /// The names of values, if the definition lists them for this field. They have distinct names.
  std::vector<std::pair<std::string, std::int32_t>> enumerators;
  bool operator==(const Field&) const = default;
};

struct Struct {
  std::vector<Field> fields;
  bool operator==(const Struct&) const = default;
};

/// A message with everything that it contains, directly or not. No struct contains itself.
struct Definitions {
  /// The key of the message.
  std::string root;
  /// Keyed by name: "sensor_msgs/Image", without "msg" in the middle.
  std::map<std::string, Struct> structs;
  bool operator==(const Definitions&) const = default;
};

/// The key in Definitions for a name as ROS 1 ("sensor_msgs/Image"), ROS 2 ("sensor_msgs/msg/Image") or IDL
/// ("sensor_msgs::msg::Image") have it.
std::string structKey(const std::string& name);

}  // namespace robotlink::ros
