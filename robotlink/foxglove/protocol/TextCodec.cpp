// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON half of MessageCodec.h: messages of the WebSocket protocol as text.
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "robotlink/base/Utf8.h"
#include "robotlink/foxglove/protocol/Base64.h"
#include "robotlink/foxglove/protocol/Fields.h"
#include "robotlink/foxglove/protocol/FrameCodec.h"
#include "robotlink/foxglove/protocol/MessageCodec.h"

namespace robotlink::websocket {
namespace {

using Json = nlohmann::json;

constexpr std::uint32_t kNanoseconds = 1'000'000'000;

/// A sentence that is longer than the limit is cut, rather than lost with its message.
std::string shortSentence(const std::string& text) {
  return text.size() <= kMaxName ? text : validUtf8(text.substr(0, kMaxName));  // this may split a character
}

bool isBinarySchema(std::string_view encoding) {
  return encoding == "protobuf" || encoding == "flatbuffer";
}

// Writing. Not-a-number and infinity have no JSON; they become null.

Json written(const Value& value) {
  return std::visit(
      []<typename One>(const One& one) -> Json {
        if constexpr (std::same_as<One, Value::Bytes>) {
          return toBase64({reinterpret_cast<const char*>(one.data()), one.size()});
        } else if constexpr (std::same_as<One, Value::Array>) {
          Json array = Json::array();
          for (const Value& item : one) array.push_back(written(item));
          return array;
        } else if constexpr (std::same_as<One, Value::Object>) {
          Json object = Json::object();
          for (const auto& [name, item] : one) object[name] = written(item);
          return object;
        } else {
          return one;
        }
      },
      value.data);
}

const char* typeOf(const Value& value) {
  if (std::holds_alternative<double>(value.data)) return "float64";
  if (std::holds_alternative<Value::Bytes>(value.data)) return "byte_array";
  const auto* array = std::get_if<Value::Array>(&value.data);
  if (array == nullptr || array->empty()) return nullptr;
  for (const Value& item : *array)
    if (!std::holds_alternative<double>(item.data)) return nullptr;
  return "float64_array";
}

Json written(const Parameter& parameter) {
  Json object{{"name", parameter.name}};
  if (!parameter.value) return object;
  object["value"] = written(*parameter.value);
  if (const char* type = typeOf(*parameter.value)) object["type"] = type;
  return object;
}

template <typename Message>
void writeFields(Json& object, const Message& message);

template <typename T>
Json written(const T& value) {
  if constexpr (std::is_constructible_v<Json, T> || std::is_arithmetic_v<T>) {
    return value;
  } else {
    Json object = Json::object();
    writeFields(object, value);
    return object;
  }
}

template <typename T>
Json written(const std::vector<T>& values) {
  Json array = Json::array();
  for (const T& value : values) array.push_back(written(value));
  return array;
}

class JsonWriter {
 public:
  explicit JsonWriter(Json& object) : object_(object) {}

  template <typename T>
  void field(const char* key, const T& value) {
    object_[key] = written(value);
  }
  template <typename T>
  void option(const char* key, const T& value) {
    if (!value.empty()) field(key, value);
  }
  template <typename T>
  void part(const char* key, const T& value) {
    field(key, value);
  }
  void sentence(const char* key, const std::string& text) { field(key, shortSentence(text)); }
  void schema(const std::string& encoding, const std::string& schema) {
    field("schema", isBinarySchema(encoding) ? toBase64(schema) : schema);
  }
  template <typename Choice>
  void choice(const char* key, Choice value, Choice) {
    field(key, static_cast<int>(value));
  }
  void time(const char* key, const std::optional<Instant>& time) {
    if (!time) return;
    const std::uint64_t count = wireTime(*time);
    object_[key] = {{"sec", count / kNanoseconds}, {"nsec", count % kNanoseconds}};
  }
  void ids(const char* key, const char* idsKey, const ConnectionGraphUpdate::Ids& names) {
    Json array = Json::array();
    for (const auto& [name, ids] : names) array.push_back({{"name", name}, {idsKey, ids}});
    object_[key] = std::move(array);
  }

