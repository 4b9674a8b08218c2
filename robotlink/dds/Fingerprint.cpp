// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/Fingerprint.h"

#include <google/protobuf/descriptor.h>

#include <set>
#include <string>

#include "robotlink/base/bytes/Fnv.h"

namespace robotlink::dds {
namespace {

namespace pb = google::protobuf;

void addText(const pb::EnumDescriptor& type, std::string& text) {
  for (int i = 0; i < type.value_count(); ++i)
    text += type.value(i)->name() + "=" + std::to_string(type.value(i)->number()) + ";";
}

void addText(const pb::Descriptor& type, std::string& text, std::set<std::string>& seen) {
  text += type.full_name();
  if (!seen.insert(type.full_name()).second) return;
  text += "{";
  for (int i = 0; i < type.field_count(); ++i) {
    const pb::FieldDescriptor& field = *type.field(i);
    text += field.name() + ":" + std::to_string(field.number()) + ":" + std::to_string(field.type()) + ":" +
            std::to_string(field.label()) + ";";
    if (field.message_type() != nullptr) addText(*field.message_type(), text, seen);
    if (field.enum_type() != nullptr) addText(*field.enum_type(), text);
  }
  text += "}";
}

}  // namespace

std::uint64_t fingerprintOf(const pb::Descriptor& type) {
  std::string text;
  std::set<std::string> seen;
  addText(type, text, seen);
  return fnv1a(text);
}

}  // namespace robotlink::dds
