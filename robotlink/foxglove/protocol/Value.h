// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace robotlink::websocket {

/// The value of a parameter. On the wire it is JSON with a type beside it where JSON alone does not tell:
/// "byte_array" (base64), "float64" (3.0 is not 3), "float64_array". Inside arrays and objects bytes are
/// plain texts, because no type is written there.
struct Value {
  using Bytes = std::vector<std::uint8_t>;
  using Array = std::vector<Value>;
  using Object = std::map<std::string, Value>;

  std::variant<bool, std::int64_t, double, std::string, Bytes, Array, Object> data;
  bool operator==(const Value&) const = default;
};

/// An object of numbers.
inline Value valueOf(const std::map<std::string, double>& numbers) {
  Value::Object object;
  for (const auto& [name, number] : numbers) object[name] = Value{number};
  return Value{std::move(object)};
}

/// A parameter; without a value it does not exist (any longer).
struct Parameter {
  std::string name;
  std::optional<Value> value;
  bool operator==(const Parameter&) const = default;
};

}  // namespace robotlink::websocket
