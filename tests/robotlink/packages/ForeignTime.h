// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>

#include <memory>

namespace robotlink::test {

/// A message of a type that a file has described: its field "stamp" is of a type that is called
/// google.protobuf.Timestamp but has a text in place of the seconds.
class ForeignTime {
 public:
  ForeignTime() {
    using google::protobuf::FieldDescriptorProto;
    google::protobuf::FileDescriptorProto file;
    file.set_name("foreign.proto");
    file.set_package("google.protobuf");
    const auto add = [&](const char* type, const char* field, FieldDescriptorProto::Type kind) {
      auto& message = *file.add_message_type();
      message.set_name(type);
      auto& added = *message.add_field();
      added.set_name(field);
      added.set_number(1);
      added.set_label(FieldDescriptorProto::LABEL_OPTIONAL);
      added.set_type(kind);
      if (kind == FieldDescriptorProto::TYPE_MESSAGE) added.set_type_name(".google.protobuf.Timestamp");
    };
    add("Timestamp", "seconds", FieldDescriptorProto::TYPE_STRING);
    add("Stamped", "stamp", FieldDescriptorProto::TYPE_MESSAGE);
    pool_.BuildFile(file);
    message_.reset(factory_.GetPrototype(pool_.FindMessageTypeByName("google.protobuf.Stamped"))->New());
    // So that it is set.
    message_->GetReflection()->MutableMessage(message_.get(), message_->GetDescriptor()->field(0));
  }
  google::protobuf::Message& message() { return *message_; }
  const google::protobuf::Descriptor& timeType() const {
    return *message_->GetDescriptor()->field(0)->message_type();
  }

 private:
  google::protobuf::DescriptorPool pool_;
  google::protobuf::DynamicMessageFactory factory_{&pool_};
  std::unique_ptr<google::protobuf::Message> message_;
};

}  // namespace robotlink::test
