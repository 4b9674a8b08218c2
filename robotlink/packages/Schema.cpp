// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/Schema.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>

#include <map>
#include <set>
#include <vector>

namespace robotlink {
namespace {

namespace pb = google::protobuf;

/// The types that a type is made of, of all files, and the files with these types alone.
class NeededTypes {
 public:
  explicit NeededTypes(const pb::Descriptor& type) {
    add(type);
    while (!unread_.empty()) {
      const pb::Descriptor* next = unread_.back();
      unread_.pop_back();
      readFields(*next, *next->file());
    }
  }

  pb::FileDescriptorSet files(const pb::FileDescriptor& file) {
    pb::FileDescriptorSet set;
    write(file, set);
    return set;
  }

 private:
  /// The parts that are needed of a file.
  struct Part {
    std::set<const pb::Descriptor*> messages;
    std::set<const pb::EnumDescriptor*> enums;
    std::map<std::string, const pb::FileDescriptor*> imports;
  };

  /// Types within others come with the outermost one.
  void add(const pb::Descriptor& type) {
    const pb::Descriptor* outermost = &type;
    while (outermost->containing_type() != nullptr) outermost = outermost->containing_type();
    if (parts_[outermost->file()].messages.insert(outermost).second) unread_.push_back(outermost);
  }
  void add(const pb::EnumDescriptor& type) {
    if (type.containing_type() != nullptr) {
      add(*type.containing_type());
    } else {
      parts_[type.file()].enums.insert(&type);
    }
  }

  void readFields(const pb::Descriptor& type, const pb::FileDescriptor& file) {
    for (int i = 0; i < type.field_count(); ++i) {
      const pb::FieldDescriptor& field = *type.field(i);
      const pb::FileDescriptor* from = &file;
      if (field.message_type() != nullptr) {
        add(*field.message_type());
        from = field.message_type()->file();
      } else if (field.enum_type() != nullptr) {
        add(*field.enum_type());
        from = field.enum_type()->file();
      }
      if (from != &file) parts_[&file].imports.emplace(from->name(), from);
    }
    for (int i = 0; i < type.nested_type_count(); ++i) readFields(*type.nested_type(i), file);
  }

  /// Imports come first, in the order of their names; the same schema has the same bytes everywhere.
  void write(const pb::FileDescriptor& file, pb::FileDescriptorSet& to) {
    if (!written_.insert(&file).second) return;
    const Part& part = parts_[&file];
    for (const auto& [name, import] : part.imports) write(*import, to);
    pb::FileDescriptorProto& copy = *to.add_file();
    copy.set_name(file.name());
    copy.set_package(file.package());
    if (file.syntax() == pb::FileDescriptor::SYNTAX_PROTO3) copy.set_syntax("proto3");
    for (const auto& [name, import] : part.imports) copy.add_dependency(name);
    for (int i = 0; i < file.message_type_count(); ++i) {
      if (part.messages.contains(file.message_type(i))) file.message_type(i)->CopyTo(copy.add_message_type());
    }
    for (int i = 0; i < file.enum_type_count(); ++i) {
      if (part.enums.contains(file.enum_type(i))) file.enum_type(i)->CopyTo(copy.add_enum_type());
    }
  }

  std::map<const pb::FileDescriptor*, Part> parts_;
  std::vector<const pb::Descriptor*> unread_;
  std::set<const pb::FileDescriptor*> written_;
};

}  // namespace

std::string schemaOf(const pb::Descriptor& type) {
  return NeededTypes(type).files(*type.file()).SerializeAsString();
}

}  // namespace robotlink
