// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/MessageFields.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <QCoreApplication>
#include <cmath>
#include <limits>

namespace widgets {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

Message& mutableMessageAt(Message& root, const FieldPath& path, std::size_t steps) {
  Message* message = &root;
  for (std::size_t i = 0; i < steps; ++i) {
    const Reflection& reflection = *message->GetReflection();
    message = path[i].element >= 0
                  ? reflection.MutableRepeatedMessage(message, path[i].field, path[i].element)
                  : reflection.MutableMessage(message, path[i].field);
  }
  return *message;
}

QVariant enumName(const google::protobuf::EnumValueDescriptor* value) {
  return value == nullptr ? QString() : QString::fromStdString(value->name());
}

/// `element` is negative for fields that are no lists.
QVariant valueOf(const Message& message, const FieldDescriptor* field, int element) {
  const auto get = [&](auto single, auto repeated) {
    const Reflection& r = *message.GetReflection();
    return element < 0 ? (r.*single)(message, field) : (r.*repeated)(message, field, element);
  };
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return get(&Reflection::GetDouble, &Reflection::GetRepeatedDouble);
    case FieldDescriptor::CPPTYPE_FLOAT:
      return static_cast<double>(get(&Reflection::GetFloat, &Reflection::GetRepeatedFloat));
    case FieldDescriptor::CPPTYPE_BOOL:
      return get(&Reflection::GetBool, &Reflection::GetRepeatedBool);
    case FieldDescriptor::CPPTYPE_INT32:
      return get(&Reflection::GetInt32, &Reflection::GetRepeatedInt32);
    case FieldDescriptor::CPPTYPE_UINT32:
      return get(&Reflection::GetUInt32, &Reflection::GetRepeatedUInt32);
    case FieldDescriptor::CPPTYPE_INT64:
      return static_cast<qlonglong>(get(&Reflection::GetInt64, &Reflection::GetRepeatedInt64));
    case FieldDescriptor::CPPTYPE_UINT64:
      return static_cast<qulonglong>(get(&Reflection::GetUInt64, &Reflection::GetRepeatedUInt64));
    case FieldDescriptor::CPPTYPE_ENUM:
      return enumName(get(&Reflection::GetEnum, &Reflection::GetRepeatedEnum));
    case FieldDescriptor::CPPTYPE_STRING:
      return QString::fromStdString(get(&Reflection::GetString, &Reflection::GetRepeatedString));
    default:
      return {};
  }
}

/// Stores a value in a singular or repeated field, for which Reflection has a setter each per type.
template <typename T, typename Single, typename Element>
bool store(Message& message, const FieldStep& step, Single single, Element element, T value) {
  const Reflection& r = *message.GetReflection();
  if (step.element >= 0) {
    (r.*element)(&message, step.field, step.element, value);
  } else {
    (r.*single)(&message, step.field, value);
  }
  return true;
}

template <typename Integer>
bool inRange(qlonglong value) {
  return value >= static_cast<qlonglong>(std::numeric_limits<Integer>::min()) &&
         value <= static_cast<qlonglong>(std::numeric_limits<Integer>::max());
}

bool storeLargest(Message& message, const FieldStep& step, const QVariant& value) {
  bool good = false;
  const qulonglong number = value.toULongLong(&good);
  const bool negative = value.toString().trimmed().startsWith(QLatin1Char('-'));
  return good && !negative &&
         store(message, step, &Reflection::SetUInt64, &Reflection::SetRepeatedUInt64,
               static_cast<std::uint64_t>(number));
}

bool storeInteger(Message& message, const FieldStep& step, const QVariant& value) {
  if (step.field->cpp_type() == FieldDescriptor::CPPTYPE_UINT64) return storeLargest(message, step, value);
  bool good = false;
  const qlonglong number = value.toLongLong(&good);
  if (!good) return false;
  switch (step.field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return inRange<std::int32_t>(number) &&
             store(message, step, &Reflection::SetInt32, &Reflection::SetRepeatedInt32,
                   static_cast<std::int32_t>(number));
    case FieldDescriptor::CPPTYPE_UINT32:
      return inRange<std::uint32_t>(number) &&
             store(message, step, &Reflection::SetUInt32, &Reflection::SetRepeatedUInt32,
                   static_cast<std::uint32_t>(number));
    default:
      return store(message, step, &Reflection::SetInt64, &Reflection::SetRepeatedInt64,
                   static_cast<std::int64_t>(number));
  }
}

bool storeNumber(Message& message, const FieldStep& step, const QVariant& value) {
  bool good = false;
  const double number = value.toDouble(&good);
  if (!good || !std::isfinite(number)) return false;
  if (step.field->cpp_type() == FieldDescriptor::CPPTYPE_FLOAT) {
    return std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max()) &&
           store(message, step, &Reflection::SetFloat, &Reflection::SetRepeatedFloat,
                 static_cast<float>(number));
  }
  return store(message, step, &Reflection::SetDouble, &Reflection::SetRepeatedDouble, number);
}

bool storeBool(Message& message, const FieldStep& step, const QVariant& value) {
  // From a text, QVariant converts all but "false" and "0" to true.
  const QString text = value.toString().toLower();
  if (value.type() == QVariant::String && text != QLatin1String("true") && text != QLatin1String("false"))
    return false;
  return store(message, step, &Reflection::SetBool, &Reflection::SetRepeatedBool, value.toBool());
}

