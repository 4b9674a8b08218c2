// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/RosType.h"

#include <google/protobuf/arena.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/dynamic_message.h>

#include <limits>
#include <map>

#include "robotlink/packages/DynamicTypes.h"
#include "robotlink/ros/Decoder.h"
#include "robotlink/ros/Description.h"
#include "robotlink/ros/IdlReader.h"
#include "robotlink/ros/MsgReader.h"

namespace robotlink::ros {

using google::protobuf::Descriptor;
using google::protobuf::DescriptorPool;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

namespace {

Result<Definitions> readDefinition(const std::string& name, std::string_view encoding,
                                   std::string_view text) {
  if (encoding == "ros1msg") return readMsg(name, text, Version::kRos1);
  if (encoding == "ros2msg") return readMsg(name, text, Version::kRos2);
  if (encoding == "ros2idl" || encoding == "omgidl") return readIdl(name, text);
  return failure("ros.definition", "definitions in " + std::string(encoding) + " are not read", {},
                 {std::string(encoding)});
}

/// A product of sizes, at most the largest number.
std::uint64_t boundedProduct(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kMax = std::numeric_limits<std::uint32_t>::max();
  return std::min(a, kMax) * std::min(b, kMax);
}

std::uint64_t leastBytes(Kind kind) {
  switch (kind) {
    case Kind::kBool:
    case Kind::kInt8:
    case Kind::kUint8:
      return 1;
    case Kind::kInt16:
    case Kind::kUint16:
      return 2;
    case Kind::kInt32:
    case Kind::kUint32:
    case Kind::kFloat32:
    case Kind::kString:
    case Kind::kWstring:
      return 4;
    case Kind::kInt64:
    case Kind::kUint64:
    case Kind::kFloat64:
    case Kind::kTime:
    case Kind::kDuration:
      return 8;
    case Kind::kStruct:
      break;
  }
  return 0;
}

/// The memory of all parts of a message. It is destroyed before its type.
struct MessageMemory {
  explicit MessageMemory(std::shared_ptr<const RosType> of) : type(std::move(of)) {}
  std::shared_ptr<const RosType> type;
  google::protobuf::Arena arena;
};

}  // namespace

struct RosType::Implementation {
  bool build(const std::string& structName);
  const StructPlan* plan(const std::string& structName);

  Definitions definitions;
  /// In front of the names of all types; empty unless one of this program's types has the same name.
  std::string package;
  SilentErrors silence;
  DescriptorPool pool;
  google::protobuf::DynamicMessageFactory factory{&pool};
  std::map<std::string, StructPlan> plans;
  Result<void> (*decode)(std::span<const std::uint8_t>, const StructPlan&, Message&) = nullptr;
  const StructPlan* root = nullptr;
  const Message* prototype = nullptr;
  std::string name;
};

/// Builds the Protobuf types of a struct and of what it contains. Names of values that Protobuf does not
/// allow are left out.
bool RosType::Implementation::build(const std::string& structName) {
  if (pool.FindFileByName(structName) != nullptr) return true;
  const Struct& definition = definitions.structs.at(structName);
  for (const Field& field : definition.fields)
    if (field.kind == Kind::kStruct && !build(field.structName)) return false;
  for (const auto enumerations : {Enumerations::kNamed, Enumerations::kNone}) {
    const auto file = describe(structName, definition, package, enumerations);
    if (pool.BuildFileCollectingErrors(file, &silence) != nullptr) return true;
  }
  return false;
}

const StructPlan* RosType::Implementation::plan(const std::string& structName) {
  const auto [known, isNew] = plans.try_emplace(structName);
  StructPlan& plan = known->second;
  if (!isNew) return &plan;
  const Descriptor& type = *pool.FindMessageTypeByName(typeName(structName, package));
  const Struct& definition = definitions.structs.at(structName);
  constexpr std::uint64_t kMax = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t i = 0; i < definition.fields.size(); ++i) {
    const Field& field = definition.fields[i];
    const FieldDescriptor* described = type.FindFieldByNumber(fieldNumber(i));
    FieldPlan step{described, field.kind, field.shape, field.count};
    step.leastBytes = leastBytes(field.kind);
    step.isEnumeration = described->cpp_type() == FieldDescriptor::CPPTYPE_ENUM;
    if (described->message_type() != nullptr)
      step.prototype = factory.GetPrototype(described->message_type());
    if (field.kind == Kind::kStruct) {
      step.inner = this->plan(field.structName);
      step.leastBytes = step.inner->leastBytes;
    }
    const std::uint64_t least = field.shape == Shape::kSingle ? step.leastBytes
                                : field.shape == Shape::kSequence
                                    ? 4
                                    : boundedProduct(field.count, step.leastBytes);
    plan.leastBytes = std::min(kMax, plan.leastBytes + std::min(kMax, least));
    plan.fields.push_back(step);
  }
  return &plan;
}

std::string protobufName(const std::string& name) {
  return typeName(structKey(name), "");
}

RosType::RosType(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

RosType::~RosType() = default;

Result<std::shared_ptr<const RosType>> RosType::of(const std::string& name, std::string_view schemaEncoding,
                                                   std::string_view definition,
                                                   std::string_view messageEncoding) {
  auto made = std::make_unique<Implementation>();
  if (messageEncoding == "cdr") made->decode = &decodeCdr;
  if (messageEncoding == "ros1") made->decode = &decodeRos1;
  if (made->decode == nullptr) {
    const std::string encoding(messageEncoding);
    return failure("ros.encoding", "messages in " + encoding + " are not read", {}, {encoding});
  }
  auto definitions = readDefinition(name, schemaEncoding, definition);
  if (!definitions) return tl::unexpected(definitions.error());
  made->definitions = std::move(*definitions);
  const std::string& root = made->definitions.root;
  if (DescriptorPool::generated_pool()->FindMessageTypeByName(typeName(root, "")) != nullptr)
    made->package = "ros";
  addTimeTypes(made->pool);
  if (!made->build(root))
    return failure("ros.definition", "the names in the definition of " + name + " clash", {name, 0, 0},
                   {name});
  made->root = made->plan(root);
  made->name = typeName(root, made->package);
  made->prototype = made->factory.GetPrototype(made->pool.FindMessageTypeByName(made->name));
  return std::shared_ptr<const RosType>(new RosType(std::move(made)));
}

const std::string& RosType::name() const {
  return implementation_->name;
}

Result<PackagePtr> RosType::read(const std::shared_ptr<const RosType>& type,
                                 std::span<const std::uint8_t> data) {
  const Implementation& self = *type->implementation_;
  const auto memory = std::make_shared<MessageMemory>(type);
  const std::shared_ptr<Message> message(memory, self.prototype->New(&memory->arena));
  if (const auto read = self.decode(data, *self.root, *message); !read) return tl::unexpected(read.error());
  return message;
}

}  // namespace robotlink::ros
