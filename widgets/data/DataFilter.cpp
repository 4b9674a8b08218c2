// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/DataFilter.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <algorithm>

#include "robotlink/expressions/NumericFields.h"
#include "widgets/data/FieldText.h"

namespace widgets {
namespace {

constexpr int kLookedAt = 5000;  // fields of a message

}  // namespace

bool DataFilter::finds(const QString& path) const {
  return std::all_of(words_.begin(), words_.end(),
                     [&](const QString& word) { return path.contains(word, Qt::CaseInsensitive); });
}

bool DataFilter::findsWithin(const QString& path, const google::protobuf::Message& message) const {
  int budget = kLookedAt;
  return findsWithin(path, message, budget);
}

bool DataFilter::findsWithin(const QString& path, const google::protobuf::Message& message,
                             int& budget) const {
  const auto& type = *message.GetDescriptor();
  for (int i = 0; i < type.field_count(); ++i) {
    if (--budget < 0) return false;
    const auto& field = *type.field(i);
    const QString here = path + QLatin1Char('.') + QString::fromStdString(field.name());
    if (finds(here)) return true;
    if (!holdsMessages(field)) continue;
    if (!field.is_repeated()) {
      const auto* part = FieldPlace{&message, &field}.message();
      if (part != nullptr && findsWithin(here, *part, budget)) return true;
      continue;
    }
    const int size = FieldPlace{&message, &field}.size();
    for (int element = 0; element < size && budget > 0; ++element) {
      const auto* part = FieldPlace{&message, &field, element}.message();
      const QString key = QString::fromStdString(robotlink::elementKey(*part, element));
      const QString inside = QStringLiteral("%1[%2]").arg(here, key);
      if (finds(inside) || findsWithin(inside, *part, budget)) return true;
    }
  }
  return false;
}

}  // namespace widgets
