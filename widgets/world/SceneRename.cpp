// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/SceneRename.h"

#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <map>

#include "robotcontrol/World.pb.h"

namespace widgets {
namespace {

using RootObjects = std::map<std::string, const robotcontrol::WorldObject*>;

/// The objects of the scene itself, by their paths.
RootObjects rootsOf(const robotcontrol::WorldObjects& objects) {
  RootObjects roots;
  for (const auto& object : objects.objects()) {
    if (object.parent().empty()) roots.emplace(object.path(), &object);
  }
  return roots;
}

std::string typeOf(const robotcontrol::WorldObject& object) {
  const auto type = std::ranges::find(object.properties(), "type", &robotcontrol::WorldProperty::name);
  return type == object.properties().end() ? std::string() : type->text();
}

/// The only one that the other list has not; null: there is none, or there are several.
const robotcontrol::WorldObject* onlyMissing(const RootObjects& in, const RootObjects& other) {
  const robotcontrol::WorldObject* missing = nullptr;
  for (const auto& [path, object] : in) {
    if (other.contains(path)) continue;
    if (missing != nullptr) return nullptr;
    missing = object;
  }
  return missing;
}

/// Whether a character can be a part of the path before an object's name.
bool continuesPath(QChar c) {
  return c.isLetterOrNumber() || c == QLatin1Char('_') || c == QLatin1Char('-') || c == QLatin1Char('/') ||
         c == QLatin1Char(':') || c == QLatin1Char('.');
}

}  // namespace

std::optional<SceneRename> renameBetween(const robotcontrol::WorldObjects& before,
                                         const robotcontrol::WorldObjects& now) {
  const RootObjects old = rootsOf(before), fresh = rootsOf(now);
  if (before.file() != now.file() || old.size() != fresh.size()) return std::nullopt;
  const auto *gone = onlyMissing(old, fresh), *come = onlyMissing(fresh, old);
  if (gone == nullptr || come == nullptr || gone->kind() != come->kind()) return std::nullopt;
  // A model defined in the scene's own file is a type of its own, with its name.
  const std::string type = typeOf(*gone);
  if (type != typeOf(*come) && type != gone->name()) return std::nullopt;
  return SceneRename{gone->path(), come->path()};
}

QString withRename(QString text, const SceneRename& rename) {
  const QString from = QString::fromStdString(rename.from), to = QString::fromStdString(rename.to);
  if (text == from) return to;
  // With what the Data view compares.
  const QLatin1String robot("robot:");
  if (text == robot + from) return robot + to;
  const QString part = from + QLatin1Char('/');
  for (int at = text.indexOf(part); at >= 0; at = text.indexOf(part, at + 1)) {
    if (at > 0 && continuesPath(text[at - 1])) continue;
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

QJsonValue withRename(const QJsonValue& state, const SceneRename& rename) {
  if (state.isString()) return withRename(state.toString(), rename);
  if (state.isArray()) {
    QJsonArray renamed;
    for (const QJsonValue& value : state.toArray()) renamed.append(withRename(value, rename));
    return renamed;
  }
  if (!state.isObject()) return state;
  QJsonObject renamed;
  const QJsonObject object = state.toObject();
  for (auto each = object.begin(); each != object.end(); ++each) {
    // A key that is a path has more than a name.
    const bool isPath = each.key().contains(QLatin1Char('/'));
    renamed.insert(isPath ? withRename(each.key(), rename) : each.key(), withRename(each.value(), rename));
  }
  return renamed;
}

}  // namespace widgets
