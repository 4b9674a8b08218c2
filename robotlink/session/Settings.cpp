// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/Settings.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "robotlink/session/VersionedFile.h"

namespace robotlink {
namespace {

using nlohmann::json;

const VersionedFormat& settingsFormat() {
  static const VersionedFormat instance{"robotcontrol-settings", 1, "settings"};
  return instance;
}

std::optional<Settings::Value> valueFromJson(const json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return std::nullopt;
  std::vector<std::string> list;
  for (const json& element : value) {
    if (!element.is_string()) return std::nullopt;
    list.push_back(element.get<std::string>());
  }
  return list;
}

}  // namespace

Result<void> Settings::load() {
  values_.clear();
  changed_ = false;
  const auto contents = readVersioned(file_, settingsFormat());
  if (!contents) return tl::unexpected(keepAside(file_, contents.error()));
  for (const auto& [name, value] : contents->items()) {
    if (auto read = valueFromJson(value)) values_[name] = std::move(*read);
  }
  return {};
}

Result<void> Settings::save() {
  if (!changed_) return {};
  json contents = json::object();
  for (const auto& [name, value] : values_) {
    contents[name] = std::visit([](const auto& v) { return json(v); }, value);
  }
  auto written = writeVersioned(file_, settingsFormat(), contents);
  if (written) changed_ = false;
  return written;
}

template <typename T>
const T* Settings::find(const std::string& name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : std::get_if<T>(&found->second);
}

double Settings::number(const std::string& name, double fallback) const {
  const auto* value = find<double>(name);
  return value ? *value : fallback;
}

std::string Settings::text(const std::string& name, const std::string& fallback) const {
  const auto* value = find<std::string>(name);
  return value ? *value : fallback;
}

void Settings::set(const std::string& name, Value value) {
  const auto [entry, isNew] = values_.try_emplace(name, value);
  if (!isNew && entry->second == value) return;
  entry->second = std::move(value);
  changed_ = true;
}

void Settings::setNumber(const std::string& name, double number) {
  if (std::isfinite(number)) {
    set(name, Value(number));
  } else {
    remove(name);
  }
}

void Settings::remove(const std::string& name) {
  const std::string below = name + "/";
  const auto erased = std::erase_if(
      values_, [&](const auto& entry) { return entry.first == name || entry.first.starts_with(below); });
  changed_ = changed_ || erased > 0;
}

}  // namespace robotlink
