// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/expressions/FieldPath.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <cstdint>
#include <type_traits>

#include "robotlink/base/ParsedNumber.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/expressions/NameCharacters.h"
#include "robotlink/packages/FieldValues.h"

namespace robotlink {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::EnumValueDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

constexpr double kSecondsPerNanosecond = 1e-9;
constexpr char kElementExpected[] =
    "expected an index or a choice, as in joints[3] or joints[name=\"headPan\"]";

tl::unexpected<Error> wrong(std::string id, std::string text, int column) {
  return failure(std::move(id), std::move(text), {"", 0, column});
}

/// Reads a path from left to right.
class PathReader {
 public:
  explicit PathReader(std::string_view text) : text_(text) {}

  bool atEnd() const { return at_ == text_.size(); }
  int column() const { return static_cast<int>(at_) + 1; }
  /// Steps over a character if it is the next one.
  bool take(char c) {
    if (atEnd() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::string name() {
    const std::size_t begin = at_;
    while (!atEnd() && isNameCharacter(text_[at_])) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }
  /// The text up to the closing bracket, which is stepped over; empty if there is none. Brackets in a quoted
  /// text are part of it.
  std::optional<std::string> upToBracket() {
    std::size_t end = text_.find(']', at_);
    const std::size_t quote = text_.find('"', at_);
    if (quote < end) {
      const std::size_t quoteEnd = text_.find("\"]", quote + 1);
      if (quoteEnd == std::string_view::npos) return std::nullopt;
      end = quoteEnd + 1;
    }
    if (end == std::string_view::npos) return std::nullopt;
    std::string found(text_.substr(at_, end - at_));
    at_ = end + 1;
    return found;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

/// The field of this name, or the only one that has it with a frame behind it: "position_in_robot" for
/// "position".
const FieldDescriptor* fieldNamed(const Descriptor& type, const std::string& name) {
  if (const FieldDescriptor* exact = type.FindFieldByName(name)) return exact;
  const FieldDescriptor* found = nullptr;
  for (int i = 0; i < type.field_count(); ++i) {
    if (!type.field(i)->name().starts_with(name + "_in_")) continue;
    if (found != nullptr) return nullptr;
    found = type.field(i);
  }
  return found;
}

std::vector<std::string> fieldNames(const Descriptor& type) {
  std::vector<std::string> names;
  for (int i = 0; i < type.field_count(); ++i) names.push_back(type.field(i)->name());
  return names;
}

FieldValue enumValue(const FieldDescriptor& field, int number) {
  const EnumValueDescriptor* named = field.enum_type()->FindValueByNumber(number);
  return {static_cast<double>(number), named == nullptr ? std::to_string(number) : named->name()};
}

/// A value of a field, or of one element of a list; empty for messages that are no times.
std::optional<FieldValue> plainValue(const Message& message, const FieldDescriptor& field, int element) {
  return visitValue(message, field, element, [&](const auto& value) -> std::optional<FieldValue> {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, EnumNumber>) {
      return enumValue(field, value.number);
    } else if constexpr (std::is_same_v<Value, std::string>) {
      if (field.type() == FieldDescriptor::TYPE_BYTES)
        return FieldValue{static_cast<double>(value.size()), std::nullopt};
      return FieldValue{std::nullopt, value};
    } else if constexpr (std::is_base_of_v<Message, Value>) {
      if (!isTime(*value.GetDescriptor())) return std::nullopt;
      const double seconds = static_cast<double>(wholeSeconds(value));
      return FieldValue{seconds + nanoseconds(value) * kSecondsPerNanosecond, std::nullopt};
    } else if constexpr (std::is_same_v<Value, bool>) {
      return FieldValue{value ? 1.0 : 0.0, value ? "true" : "false"};
    } else {
      return FieldValue{static_cast<double>(value), std::nullopt};
    }
  });
}

bool equals(const FieldValue& value, const std::string& text) {
  if (value.text && *value.text == text) return true;
  const auto number = parsedNumber<double>(text);
  return number && value.number == number;
}

}  // namespace

std::optional<double> FieldValue::asNumber() const {
  if (number || !text) return number;
  constexpr std::uint32_t kBasis = 2'166'136'261, kPrime = 16'777'619;
  std::uint32_t sum = kBasis;
  for (const char c : *text) sum = (sum ^ static_cast<unsigned char>(c)) * kPrime;
  return static_cast<double>(sum);
}

Result<FieldPath> FieldPath::parse(std::string_view text) {
  FieldPath path;
  path.text_ = text;
  PathReader reader(text);
  do {
    Step step;
    step.column = reader.column();
    step.field = reader.name();
    if (step.field.empty())
      return wrong("path.name", "expected the name of a field, as in position.x", step.column);
    if (reader.take('[')) {
      const int column = reader.column();
      const auto inside = reader.upToBracket();
      if (!inside) return wrong("path.bracket", "this [ has no matching ]", column - 1);
      if (const auto index = parsedNumber<int>(*inside)) {
        step.element = *index;
      } else if (inside->find('"') == std::string::npos) {
        if (inside->empty()) return wrong("path.element", kElementExpected, column);
        step.element = Selector{"name", *inside};
      } else {
        const std::size_t equal = inside->find("=\"");
        const bool isSelector =
            equal != std::string::npos && equal > 0 && inside->size() >= equal + 3 && inside->back() == '"';
        if (!isSelector) return wrong("path.element", kElementExpected, column);
        const std::size_t begin = equal + 2;
        step.element = Selector{inside->substr(0, equal), inside->substr(begin, inside->size() - begin - 1)};
      }
    }
    path.steps_.push_back(std::move(step));
  } while (reader.take('.'));
  if (!reader.atEnd())
    return wrong("path.end", "expected a . or the end after " + path.steps_.back().field, reader.column());
  return path;
}

Result<void> FieldPath::fits(const Descriptor& type) const {
  const Descriptor* here = &type;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    const bool isLast = i + 1 == steps_.size();
    const FieldDescriptor* field = fieldNamed(*here, step.field);
    if (field == nullptr) {
      return wrong(
          "path.field",
          here->full_name() + " has no field " + step.field + suggestion(step.field, fieldNames(*here)),
          step.column);
    }
    const bool isChosen = !std::holds_alternative<std::monostate>(step.element);
    if (isChosen != field->is_repeated() && !(isLast && field->is_repeated())) {
      return wrong("path.element",
                   field->is_repeated()
                       ? step.field + " is a list: say which element, as in " + step.field + "[0]"
                       : step.field + " is not a list",
                   step.column);
    }
    const Descriptor* inner = field->message_type();
    if (const auto* selector = std::get_if<Selector>(&step.element)) {
      const FieldDescriptor* key = inner == nullptr ? nullptr : inner->FindFieldByName(selector->field);
      if (key == nullptr || key->is_repeated() || key->message_type() != nullptr) {
        return wrong("path.element", "elements of " + step.field + " have no plain field " + selector->field,
                     step.column);
      }
    }
    if (isLast) {
      if (inner == nullptr || isTime(*inner) || (field->is_repeated() && !isChosen)) return {};
      return wrong("path.message",
                   step.field + " is not a value, but has fields" + suggestion("", fieldNames(*inner)),
                   step.column);
    }
    if (inner == nullptr)
      return wrong("path.field", step.field + " is a value and has no fields", step.column);
    here = inner;
  }
  return {};
}

std::optional<FieldValue> FieldPath::valueIn(const Message& message) const {
  const Step* missing = nullptr;
  return valueIn(message, missing);
}

std::string FieldPath::missingElement(const Message& message) const {
  const Step* missing = nullptr;
  static_cast<void>(valueIn(message, missing));
  if (missing == nullptr) return {};
  if (const int* index = std::get_if<int>(&missing->element))
    return missing->field + " has no element " + std::to_string(*index);
  const auto& selector = std::get<Selector>(missing->element);
  if (selector.field == "name") return "no element is named " + selector.value;
  return "no element has the " + selector.field + ' ' + selector.value;
}

std::optional<FieldValue> FieldPath::valueIn(const Message& message, const Step*& missing) const {
  const Message* here = &message;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    const bool isLast = i + 1 == steps_.size();
    const FieldDescriptor* field = fieldNamed(*here->GetDescriptor(), step.field);
    if (field == nullptr) return std::nullopt;
    const google::protobuf::Reflection& reflection = *here->GetReflection();
    int element = -1;
    if (field->is_repeated()) {
      const int size = reflection.FieldSize(*here, field);
      if (std::holds_alternative<std::monostate>(step.element)) {
        if (!isLast) return std::nullopt;
        return FieldValue{static_cast<double>(size), std::nullopt};
      }
      if (const int* index = std::get_if<int>(&step.element)) {
        element = *index < 0 ? size + *index : *index;
      } else {
        element = elementOf(*here, *field, std::get<Selector>(step.element));
      }
      if (element < 0 || element >= size) {
        missing = &step;
        return std::nullopt;
      }
    } else if (!std::holds_alternative<std::monostate>(step.element) ||
               (field->has_presence() && !reflection.HasField(*here, field))) {
      return std::nullopt;
    }
    if (isLast) return plainValue(*here, *field, element);
    if (field->message_type() == nullptr) return std::nullopt;
    here = element < 0 ? &reflection.GetMessage(*here, field)
                       : &reflection.GetRepeatedMessage(*here, field, element);
  }
  return std::nullopt;
}

int FieldPath::elementOf(const Message& message, const FieldDescriptor& list, const Selector& selector) {
  if (list.message_type() == nullptr) return -1;
  const FieldDescriptor* key = list.message_type()->FindFieldByName(selector.field);
  if (key == nullptr || key->is_repeated()) return -1;
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  for (int i = 0; i < reflection.FieldSize(message, &list); ++i) {
    const auto value = plainValue(reflection.GetRepeatedMessage(message, &list, i), *key, -1);
    if (value && equals(*value, selector.value)) return i;
  }
  return -1;
}

std::optional<double> numberAt(const Message& message, std::string_view path) {
  const auto parsed = FieldPath::parse(path);
  const auto value = parsed ? parsed->valueIn(message) : std::nullopt;
  return value ? value->number : std::nullopt;
}

}  // namespace robotlink