 private:
  Json& object_;
};

template <typename Message>
void writeFields(Json& object, const Message& message) {
  JsonWriter writer(object);
  fields(writer, message);
}

// Reading. A problem is a text such as ".channels[2].id must be ...", or empty.

using Problem = std::string;

template <std::unsigned_integral Number>
Problem read(const Json& json, Number& value) {
  constexpr auto kMax = std::numeric_limits<Number>::max();
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > kMax)
    return " must be a whole number from 0 to " + std::to_string(kMax);
  value = json.get<Number>();
  return {};
}

Problem read(const Json& json, std::string& value) {
  if (!json.is_string()) return " must be a text";
  value = json.get_ref<const std::string&>();
  return value.size() <= kMaxName ? Problem() : " is longer than " + std::to_string(kMaxName) + " bytes";
}

Problem read(const Json& json, std::map<std::string, std::string>& values) {
  if (!json.is_object()) return " must be an object";
  for (const auto& [key, item] : json.items())
    if (const Problem problem = read(item, values[key]); !problem.empty()) return "." + key + problem;
  return {};
}

/// The depth of the JSON bounds how deep this calls itself.
Problem read(const Json& json, Value& value) {
  Problem problem;
  if (json.is_boolean()) {
    value.data = json.get<bool>();
  } else if (json.is_number_integer() &&
             !(json.is_number_unsigned() && json.get<std::uint64_t>() > INT64_MAX)) {
    value.data = json.get<std::int64_t>();
  } else if (json.is_number()) {
    value.data = json.get<double>();
  } else if (json.is_string()) {
    value.data = json.get<std::string>();
  } else if (json.is_array()) {
    auto& items = value.data.emplace<Value::Array>(json.size());
    for (std::size_t i = 0; i < json.size(); ++i)
      if (problem = read(json[i], items[i]); !problem.empty()) return "[" + std::to_string(i) + "]" + problem;
  } else if (json.is_object()) {
    auto& items = value.data.emplace<Value::Object>();
    for (const auto& [key, item] : json.items())
      if (problem = read(item, items[key]); !problem.empty()) return "." + key + problem;
  } else {
    return " must not be null";
  }
  return problem;
}

Problem readFloat(const Json& json, Value& value) {
  if (!json.is_number() && !json.is_null()) return " must be a number";
  value.data = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
  return {};
}

Problem readTyped(const Json& json, const std::string& type, Value& value) {
  if (type == "float64") return readFloat(json, value);
  if (type == "byte_array") {
    const auto bytes = json.is_string() ? fromBase64(json.get_ref<const std::string&>()) : std::nullopt;
    if (!bytes) return " must be base64, as its type is byte_array";
    value.data = Value::Bytes(bytes->begin(), bytes->end());
    return {};
  }
  if (type != "float64_array") return read(json, value);
  if (!json.is_array()) return " must be an array, as its type is float64_array";
  auto& items = value.data.emplace<Value::Array>(json.size());
  for (std::size_t i = 0; i < json.size(); ++i)
    if (Problem problem = readFloat(json[i], items[i]); !problem.empty())
      return "[" + std::to_string(i) + "]" + problem;
  return {};
}

class JsonReader {
 public:
  explicit JsonReader(const Json& object) : object_(object) {}

  template <typename T>
  void field(const char* key, T& value);
  template <typename T>
  void option(const char* key, T& value) {
    if (object_.contains(key)) field(key, value);
  }
  template <typename T>
  void part(const char* key, T& value) {
    option(key, value);
  }
  void sentence(const char* key, std::string& text) {
    if (!problem_.empty()) return;
    const auto found = object_.is_object() ? object_.find(key) : object_.end();
    if (found == object_.end() || !found->is_string()) return field(key, text);  // this reports the problem
    text = shortSentence(found->get_ref<const std::string&>());
  }
  void schema(const std::string& encoding, std::string& schema) {
    if (!problem_.empty() || !object_.contains("schema")) return;
    const Json& json = object_["schema"];
    if (!json.is_string()) return blame("schema", " must be a text");
    schema = json.get_ref<const std::string&>();
    if (!isBinarySchema(encoding)) return;
    auto bytes = fromBase64(schema);
    if (!bytes) return blame("schema", " must be base64, as its encoding is " + encoding);
    schema = *std::move(bytes);
  }
  template <typename Choice>
  void choice(const char* key, Choice& value, Choice last) {
    std::uint32_t number = 0;
    field(key, number);
    if (number > static_cast<std::uint32_t>(last))
      return blame(key, " must be at most " + std::to_string(static_cast<int>(last)));
    value = static_cast<Choice>(number);
  }
  void time(const char* key, std::optional<Instant>& time) {
    if (!problem_.empty() || !object_.contains(key)) return;
    std::uint32_t sec = 0, nsec = 0;
    JsonReader reader(object_[key]);
    reader.field("sec", sec);
    reader.field("nsec", nsec);
    if (!reader.problem().empty()) return blame(key, reader.problem());
    if (nsec >= kNanoseconds) return blame(key, ".nsec must be below 1000000000");
    time = Instant(Duration(std::int64_t{sec} * kNanoseconds + nsec));
  }
  void ids(const char* key, const char* idsKey, ConnectionGraphUpdate::Ids& names) {
    std::vector<Json> items;
    field(key, items);
    for (std::size_t i = 0; i < items.size() && problem_.empty(); ++i) {
      std::string name;
      JsonReader reader(items[i]);
      reader.field("name", name);
      reader.field(idsKey, names[name]);
      if (!reader.problem().empty()) blame(key, "[" + std::to_string(i) + "]" + reader.problem());
    }
  }

