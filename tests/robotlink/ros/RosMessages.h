// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <string>
#include <vector>

#include "robotlink/ros/RosType.h"

namespace robotlink::ros::test {

/// Bytes from digits in pairs; everything else is left out. "00 01" are two.
inline std::vector<std::uint8_t> bytesOf(const std::string& hex) {
  std::string digits;
  for (const char c : hex)
    if (std::isxdigit(static_cast<unsigned char>(c)) != 0) digits += c;
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(digits.substr(i, 2), nullptr, 16)));
  return bytes;
}

/// How messages of a definition are written.
struct Encodings {
  std::string schema, message;
};
inline const Encodings kRos2{"ros2msg", "cdr"};
inline const Encodings kRos1{"ros1msg", "ros1"};

/// What fuzzers take: the encoding of the schema, that of the messages, the type's name, a line each, its
/// definition up to a NUL, and a message.
inline std::string fuzzInput(const Encodings& encodings, const std::string& name,
                             const std::string& definition, const std::string& hex) {
  const auto bytes = bytesOf(hex);
  return encodings.schema + "\n" + encodings.message + "\n" + name + "\n" + definition +
         std::string(1, '\0') + std::string(bytes.begin(), bytes.end());
}

/// The message of such an input; null if its definition or its bytes are refused.
inline PackagePtr messageOfFuzzInput(std::string rest) {
  const auto take = [&rest](char end) {
    const std::size_t at = std::min(rest.find(end), rest.size());
    const std::string taken = rest.substr(0, at);
    rest.erase(0, std::min(at + 1, rest.size()));
    return taken;
  };
  const std::string schema = take('\n'), encoding = take('\n'), name = take('\n'), definition = take('\0');
  const auto type = RosType::of(name, schema, definition, encoding);
  if (!type) return nullptr;
  const auto message =
      RosType::read(*type, {reinterpret_cast<const std::uint8_t*>(rest.data()), rest.size()});
  return message ? PackagePtr(*message) : nullptr;
}

/// The values of a message as Protobuf's text, or what is wrong with it or its definition.
inline std::string decoded(const std::string& definition, const std::string& hex,
                           const Encodings& encodings = kRos2, const std::string& name = "p/msg/M") {
  const auto type = RosType::of(name, encodings.schema, definition, encodings.message);
  if (!type) return type.error().describe();
  const auto message = RosType::read(*type, bytesOf(hex));
  return message ? (*message)->ShortDebugString() : message.error().text;
}

}  // namespace robotlink::ros::test
