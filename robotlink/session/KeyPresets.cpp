// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/KeyPresets.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/session/VersionedFile.h"

namespace robotlink {
namespace {

using nlohmann::json;
using robotcontrol::KeyMode;
using robotcontrol::KeyTable;

constexpr char kExtension[] = ".keys.json";

constexpr std::array<std::pair<const char*, KeyMode::Kind>, 4> kModes{{{"always", KeyMode::ALWAYS},
                                                                       {"n-times", KeyMode::N_TIMES},
                                                                       {"every-n", KeyMode::EVERY_N},
                                                                       {"every-ms", KeyMode::EVERY_MS}}};

const VersionedFormat& presetFormat() {
  static const VersionedFormat instance{"robotcontrol-debug-keys", 1, "keys"};
  return instance;
}

json toJson(const KeyMode& mode) {
  const auto* named =
      std::find_if(kModes.begin(), kModes.end(), [&](const auto& m) { return m.second == mode.kind(); });
  if (named == kModes.end()) return {};
  json result{{"mode", named->first}};
  if (mode.kind() != KeyMode::ALWAYS) result["n"] = mode.n();
  return result;
}

// False if it is none.
bool modeFromJson(const json& value, KeyMode& mode) {
  if (!value.is_object()) return false;
  const json name = value.value("mode", json());
  const auto* named =
      std::find_if(kModes.begin(), kModes.end(), [&](const auto& m) { return name == m.first; });
  if (named == kModes.end()) return false;
  mode.set_kind(named->second);
  if (named->second == KeyMode::ALWAYS) return true;
  const json n = value.value("n", json());
  if (!n.is_number_unsigned() || n > std::numeric_limits<std::uint32_t>::max()) return false;
  mode.set_n(n.get<std::uint32_t>());
  return true;
}

bool isName(const std::string& name) {
  constexpr std::size_t kMaxLength = 60;
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' ||
           c == '-' || c == '_';
  };
  return !name.empty() && name.size() <= kMaxLength && name.front() != ' ' && name.back() != ' ' &&
         std::all_of(name.begin(), name.end(), allowed);
}

}  // namespace

Result<std::filesystem::path> KeyPresets::fileOf(const std::string& name) const {
  if (isName(name)) return folder_ / (name + kExtension);
  return failure("preset.name",
                 "a preset's name consists of letters, digits, spaces, '-' and '_', not \"" + name + "\"", {},
                 {name});
}

std::vector<std::string> KeyPresets::names() const {
  std::vector<std::string> result;
  std::error_code failed;
  for (std::filesystem::directory_iterator it(folder_, failed), end; !failed && it != end;
       it.increment(failed)) {
    const std::string file = it->path().filename().string();
    if (!file.ends_with(kExtension)) continue;
    const std::string name = file.substr(0, file.size() - std::size(kExtension) + 1);
    if (isName(name)) result.push_back(name);
  }
  std::sort(result.begin(), result.end());
  return result;
}

Result<KeyTable> KeyPresets::load(const std::string& name) const {
  const auto file = fileOf(name);
  if (!file) return tl::unexpected(file.error());
  std::error_code ignored;
  if (!std::filesystem::exists(*file, ignored)) {
    return failure("preset.unknown", "there is no preset \"" + name + "\"", {file->string(), 0, 0}, {name});
  }
  const auto contents = readVersioned(*file, presetFormat());
  if (!contents) return tl::unexpected(contents.error());
  KeyTable table;
  for (const auto& [key, value] : contents->items()) {
    auto& entry = *table.add_keys();
    entry.set_name(key);
    if (modeFromJson(value, *entry.mutable_mode())) continue;
    return failure(
        "preset.mode",
        "the key " + key +
            " needs a \"mode\" (always, n-times, every-n, every-ms) and, except for always, a number \"n\"",
        {file->string(), 0, 0}, {key});
  }
  return table;
}

Result<void> KeyPresets::save(const std::string& name, const KeyTable& keys) const {
  const auto file = fileOf(name);
  if (!file) return tl::unexpected(file.error());
  json contents = json::object();
  for (const KeyTable::Key& key : keys.keys()) {
    json mode = toJson(key.mode());
    if (!mode.is_null()) contents[key.name()] = std::move(mode);
  }
  return writeVersioned(*file, presetFormat(), contents);
}

Result<void> KeyPresets::remove(const std::string& name) const {
  const auto file = fileOf(name);
  if (!file) return tl::unexpected(file.error());
  std::error_code failed;
  if (std::filesystem::remove(*file, failed)) return {};
  const std::string reason = failed ? failed.message() : "there is none";
  return failure("preset.remove", "cannot remove the preset \"" + name + "\": " + reason,
                 {file->string(), 0, 0}, {name});
}

}  // namespace robotlink
