// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/ObjectLooks.h"

#include <QJsonObject>
#include <algorithm>
#include <array>
#include <utility>

#include "widgets/scene/SceneObjects.h"

namespace widgets {
namespace {

constexpr std::array kSurfaceNames{std::pair{Surface::kShaded, "shaded"}, std::pair{Surface::kFlat, "flat"},
                                   std::pair{Surface::kHiddenLines, "hidden-lines"},
                                   std::pair{Surface::kWire, "wire"}};

}  // namespace

const char* nameOfSurface(Surface surface) {
  for (const auto& [each, name] : kSurfaceNames)
    if (each == surface) return name;
  return "";
}

std::optional<Surface> surfaceNamed(const std::string& name) {
  for (const auto& [surface, each] : kSurfaceNames)
    if (name == each) return surface;
  return std::nullopt;
}

void ObjectLooks::forgetShownWithin(const std::string& path, const SceneObjects& objects) {
  for (auto& [each, look] : looks_)
    if (objects.isWithin(each, path)) look.isShown.reset();
  std::erase_if(looks_, [](const auto& entry) { return entry.second == ObjectLook(); });
}

void ObjectLooks::hide(const std::string& path, const SceneObjects& objects) {
  forgetShownWithin(path, objects);
  looks_[path].isShown = false;
  while (looks_.size() > kMaxLooks) looks_.erase(looks_.begin());
}

void ObjectLooks::show(const std::string& path, const SceneObjects& objects) {
  forgetShownWithin(path, objects);
  if (isHidden(path, objects)) looks_[path].isShown = true;
}

void ObjectLooks::showAll() {
  for (auto& [path, look] : looks_) look.isShown.reset();
  std::erase_if(looks_, [](const auto& entry) { return entry.second == ObjectLook(); });
}

void ObjectLooks::drop(const std::string& path) {
  const auto found = looks_.find(path);
  if (found != looks_.end() && found->second == ObjectLook()) looks_.erase(found);
}

void ObjectLooks::setSurface(const std::string& path, std::optional<Surface> surface) {
  looks_[path].surface = surface;
  drop(path);
}

void ObjectLooks::setOpacity(const std::string& path, float opacity) {
  looks_[path].opacity = std::clamp(opacity, ObjectLook::kMinOpacity, 1.F);
}

void ObjectLooks::clear() {
  looks_.clear();
}

ObjectLook ObjectLooks::of(const std::string& path, const SceneObjects& objects) const {
  ObjectLook look;
  if (looks_.empty()) {
    look.isShown = true;
    return look;
  }
  for (const std::string& at : objects.lineage(path)) {
    const auto found = looks_.find(at);
    if (found == looks_.end()) continue;
    const ObjectLook& chosen = found->second;
    if (!look.isShown) look.isShown = chosen.isShown;
    if (!look.surface) look.surface = chosen.surface;
    if (!look.opacity) look.opacity = chosen.opacity;
  }
  look.isShown = look.isShown.value_or(true);
  return look;
}

bool ObjectLooks::isHidden(const std::string& path, const SceneObjects& objects) const {
  return !*of(path, objects).isShown;
}

int ObjectLooks::hiddenCount() const {
  return static_cast<int>(
      std::ranges::count_if(looks_, [](const auto& entry) { return entry.second.isShown == false; }));
}

QJsonArray ObjectLooks::state() const {
  QJsonArray state;
  for (const auto& [path, look] : looks_) {
    QJsonObject entry{{QStringLiteral("object"), QString::fromStdString(path)}};
    if (look.isShown) entry.insert(QStringLiteral("shown"), *look.isShown);
    if (look.surface) entry.insert(QStringLiteral("surface"), QLatin1String(nameOfSurface(*look.surface)));
    if (look.opacity) entry.insert(QStringLiteral("opacity"), static_cast<double>(*look.opacity));
    state.append(entry);
  }
  return state;
}

void ObjectLooks::restore(const QJsonArray& state) {
  looks_.clear();
  for (const QJsonValue& value : state) {
    const QJsonObject entry = value.toObject();
    const std::string path = entry.value(QStringLiteral("object")).toString().toStdString();
    if (path.empty() || looks_.size() >= kMaxLooks) continue;
    ObjectLook look;
    if (const auto shown = entry.value(QStringLiteral("shown")); shown.isBool())
      look.isShown = shown.toBool();
    look.surface = surfaceNamed(entry.value(QStringLiteral("surface")).toString().toStdString());
    if (const auto opacity = entry.value(QStringLiteral("opacity")); opacity.isDouble())
      look.opacity = std::clamp(static_cast<float>(opacity.toDouble()), ObjectLook::kMinOpacity, 1.F);
    if (look != ObjectLook()) looks_[path] = look;
  }
}

}  // namespace widgets
