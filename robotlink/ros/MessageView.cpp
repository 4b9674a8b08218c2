// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/MessageView.h"

#include <google/protobuf/timestamp.pb.h>

#include <algorithm>
#include <limits>
#include <type_traits>

#include "foxglove/Geometry.pb.h"
#include "robotlink/packages/FieldValues.h"

namespace robotlink::ros {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

const FieldDescriptor* MessageView::field(const char* name, bool isRepeated) const {
  if (message_ == nullptr) return nullptr;
  const FieldDescriptor* found = message_->GetDescriptor()->FindFieldByName(name);
  return found != nullptr && found->is_repeated() == isRepeated ? found : nullptr;
}

bool MessageView::has(const char* name) const {
  return message_ != nullptr && message_->GetDescriptor()->FindFieldByName(name) != nullptr;
}

double MessageView::numberOf(const FieldDescriptor* field, int element) const {
  if (field == nullptr || field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) return 0;
  return visitValue(*message_, *field, element, [](const auto& value) -> double {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_arithmetic_v<Value>) return static_cast<double>(value);
    if constexpr (std::is_same_v<Value, EnumNumber>) return value.number;
    return 0;
  });
}

const std::string& MessageView::textOf(const FieldDescriptor* field, int element) const {
  static const std::string kNone;
  if (field == nullptr || field->cpp_type() != FieldDescriptor::CPPTYPE_STRING) return kNone;
  // Dynamic messages have their texts in memory, and never need this.
  static thread_local std::string unused;
  const auto& reflection = *message_->GetReflection();
  return element < 0 ? reflection.GetStringReference(*message_, field, &unused)
                     : reflection.GetRepeatedStringReference(*message_, field, element, &unused);
}

MessageView MessageView::in(const char* name) const {
  const FieldDescriptor* found = field(name, false);
  if (found == nullptr || found->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) return MessageView(nullptr);
  return MessageView(&message_->GetReflection()->GetMessage(*message_, found));
}

double MessageView::number(const char* name) const {
  return numberOf(field(name, false), -1);
}

std::uint32_t MessageView::natural(const char* name) const {
  const double value = number(name);
  constexpr double kMax = std::numeric_limits<std::uint32_t>::max();
  return value > 0 ? static_cast<std::uint32_t>(std::min(value, kMax)) : 0;
}

const std::string& MessageView::text(const char* name) const {
  return textOf(field(name, false), -1);
}

int MessageView::count(const char* name) const {
  const FieldDescriptor* found = field(name, true);
  return found == nullptr ? 0 : message_->GetReflection()->FieldSize(*message_, found);
}

MessageView MessageView::element(const char* name, int index) const {
  const FieldDescriptor* found = field(name, true);
  if (found == nullptr || found->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) return MessageView(nullptr);
  return MessageView(&message_->GetReflection()->GetRepeatedMessage(*message_, found, index));
}

double MessageView::numberAt(const char* name, int index) const {
  return index < count(name) ? numberOf(field(name, true), index) : 0;
}

const std::string& MessageView::textAt(const char* name, int index) const {
  return textOf(index < count(name) ? field(name, true) : nullptr, index);
}

std::vector<double> MessageView::numbers(const char* name) const {
  const FieldDescriptor* list = field(name, true);
  if (list == nullptr) return {};
    // A map has millions of cells. The list itself is copied a hundred times as fast as number by number, or
    // as by GetRepeatedFieldRef(), which protobuf would have one use.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  const auto all = [&]<typename Number>(Number) {
    const auto& numbers = message_->GetReflection()->GetRepeatedField<Number>(*message_, list);
    return std::vector<double>(numbers.begin(), numbers.end());
  };
#pragma GCC diagnostic pop
  switch (list->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return all(std::int32_t());
    case FieldDescriptor::CPPTYPE_INT64:
      return all(std::int64_t());
    case FieldDescriptor::CPPTYPE_UINT32:
      return all(std::uint32_t());
    case FieldDescriptor::CPPTYPE_UINT64:
      return all(std::uint64_t());
    case FieldDescriptor::CPPTYPE_FLOAT:
      return all(float());
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return all(double());
    case FieldDescriptor::CPPTYPE_BOOL:
      return all(bool());
    default:
      return std::vector<double>(static_cast<std::size_t>(count(name)));
  }
}

void assign(google::protobuf::Timestamp& to, const MessageView& from) {
  to.set_seconds(static_cast<std::int64_t>(from.number("seconds")));
  to.set_nanos(static_cast<std::int32_t>(from.number("nanos")));
}

void assign(foxglove::Vector3& to, const MessageView& from) {
  to.set_x(from.number("x"));
  to.set_y(from.number("y"));
  to.set_z(from.number("z"));
}

void assign(foxglove::Quaternion& to, const MessageView& from) {
  to.set_x(from.number("x"));
  to.set_y(from.number("y"));
  to.set_z(from.number("z"));
  to.set_w(from.number("w"));
}

}  // namespace robotlink::ros