  const Problem& problem() const { return problem_; }

 private:
  void blame(const char* key, const Problem& problem) {
    if (problem_.empty()) problem_ = std::string(".") + key + problem;
  }

  const Json& object_;
  Problem problem_;
};

Problem read(const Json& json, Json& value) {
  value = json;
  return {};
}

Problem read(const Json& json, Parameter& parameter) {
  std::string type;
  JsonReader reader(json);
  reader.field("name", parameter.name);
  reader.option("type", type);
  if (!reader.problem().empty() || !json.contains("value")) return reader.problem();
  const Problem problem = readTyped(json["value"], type, parameter.value.emplace());
  return problem.empty() ? problem : ".value" + problem;
}

template <typename Message>
Problem read(const Json& json, Message& message) {
  JsonReader reader(json);
  fields(reader, message);
  return reader.problem();
}

template <typename T>
Problem read(const Json& json, std::vector<T>& values) {
  if (!json.is_array()) return " must be an array";
  values.resize(json.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const Problem problem = read(json[i], values[i]); !problem.empty())
      return "[" + std::to_string(i) + "]" + problem;
  return {};
}

template <typename T>
void JsonReader::field(const char* key, T& value) {
  if (!problem_.empty()) return;
  if (!object_.is_object()) {
    problem_ = " must be an object";
    return;
  }
  const auto found = object_.find(key);
  if (found == object_.end()) return blame(key, " is missing");
  if (const Problem problem = read(*found, value); !problem.empty()) blame(key, problem);
}

// Whole messages.

template <typename Variant>
std::string textOf(const Variant& message) {
  Json object = Json::object();
  std::visit(
      [&]<typename One>(const One& one) {
        if constexpr (IsText<One>) {
          object["op"] = One::kOp;
          writeFields(object, one);
        }
      },
      message);
  return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Looks at brackets outside of texts only; invalid JSON is found later.
bool isTooDeep(std::string_view text) {
  int depth = 0;
  bool isText = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') isText = !isText;
    if (isText) {
      i += c == '\\' ? 1 : 0;
    } else if (c == '[' || c == '{') {
      if (++depth > kMaxJsonDepth) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

Result<Json> parse(std::string_view text) {
  if (isTooDeep(text))
    return failure("foxglove.json",
                   "a message is nested deeper than " + std::to_string(kMaxJsonDepth) + " levels");
  try {
    Json json = Json::parse(text);
    if (json.is_object() && json.contains("op") && json["op"].is_string()) return json;
  } catch (const Json::exception& error) {
    return failure("foxglove.json", std::string("a message is not JSON: ") + error.what());
  }
  return failure("foxglove.json", "a message must be a JSON object with a text called op");
}

/// Reads the JSON as this message, if it has its op.
template <typename Message, typename Variant>
bool tryRead(const std::string& op, const Json& json, Result<Variant>& result) {
  if constexpr (IsText<Message>) {
    if (op != Message::kOp) return false;
    Message message;
    if (const Problem problem = read(json, message); !problem.empty())
      result = failure("foxglove.json", op + ": " + problem.substr(problem[0] == '.' ? 1 : 0));
    else
      result = std::move(message);
    return true;
  }
  return false;
}

template <typename... Messages>
Result<std::variant<Messages...>> readAny(std::string_view text, const std::variant<Messages...>*) {
  const auto json = parse(text);
  if (!json) return tl::unexpected(json.error());
  const std::string op = (*json)["op"].get<std::string>();
  Result<std::variant<Messages...>> result;
  if (!(tryRead<Messages>(op, *json, result) || ...))
    return failure("foxglove.json", "there is no message called '" + op.substr(0, 100) + "'");
  return result;
}

}  // namespace

std::string encodeText(const ServerMessage& message) {
  return textOf(message);
}

std::string encodeText(const ClientMessage& message) {
  return textOf(message);
}

Result<ServerMessage> decodeServerText(std::string_view text) {
  return readAny(text, static_cast<const ServerMessage*>(nullptr));
}

Result<ClientMessage> decodeClientText(std::string_view text) {
  return readAny(text, static_cast<const ClientMessage*>(nullptr));
}

}  // namespace robotlink::websocket
