// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/decoding/JsonType.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "robotlink/decoding/JsonSchema.h"
#include "robotlink/decoding/JsonText.h"
#include "robotlink/decoding/JsonValues.h"
#include "robotlink/packages/DynamicTypes.h"

namespace robotlink {

using google::protobuf::Descriptor;
using google::protobuf::DescriptorPool;
using google::protobuf::FieldDescriptor;
using google::protobuf::FileDescriptorProto;
using google::protobuf::Message;
using nlohmann::json;

namespace {

std::string_view viewOf(std::span<const std::uint8_t> data) {
  return {reinterpret_cast<const char*>(data.data()), data.size()};
}

/// A type and all types that it uses directly or indirectly.
std::vector<const Descriptor*> reachable(const Descriptor& type) {
  std::vector<const Descriptor*> found{&type};
  for (std::size_t next = 0; next < found.size(); ++next) {
    for (int i = 0; i < found[next]->field_count(); ++i) {
      const Descriptor* inner = found[next]->field(i)->message_type();
      if (inner != nullptr && std::find(found.begin(), found.end(), inner) == found.end())
        found.push_back(inner);
    }
  }
  return found;
}

JsonFields fieldsOf(const Descriptor& type) {
  JsonFields fields;
  for (const Descriptor* each : reachable(type)) {
    for (int i = 0; i < each->field_count(); ++i) {
      fields[each][each->field(i)->json_name()] = each->field(i);
      fields[each][each->field(i)->name()] = each->field(i);
    }
  }
  return fields;
}

}  // namespace

struct JsonType::Implementation {
  bool takeOwn(const std::string& wanted, const JsonSchema& schema);
  bool build(JsonSchema& schema, const std::string& wanted, bool apart);

  std::string name;
  SilentErrors silence;
  DescriptorPool pool;
  google::protobuf::DynamicMessageFactory factory{&pool};
  const Message* prototype = nullptr;
  const FieldDescriptor* others = nullptr;  // null for this program's own types, which have no such field
  JsonFields fields;
};

/// Uses one of this program's types, if it has everything that the schema contains.
bool JsonType::Implementation::takeOwn(const std::string& wanted, const JsonSchema& schema) {
  const Descriptor* known = DescriptorPool::generated_pool()->FindMessageTypeByName(wanted);
  if (known == nullptr) return false;
  JsonFields all = fieldsOf(*known);
  for (const auto& [property, field] : schema.fields()) {
    if (property.first == schema.typeName() && !all[known].contains(property.second)) return false;
  }
  name = wanted;
  prototype = google::protobuf::MessageFactory::generated_factory()->GetPrototype(known);
  fields = std::move(all);
  return true;
}

bool JsonType::Implementation::build(JsonSchema& schema, const std::string& wanted, bool apart) {
  addTimeTypes(pool);
  const FileDescriptorProto file = schema.describe(wanted, apart ? "json" : "");
  if (pool.BuildFileCollectingErrors(file, &silence) == nullptr) return false;
  const Descriptor* type = pool.FindMessageTypeByName(schema.typeName());
  if (type == nullptr) return false;
  name = type->full_name();
  prototype = factory.GetPrototype(type);
  others = type->FindFieldByName(schema.otherFields());
  for (const auto& [property, fieldName] : schema.fields()) {
    const Descriptor* of = pool.FindMessageTypeByName(property.first);
    const FieldDescriptor* field = of != nullptr ? of->FindFieldByName(fieldName) : nullptr;
    if (field != nullptr) fields[of][property.second] = field;
  }
  return true;
}

JsonType::JsonType(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

JsonType::~JsonType() = default;

std::shared_ptr<const JsonType> JsonType::make(const std::string& name, const json& root, bool mayBeEmpty) {
  auto made = std::make_unique<Implementation>();
  // The properties of the schema are known after describe().
  JsonSchema look(root);
  (void)look.describe(name, "");
  if (look.fields().empty() && !mayBeEmpty) return nullptr;
  if (!made->takeOwn(name, look)) {
    const bool taken = DescriptorPool::generated_pool()->FindMessageTypeByName(name) != nullptr;
    JsonSchema description(root);
    if (!made->build(description, name, taken)) return nullptr;
  }
  return std::shared_ptr<const JsonType>(new JsonType(std::move(made)));
}

std::shared_ptr<const JsonType> JsonType::ofSchema(const std::string& name, const std::string& schema) {
  const auto root = parseJsonObject(schema);
  return root ? make(name, *root, false) : nullptr;
}

std::shared_ptr<const JsonType> JsonType::ofMessage(const std::string& name,
                                                    std::span<const std::uint8_t> message) {
  const auto value = parseJsonObject(viewOf(message));
  return value ? make(name, JsonSchema::ofValue(*value), true) : nullptr;
}

const std::string& JsonType::name() const {
  return implementation_->name;
}

PackagePtr JsonType::read(const std::shared_ptr<const JsonType>& type, std::span<const std::uint8_t> data) {
  const auto value = parseJsonObject(viewOf(data));
  if (!value) return nullptr;
  const Implementation& self = *type->implementation_;
  const std::shared_ptr<Message> message(self.prototype->New(),
                                         [keep = type](const Message* dead) { delete dead; });
  json others = json::object();
  assignJson(*message, *value, self.fields, others);
  if (!others.empty() && self.others != nullptr) {
    message->GetReflection()->SetString(message.get(), self.others, jsonText(others));
  }
  return message;
}

}  // namespace robotlink
