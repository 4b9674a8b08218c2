// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/FormMemory.h"

#include <QJsonArray>
#include <optional>

#include "app/core/platform/PlatformAdapter.h"

namespace app {
namespace {

/// A place in the state of the window: a key, and the index in the list that is there; -1 if there is none.
struct MemoryPlace {
  QString key;
  int index = -1;
};

MemoryPlace placeOf(const PlatformField& field) {
  const QString place = QString::fromStdString(field.remembered);
  const int slash = place.indexOf(QLatin1Char('/'));
  if (slash < 0) return {place, -1};
  return {place.left(slash), place.mid(slash + 1).toInt()};
}

QJsonValue toJson(const FormValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag;
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return QString::fromStdString(std::get<std::string>(value));
}

/// The value if it has the type of the field and is one that the field can have.
std::optional<FormValue> fromJson(const QJsonValue& value, const PlatformField& field) {
  std::optional<FormValue> read;
  if (value.isBool()) read = value.toBool();
  if (value.isDouble()) read = value.toDouble();
  if (value.isString()) read = value.toString().toStdString();
  return read && problemOf(field, *read).empty() ? read : std::nullopt;
}

}  // namespace

void FormMemory::load(const QJsonObject& window) {
  for (const PlatformAdapter& adapter : platformAdapters()) {
    for (const PlatformField& field : formOf(adapter).fields) {
      const QString key = placeOf(field).key;
      if (!key.isEmpty() && window.contains(key)) kept_.insert(key, window.value(key));
    }
  }
}

void FormMemory::save(QJsonObject& window) const {
  for (auto kept = kept_.begin(); kept != kept_.end(); ++kept) window.insert(kept.key(), kept.value());
}

QJsonValue FormMemory::at(const PlatformField& field) const {
  const MemoryPlace place = placeOf(field);
  const QJsonValue value = kept_.value(place.key);
  if (field.recent) return value.toArray().at(0);
  return place.index < 0 ? value : value.toArray().at(place.index);
}

FormValues FormMemory::valuesOf(const PlatformForm& form) const {
  FormValues values;
  for (const PlatformField& field : form.fields) {
    if (auto value = fromJson(at(field), field)) values[field.name] = std::move(*value);
  }
  return values;
}

QStringList FormMemory::recent(const PlatformField& field) const {
  if (!field.recent) return {};
  return kept_.value(placeOf(field).key).toVariant().toStringList().mid(0, kMaxRecent);
}

void FormMemory::remember(const PlatformForm& form, const FormValues& values) {
  for (const PlatformField& field : form.fields) {
    const auto value = values.find(field.name);
    const MemoryPlace place = placeOf(field);
    if (place.key.isEmpty() || value == values.end()) continue;
    QJsonArray list = kept_.value(place.key).toArray();
    if (field.recent) {
      QStringList newest = recent(field);
      const QString text = toJson(value->second).toString();
      newest.removeAll(text);
      newest.prepend(text);
      kept_.insert(place.key, QJsonArray::fromStringList(newest.mid(0, kMaxRecent)));
    } else if (place.index >= 0) {
      while (list.size() <= place.index) list.append(QJsonValue());
      list.replace(place.index, toJson(value->second));
      kept_.insert(place.key, list);
    } else {
      kept_.insert(place.key, toJson(value->second));
    }
  }
}

}  // namespace app