bool storeEnum(Message& message, const FieldStep& step, const QVariant& value) {
  const auto* chosen = step.field->enum_type()->FindValueByName(value.toString().toStdString());
  return chosen != nullptr &&
         store(message, step, &Reflection::SetEnum, &Reflection::SetRepeatedEnum, chosen);
}

bool storeText(Message& message, const FieldStep& step, const QVariant& value) {
  if (step.field->type() == FieldDescriptor::TYPE_BYTES) return false;
  const Reflection& r = *message.GetReflection();
  std::string text = value.toString().toStdString();
  if (step.element >= 0) {
    r.SetRepeatedString(&message, step.field, step.element, std::move(text));
  } else {
    r.SetString(&message, step.field, std::move(text));
  }
  return true;
}

bool storeValue(Message& owner, const FieldStep& step, const QVariant& value) {
  switch (step.field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
    case FieldDescriptor::CPPTYPE_FLOAT:
      return storeNumber(owner, step, value);
    case FieldDescriptor::CPPTYPE_BOOL:
      return storeBool(owner, step, value);
    case FieldDescriptor::CPPTYPE_ENUM:
      return storeEnum(owner, step, value);
    case FieldDescriptor::CPPTYPE_STRING:
      return storeText(owner, step, value);
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return false;
    default:
      return storeInteger(owner, step, value);
  }
}

/// Whether all elements on the way are there, and the last step is not a list as a whole.
bool exists(const Message& root, const FieldPath& path) {
  const Message* message = &root;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto& [field, element] = path[i];
    const Reflection& reflection = *message->GetReflection();
    if (field->is_repeated() && (element < 0 || element >= reflection.FieldSize(*message, field)))
      return false;
    if (i + 1 == path.size()) break;
    message = element >= 0 ? &reflection.GetRepeatedMessage(*message, field, element)
                           : &reflection.GetMessage(*message, field);
  }
  return true;
}

struct FieldKindText {
  Q_DECLARE_TR_FUNCTIONS(MessageFields)
};

}  // namespace

bool isMessage(const FieldPath& path) {
  return path.empty() || path.back().field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
}

const Message& messageAt(const Message& root, const FieldPath& path) {
  const Message* message = &root;
  for (const FieldStep& step : path) {
    const Reflection& reflection = *message->GetReflection();
    if (step.element >= 0 && step.element >= reflection.FieldSize(*message, step.field)) {
      return *reflection.GetMessageFactory()->GetPrototype(step.field->message_type());
    }
    message = step.element >= 0 ? &reflection.GetRepeatedMessage(*message, step.field, step.element)
                                : &reflection.GetMessage(*message, step.field);
  }
  return *message;
}

QVariant valueAt(const Message& root, const FieldPath& path) {
  if (isMessage(path)) return {};
  const FieldStep& last = path.back();
  const Message& owner = messageAt(root, FieldPath(path.begin(), path.end() - 1));
  if (!last.field->is_repeated()) return valueOf(owner, last.field, -1);
  const int size = owner.GetReflection()->FieldSize(owner, last.field);
  return last.element >= 0 && last.element < size ? valueOf(owner, last.field, last.element) : QVariant();
}

bool setValueAt(Message& root, const FieldPath& path, const QVariant& value) {
  if (isMessage(path) || !exists(root, path)) return false;
  // A copy is changed, since a refused value must not leave messages on its way that were unset.
  const std::unique_ptr<Message> changed(root.New());
  changed->CopyFrom(root);
  if (!storeValue(mutableMessageAt(*changed, path, path.size() - 1), path.back(), value)) return false;
  root.GetReflection()->Swap(&root, changed.get());
  return true;
}

QStringList choicesAt(const FieldPath& path) {
  QStringList names;
  if (path.empty() || path.back().field->cpp_type() != FieldDescriptor::CPPTYPE_ENUM) return names;
  const auto* type = path.back().field->enum_type();
  for (int i = 0; i < type->value_count(); ++i) names << QString::fromStdString(type->value(i)->name());
  return names;
}

QString typeName(const FieldPath& path) {
  if (path.empty()) return {};
  switch (path.back().field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
    case FieldDescriptor::CPPTYPE_FLOAT:
      return FieldKindText::tr("number");
    case FieldDescriptor::CPPTYPE_BOOL:
      return FieldKindText::tr("yes or no");
    case FieldDescriptor::CPPTYPE_ENUM:
      return FieldKindText::tr("choice");
    case FieldDescriptor::CPPTYPE_STRING:
      return FieldKindText::tr("text");
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return FieldKindText::tr("group");
    case FieldDescriptor::CPPTYPE_UINT32:
    case FieldDescriptor::CPPTYPE_UINT64:
      return FieldKindText::tr("whole number, not negative");
    default:
      return FieldKindText::tr("whole number");
  }
}

QString pathText(const FieldPath& path) {
  QString result;
  for (const FieldStep& step : path) {
    if (!result.isEmpty()) result += QLatin1Char('.');
    result += QString::fromStdString(step.field->name());
    if (step.element >= 0) result += QStringLiteral("[%1]").arg(step.element);
  }
  return result;
}

}  // namespace widgets
