// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/export/MessageTable.h"

#include <fmt/format.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <functional>
#include <type_traits>

#include "robotlink/packages/FieldValues.h"

namespace logplayer {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

template <typename Number>
std::string numberText(Number value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k < bytes.size() + 1 ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

std::string enumText(const FieldDescriptor& field, int number) {
  const auto* value = field.enum_type()->FindValueByNumber(number);
  return value ? value->name() : std::to_string(number);
}

/// `element` is -1 for a field that is not repeated.
std::string valueText(const Message& message, const FieldDescriptor& field, int element) {
  return robotlink::visitValue(message, field, element, [&](const auto& value) -> std::string {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, bool>) {
      return value ? "true" : "false";
    } else if constexpr (std::is_arithmetic_v<Value>) {
      return numberText(value);
    } else if constexpr (std::is_same_v<Value, robotlink::EnumNumber>) {
      return enumText(field, value.number);
    } else if constexpr (std::is_same_v<Value, Message>) {
      return secondsText(robotlink::wholeSeconds(value), robotlink::nanoseconds(value));
    } else {
      return field.type() == FieldDescriptor::TYPE_BYTES ? base64(value) : value;
    }
  });
}

}  // namespace

/// Visits all values that are set in a message.
class MessageTable::Walk {
 public:
  /// Called with a value `field` of `message` and its place.
  using Visit =
      std::function<void(const Walk&, const Message& message, const FieldDescriptor& field, int element)>;
  explicit Walk(Visit visit) : visit_(std::move(visit)) {}

  void over(const Message& message) {
    const Reflection* reflection = message.GetReflection();
    for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
      const FieldDescriptor& field = *message.GetDescriptor()->field(i);
      if (field.is_repeated()) {
        const int count = reflection->FieldSize(message, &field);
        for (int element = 0; element < count; ++element) at(message, field, element);
      } else if (!field.has_presence() || reflection->HasField(message, &field)) {
        at(message, field, -1);
      }
    }
  }
  const Place& place() const { return place_; }
  std::string name() const {
    std::string text;
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      text += (text.empty() ? "" : ".") + fields_[i]->name();
      if (place_[2 * i + 1] >= 0) text += "[" + std::to_string(place_[2 * i + 1]) + "]";
    }
    return text;
  }

 private:
  void at(const Message& message, const FieldDescriptor& field, int element) {
    place_.push_back(field.index());
    place_.push_back(element);
    fields_.push_back(&field);
    if (field.cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE || robotlink::isTime(*field.message_type())) {
      visit_(*this, message, field, element);
    } else {
      const Reflection* reflection = message.GetReflection();
      over(element >= 0 ? reflection->GetRepeatedMessage(message, &field, element)
                        : reflection->GetMessage(message, &field));
    }
    place_.resize(place_.size() - 2);
    fields_.pop_back();
  }

  Visit visit_;
  Place place_;
  std::vector<const FieldDescriptor*> fields_;
};

void MessageTable::learn(const Message& message) {
  Walk([this](const Walk& walk, const Message&, const FieldDescriptor&, int) {
    if (columns_.contains(walk.place())) return;
    if (*room_ > 0) {
      --*room_;
      columns_.emplace(walk.place(), walk.name());
    } else {
      ++leftOut_;
    }
  }).over(message);
}

std::vector<std::string> MessageTable::columns() const {
  std::vector<std::string> names;
  names.reserve(columns_.size());
  for (const auto& [place, name] : columns_) names.push_back(name);
  return names;
}

std::vector<std::string> MessageTable::row(const Message& message) const {
  std::vector<std::string> cells(columns_.size());
  // Values are visited in the order of the columns, so that a single pass finds all of them.
  auto column = columns_.begin();
  std::size_t index = 0;
  Walk([&](const Walk& walk, const Message& holder, const FieldDescriptor& field, int element) {
    while (column != columns_.end() && column->first < walk.place()) {
      ++column;
      ++index;
    }
    if (column != columns_.end() && column->first == walk.place())
      cells[index] = valueText(holder, field, element);
  }).over(message);
  return cells;
}

std::string csvLine(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += ',';
    if (cells[i].find_first_of(",\"\r\n") == std::string::npos) {
      line += cells[i];
      continue;
    }
    line += '"';
    for (const char c : cells[i]) line.append(c == '"' ? 2 : 1, c);
    line += '"';
  }
  return line + "\r\n";
}

std::string secondsText(std::int64_t seconds, std::int64_t nanos) {
  // Nanoseconds of timestamps are never negative: "-0.5" is -1 s and 500,000,000 ns.
  const bool negative = seconds < 0 || nanos < 0;
  if (seconds < 0 && nanos > 0) {
    ++seconds;
    nanos = 1'000'000'000 - nanos;
  }
  const auto whole = seconds < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(seconds)
                                 : static_cast<std::uint64_t>(seconds);
  return fmt::format("{}{}.{:09}", negative ? "-" : "", whole, std::abs(nanos));
}

}  // namespace logplayer
