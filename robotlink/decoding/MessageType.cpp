// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/decoding/MessageType.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>

#include <limits>
#include <map>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/decoding/JsonType.h"
#include "robotlink/packages/DynamicTypes.h"
#include "robotlink/ros/KnownTypes.h"
#include "robotlink/ros/RosType.h"

namespace robotlink {

using google::protobuf::DescriptorPool;
using google::protobuf::FileDescriptorProto;
using google::protobuf::FileDescriptorSet;
using google::protobuf::Message;

namespace {

/// The limit of imports of imports; no schema written by hand has that many.
constexpr int kMaxImports = 100;

bool fitsProtobuf(std::size_t size) {
  return size <= static_cast<std::size_t>(std::numeric_limits<int>::max());
}

}  // namespace

struct MessageType::Dynamic {
  explicit Dynamic(FileDescriptorSet set);
  const Message* prototype(const std::string& name);
  /// `depth`: how many imports led to it.
  bool build(const std::string& file, int depth);

  std::map<std::string, FileDescriptorProto> files;  // not built yet
  SilentErrors silence;
  DescriptorPool pool;
  google::protobuf::DynamicMessageFactory factory{&pool};
};

MessageType::Dynamic::Dynamic(FileDescriptorSet set) {
  for (auto& file : *set.mutable_file()) {
    std::string name = file.name();
    files[std::move(name)] = std::move(file);
  }
}

/// Builds a file and its imports, whatever their order in the set. Each file is tried once, so that cycles
/// end, and no chain of them is followed for too long.
bool MessageType::Dynamic::build(const std::string& name, int depth) {
  if (pool.FindFileByName(name) != nullptr) return true;
  const auto found = files.find(name);
  if (found == files.end() || depth > kMaxImports) return false;
  const FileDescriptorProto file = std::move(found->second);
  files.erase(found);
  for (const std::string& import : file.dependency()) {
    if (!build(import, depth + 1)) return false;
  }
  return pool.BuildFileCollectingErrors(file, &silence) != nullptr;
}

const Message* MessageType::Dynamic::prototype(const std::string& name) {
  while (!files.empty()) build(files.begin()->first, 0);
  const auto* descriptor = pool.FindMessageTypeByName(name);
  return descriptor != nullptr ? factory.GetPrototype(descriptor) : nullptr;
}

MessageType::MessageType(const MessageSchema* schema, const std::string& messageEncoding,
                         const Sample& sample)
    : name_(schema != nullptr && !schema->name.empty() ? schema->name : "unknown"),
      encoding_(messageEncoding) {
  if (encoding_ == "json") {
    readJsonSchema(schema, sample);
  } else if (encoding_ == "protobuf" && schema != nullptr && schema->encoding == "protobuf") {
    readProtobufSchema(*schema);
  } else if (schema != nullptr) {
    readRosDefinition(*schema);
  }
}

void MessageType::readProtobufSchema(const MessageSchema& schema) {
  const auto* known = DescriptorPool::generated_pool()->FindMessageTypeByName(name_);
  if (known != nullptr) {
    prototype_ = google::protobuf::MessageFactory::generated_factory()->GetPrototype(known);
    return;
  }
  FileDescriptorSet set;
  if (!fitsProtobuf(schema.data.size()) ||
      !set.ParseFromArray(schema.data.data(), static_cast<int>(schema.data.size())))
    return;
  auto dynamic = std::make_shared<Dynamic>(std::move(set));
  prototype_ = dynamic->prototype(name_);
  dynamic_ = std::move(dynamic);
}

void MessageType::readJsonSchema(const MessageSchema* schema, const Sample& sample) {
  if (schema != nullptr && schema->encoding == "jsonschema")
    json_ = JsonType::ofSchema(name_, std::string(schema->data));
  if (json_ == nullptr && sample) {
    const std::string message = sample();
    const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(message.data()),
                                              message.size());
    if (!message.empty()) json_ = JsonType::ofMessage(schema != nullptr ? name_ : "json", bytes);
  }
  // A type with the name of one of this program's types, but another structure.
  if (json_ != nullptr && DescriptorPool::generated_pool()->FindMessageTypeByName(name_) != nullptr)
    name_ = json_->name();
}

void MessageType::readRosDefinition(const MessageSchema& schema) {
  const auto type = ros::RosType::of(name_, schema.encoding, schema.data, encoding_);
  if (!type) return;
  ros_ = *type;
  knownRosType_ = ros::knownType(ros_->name());
  if (knownRosType_ != nullptr) name_ = knownRosType_->target()->full_name();
  // A type with the name of one of this program's types, but another structure.
  else if (DescriptorPool::generated_pool()->FindMessageTypeByName(name_) != nullptr)
    name_ = ros_->name();
}

std::string MessageType::expectedName(const std::string& schemaName, const std::string& messageEncoding) {
  const bool isRos = messageEncoding == "cdr" || messageEncoding == "ros1";
  const ros::KnownType* known = isRos ? ros::knownType(ros::protobufName(schemaName)) : nullptr;
  return known != nullptr ? known->target()->full_name() : schemaName;
}

MessageType::~MessageType() = default;
MessageType::MessageType(MessageType&&) noexcept = default;
MessageType& MessageType::operator=(MessageType&&) noexcept = default;

PackagePtr MessageType::read(std::span<const std::uint8_t> data) const {
  if (json_ != nullptr) return JsonType::read(json_, data);
  if (ros_ != nullptr) {
    const PackagePtr message = ros::RosType::read(ros_, data).value_or(nullptr);
    return message && knownRosType_ ? knownRosType_->convert(*message) : message;
  }
  if (prototype_ == nullptr) {
    auto copy = std::make_shared<robotcontrol::PackageCopy>();
    copy->set_type(name_);
    copy->set_data(data.data(), data.size());
    return copy;
  }
  const std::shared_ptr<Message> message(prototype_->New(),
                                         [keep = dynamic_](const Message* dead) { delete dead; });
  const bool read =
      fitsProtobuf(data.size()) && message->ParseFromArray(data.data(), static_cast<int>(data.size()));
  return read ? message : nullptr;
}

}  // namespace robotlink
