// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/Presets.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/ParsedNumber.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/KeyModes.h"
#include "robotlink/session/KeyPresets.h"
#include "robotlink/session/RobotTables.h"
#include "robotlink/session/VersionedFile.h"

namespace robotlink {
namespace {

using nlohmann::json;

constexpr std::string_view kPresetEnd = ".preset.json", kOldEnd = ".keys.json";
constexpr char kLayout[] = "layout";

const VersionedFormat& format() {
  static const VersionedFormat instance{"robotcontrol-preset", 1, "preset"};
  return instance;
}

Preset::Values valuesOf(const robotcontrol::KeyTable& table) {
  Preset::Values values;
  for (const auto& key : table.keys()) {
    if (key.mode().kind() != robotcontrol::KeyMode::OFF) values[key.name()] = inWords(key.mode());
  }
  return values;
}

Result<Preset::Values> valuesIn(const json& part, std::string_view name, const std::filesystem::path& file) {
  const auto wrong = [&](const std::string& text) { return failure("preset.value", text, {file.string()}); };
  if (!part.is_object()) return wrong("\"" + std::string(name) + "\" has to be an object with texts");
  Preset::Values values;
  for (const auto& [key, value] : part.items()) {
    if (!value.is_string()) return wrong("the value of \"" + key + "\" has to be a text");
    values[key] = value.get<std::string>();
    if (name == Preset::kPartNames[Preset::kKeys] && !keyModeOf(values[key]))
      return wrong("the mode of the key " + key +
                   " is off, always, 'n 3', 'every 3' or 'every-ms 40', not '" + values[key] + "'");
    if (name == Preset::kPartNames[Preset::kCamera] && !parsedNumber<double>(values[key]))
      return wrong("the camera's setting " + key + " has to be a number, not '" + values[key] + "'");
  }
  return values;
}

/// The shortest text that is this number again.
std::string inDigits(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

bool isThere(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

std::string orDefault(const Preset::Values& values, const std::string& name, Preset::Part part) {
  const auto found = values.find(name);
  if (found != values.end()) return found->second;
  return part == Preset::kKeys ? "off" : "the default";
}

}  // namespace

std::vector<std::string> differences(const Preset& now, const Preset& wanted) {
  std::vector<std::string> lines;
  for (int i = 0; i < Preset::kParts; ++i) {
    const auto part = static_cast<Preset::Part>(i);
    const auto &have = now.parts[part], &want = wanted.parts[part];
    if (!have || !want) continue;
    Preset::Values names = *have;
    names.insert(want->begin(), want->end());
    names.erase(kLayout);
    for (const auto& [name, value] : names) {
      const std::string here = orDefault(*have, name, part), there = orDefault(*want, name, part);
      if (here != there)
        lines.push_back(std::string(Preset::kPartNames[part]) + ": " + name + " is " + here + ", not " +
                        there);
    }
  }
  return lines;
}

std::optional<Preset::Values> cameraSettings(Session& session) {
  if (!keysThatAreOn(session).contains(packageKey(kCameraSettings.name))) return std::nullopt;
  const auto* known = session.store().latestAs<robotcontrol::CameraSettings>(
      session.selectedRobot() + "/" + kCameraSettings.name, Instant::max());
  if (known == nullptr) return std::nullopt;
  Preset::Values values;
  for (const auto& setting : known->settings()) {
    if (setting.value() != setting.initial()) values[setting.name()] = inDigits(setting.value());
  }
  return values;
}

Preset::Values keysThatAreOn(Session& session) {
  const auto* table = keyTable(session);
  return table == nullptr ? Preset::Values() : valuesOf(*table);
}

Preset::Values activeSolutions(Session& session) {
  Preset::Values values;
  if (const auto* table = solutionTable(session)) {
    for (const auto& task : table->tasks()) values[task.name()] = task.active();
  }
  return values;
}

std::vector<std::string> Presets::names() const {
  std::vector<std::string> names = KeyPresets(folder_).names();
  std::error_code failed;
  for (std::filesystem::directory_iterator it(folder_, failed), end; !failed && it != end;
       it.increment(failed)) {
    const std::string file = it->path().filename().string();
    if (!file.ends_with(kPresetEnd)) continue;
    const std::string name = file.substr(0, file.size() - kPresetEnd.size());
    if (fileOf(name)) names.push_back(name);
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

Result<std::filesystem::path> Presets::fileOf(const std::string& name) const {
  // The rules for names are those of the older files.
  auto file = KeyPresets(folder_).fileOf(name);
  if (!file) return file;
  return folder_ / (name + std::string(kPresetEnd));
}

Result<Preset> Presets::load(const std::string& name) const {
  const auto file = fileOf(name);
  if (!file) return tl::unexpected(file.error());
  if (isThere(*file)) return loadFile(*file);
  const auto keys = KeyPresets(folder_).load(name);
  if (!keys) return tl::unexpected(keys.error());
  Preset preset;
  preset.parts[Preset::kKeys] = valuesOf(*keys);
  return preset;
}

Result<Preset> Presets::loadFile(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  if (name.ends_with(kOldEnd))
    return Presets(file.parent_path()).load(name.substr(0, name.size() - kOldEnd.size()));
  if (!isThere(file)) return failure("preset.unknown", "there is no such preset", {file.string()});
  const auto contents = readVersioned(file, format());
  if (!contents) return tl::unexpected(contents.error());
  Preset preset;
  for (std::size_t part = 0; part < Preset::kParts; ++part) {
    const auto found = contents->find(std::string(Preset::kPartNames[part]));
    if (found == contents->end()) continue;
    auto values = valuesIn(*found, Preset::kPartNames[part], file);
    if (!values) return tl::unexpected(values.error());
    preset.parts[part] = std::move(*values);
  }
  return preset;
}

Result<void> Presets::save(const std::string& name, const Preset& preset) const {
  const auto file = fileOf(name);
  if (!file) return tl::unexpected(file.error());
  auto saved = saveFile(*file, preset);
  // An older file of the name is replaced by this one.
  if (const auto old = KeyPresets(folder_).fileOf(name); saved && old && isThere(*old))
    static_cast<void>(KeyPresets(folder_).remove(name));
  return saved;
}

Result<void> Presets::saveFile(const std::filesystem::path& file, const Preset& preset) {
  json contents = json::object();
  for (std::size_t part = 0; part < Preset::kParts; ++part) {
    if (preset.parts[part]) contents[std::string(Preset::kPartNames[part])] = *preset.parts[part];
  }
  return writeVersioned(file, format(), contents);
}

Result<void> Presets::remove(const std::string& name) const {
  const auto file = fileOf(name);
  if (!file) return tl::unexpected(file.error());
  if (!isThere(*file)) return KeyPresets(folder_).remove(name);
  std::error_code failed;
  std::filesystem::remove(*file, failed);
  if (!failed) return {};
  return failure("preset.remove", "cannot remove the preset \"" + name + "\": " + failed.message(),
                 {file->string()}, {name});
}

Result<void> Presets::rename(const std::string& from, const std::string& to) const {
  const auto preset = load(from);
  if (!preset) return tl::unexpected(preset.error());
  const auto known = names();
  if (std::ranges::find(known, to) != known.end())
    return failure("preset.exists", "there is a preset \"" + to + "\" already; delete it first", {}, {to});
  return save(to, *preset).and_then([&] { return remove(from); });
}

}  // namespace robotlink
