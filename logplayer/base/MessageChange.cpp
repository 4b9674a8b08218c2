// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/MessageChange.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "robotlink/packages/FieldValues.h"

namespace logplayer {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// Durations are not moved.
bool isInstant(const Descriptor& type) {
  return robotlink::isTime(type) && type.full_name() == "google.protobuf.Timestamp";
}

bool namesRobot(const FieldDescriptor& field) {
  constexpr std::array<std::string_view, 4> kNames{"frame_id", "parent_frame_id", "child_frame_id", "robot"};
  return field.cpp_type() == FieldDescriptor::CPPTYPE_STRING &&
         field.type() == FieldDescriptor::TYPE_STRING && !field.is_repeated() &&
         std::find(kNames.begin(), kNames.end(), field.name()) != kNames.end();
}

void move(Message& time, robotlink::Duration offset) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const auto* seconds = time.GetDescriptor()->FindFieldByNumber(1);
  const auto* nanos = time.GetDescriptor()->FindFieldByNumber(2);
  const auto* reflection = time.GetReflection();
  std::int64_t rest = reflection->GetInt32(time, nanos) + offset.count() % kSecond;
  std::int64_t whole = 0;
  // Invalid times are left unchanged; the addition must not overflow.
  if (__builtin_add_overflow(reflection->GetInt64(time, seconds), offset.count() / kSecond, &whole)) return;
  const std::int64_t carry = rest >= kSecond ? 1 : rest < 0 ? -1 : 0;
  rest -= carry * kSecond;
  if (__builtin_add_overflow(whole, carry, &whole)) return;
  reflection->SetInt64(&time, seconds, whole);
  reflection->SetInt32(&time, nanos, static_cast<std::int32_t>(rest));
}

}  // namespace

std::string MessageChange::renamed(const std::string& name) const {
  const auto slash = name.find('/');
  const auto found = robots_.find(name.substr(0, slash));
  if (found == robots_.end()) return name;
  return slash == std::string::npos ? found->second : found->second + name.substr(slash);
}

bool MessageChange::concerns(const Descriptor& type) {
  if (offset_.count() == 0 && robots_.empty()) return false;
  return concernsFields(type);
}

// Types may be recursive; therefore all reachable types are examined, instead of combining the results of
// nested types.
bool MessageChange::concernsFields(const Descriptor& type) {
  if (const auto known = concerned_.find(&type); known != concerned_.end()) return known->second;
  std::vector<const Descriptor*> reached{&type};
  bool result = false;
  for (std::size_t next = 0; next < reached.size() && !result; ++next) {
    const Descriptor& at = *reached[next];
    result = isInstant(at);
    for (int i = 0; i < at.field_count() && !result; ++i) {
      const FieldDescriptor& field = *at.field(i);
      result = namesRobot(field);
      const Descriptor* inner = field.message_type();
      if (inner && std::find(reached.begin(), reached.end(), inner) == reached.end())
        reached.push_back(inner);
    }
  }
  return concerned_[&type] = result;
}

void MessageChange::apply(Message& message) {
  if (!concerns(*message.GetDescriptor())) return;
  if (isInstant(*message.GetDescriptor())) {
    move(message, offset_);
    return;
  }
  const auto* reflection = message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection->ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (namesRobot(*field)) {
      reflection->SetString(&message, field, renamed(reflection->GetString(message, field)));
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE &&
               concernsFields(*field->message_type())) {
      if (!field->is_repeated()) {
        apply(*reflection->MutableMessage(&message, field));
        continue;
      }
      for (int i = 0; i < reflection->FieldSize(message, field); ++i) {
        apply(*reflection->MutableRepeatedMessage(&message, field, i));
      }
    }
  }
}

}  // namespace logplayer
