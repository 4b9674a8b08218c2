// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/FieldText.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "robotlink/packages/FieldValues.h"
#include "widgets/Counted.h"

namespace widgets {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

constexpr int kDigits = 6;
constexpr int kSummarized = 4;                   // fields
constexpr int kMaxText = 1000;                   // characters in a cell
constexpr std::int64_t kCalendar = 100'000'000;  // s; later timestamps are dates, earlier ones since a start
constexpr double kSecondsPerNanosecond = 1e-9;
constexpr std::int64_t kNanosecondsPerMillisecond = 1'000'000;

struct DataText {
  Q_DECLARE_TR_FUNCTIONS(Data)
};

template <typename Number>
QString numberText(Number value, Precision precision) {
  if constexpr (std::is_integral_v<Number>) {
    return QString::number(value);
  } else if constexpr (std::is_same_v<Number, float>) {
    // Nine digits distinguish all floats; the shortest text that does is the intended one.
    if (precision == Precision::kShort) return QString::number(value, 'g', kDigits);
    for (int digits = kDigits; digits < std::numeric_limits<float>::max_digits10; ++digits) {
      const QString text = QString::number(value, 'g', digits);
      if (text.toFloat() == value) return text;
    }
    return QString::number(value, 'g', std::numeric_limits<float>::max_digits10);
  } else {
    return precision == Precision::kShort ? QString::number(value, 'g', kDigits)
                                          : QString::number(value, 'g', QLocale::FloatingPointShortest);
  }
}

QString timeFieldText(const Message& time, Precision precision) {
  const std::int64_t whole = robotlink::wholeSeconds(time);
  const std::int32_t nanos = robotlink::nanoseconds(time);
  const bool isDate = time.GetDescriptor()->name() == "Timestamp" && whole >= kCalendar;
  if (isDate && precision == Precision::kShort) {
    return QDateTime::fromSecsSinceEpoch(whole, Qt::UTC)
        .addMSecs(nanos / kNanosecondsPerMillisecond)
        .toString(QStringLiteral("yyyy-MM-dd hh:mm:ss.zzz"));
  }
  const double seconds = static_cast<double>(whole) + nanos * kSecondsPerNanosecond;
  return QString::number(seconds, 'f', precision == Precision::kShort ? 3 : 9);
}

QString enumText(const FieldDescriptor& field, int number) {
  const auto* named = field.enum_type()->FindValueByNumber(number);
  return named == nullptr ? QString::number(number) : QString::fromStdString(named->name());
}

}  // namespace

bool FieldPlace::isSet() const {
  if (holder == nullptr || field == nullptr) return false;
  const auto& reflection = *holder->GetReflection();
  if (field->is_repeated()) return element < reflection.FieldSize(*holder, field);
  return !field->has_presence() || reflection.HasField(*holder, field);
}

int FieldPlace::size() const {
  return isSet() && field->is_repeated() && element < 0 ? holder->GetReflection()->FieldSize(*holder, field)
                                                        : 0;
}

const Message* FieldPlace::message() const {
  if (!isSet() || !holdsMessages(*field) || (field->is_repeated() && element < 0)) return nullptr;
  const auto& reflection = *holder->GetReflection();
  return element < 0 ? &reflection.GetMessage(*holder, field)
                     : &reflection.GetRepeatedMessage(*holder, field, element);
}

bool holdsMessages(const FieldDescriptor& field) {
  return field.message_type() != nullptr && !robotlink::isTime(*field.message_type());
}

bool holdsNumbers(const FieldDescriptor& field) {
  return !holdsMessages(field) && field.cpp_type() != FieldDescriptor::CPPTYPE_STRING;
}

QString valueText(const FieldPlace& place, Precision precision) {
  if (!place.isSet() || (place.field->is_repeated() && place.element < 0)) return {};
  const FieldDescriptor& field = *place.field;
  return robotlink::visitValue(*place.holder, field, place.element, [&](const auto& value) -> QString {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, bool>) {
      return value ? QStringLiteral("true") : QStringLiteral("false");
    } else if constexpr (std::is_arithmetic_v<Value>) {
      return numberText(value, precision);
    } else if constexpr (std::is_same_v<Value, robotlink::EnumNumber>) {
      return enumText(field, value.number);
    } else if constexpr (std::is_same_v<Value, std::string>) {
      if (field.type() == FieldDescriptor::TYPE_BYTES) return bytesText(value.size());
      if (precision == Precision::kFull) return QString::fromStdString(value);
      return QString::fromUtf8(value.data(), static_cast<int>(std::min<std::size_t>(value.size(), kMaxText)))
          .simplified();
    } else {
      return robotlink::isTime(*value.GetDescriptor()) ? timeFieldText(value, precision) : QString();
    }
  });
}

std::optional<double> numberOf(const FieldPlace& place) {
  if (!place.isSet() || !holdsNumbers(*place.field) || (place.field->is_repeated() && place.element < 0))
    return std::nullopt;
  return robotlink::visitValue(*place.holder, *place.field, place.element, [](const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_arithmetic_v<Value>) {
      return std::optional(static_cast<double>(value));
    } else if constexpr (std::is_same_v<Value, robotlink::EnumNumber>) {
      return std::optional(static_cast<double>(value.number));
    } else if constexpr (std::is_base_of_v<Message, Value>) {
      return std::optional(static_cast<double>(robotlink::wholeSeconds(value)) +
                           robotlink::nanoseconds(value) * kSecondsPerNanosecond);
    } else {
      return std::optional<double>();
    }
  });
}

QString summaryText(const Message& message) {
  QStringList parts;
  for (int i = 0; i < message.GetDescriptor()->field_count() && parts.size() < kSummarized; ++i) {
    const FieldDescriptor& field = *message.GetDescriptor()->field(i);
    const FieldPlace place{&message, &field};
    const bool isPlain = !field.is_repeated() && field.message_type() == nullptr &&
                         field.type() != FieldDescriptor::TYPE_BYTES;
    if (isPlain && place.isSet())
      parts << QString::fromStdString(field.name()) + QLatin1Char(' ') + valueText(place);
  }
  return parts.join(QStringLiteral(", "));
}

QString statisticsText(const FieldPlace& list, int first, int count) {
  count = std::clamp(count, 0, std::max(0, list.size() - first));
  const QString elements = counted(count, DataText::tr("1 element"), DataText::tr("%1 elements"));
  const FieldDescriptor& field = *list.field;
  if (count == 0 || !holdsNumbers(field) || field.message_type() != nullptr ||
      field.cpp_type() == FieldDescriptor::CPPTYPE_ENUM || field.cpp_type() == FieldDescriptor::CPPTYPE_BOOL)
    return elements;
  double least = std::numeric_limits<double>::infinity(), greatest = -least, sum = 0;
  int finite = 0;
  for (int i = first; i < first + count; ++i) {
    const double value = numberOf({list.holder, list.field, i}).value_or(std::nan(""));
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
    sum += value;
    ++finite;
  }
  if (finite == 0) return elements;
  const auto text = [](double value) { return QString::number(value, 'g', kDigits); };
  return DataText::tr("%1, %2 to %3, mean %4").arg(elements, text(least), text(greatest), text(sum / finite));
}

QString typeText(const FieldDescriptor& field) {
  const QString type =
      QString::fromStdString(field.message_type() != nullptr ? field.message_type()->full_name()
                             : field.enum_type() != nullptr  ? field.enum_type()->full_name()
                                                             : field.type_name());
  if (field.is_map()) return DataText::tr("map of %1").arg(type);
  return field.is_repeated() ? DataText::tr("list of %1").arg(type) : type;
}

}  // namespace widgets
