// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/DebugKey.h"

#include <algorithm>
#include <atomic>
#include <string_view>
#include <utility>

#include "robotlink/base/Registrations.h"

namespace robotlink {
namespace {

Registry<DebugKey::Entry>& keys() {
  static Registry<DebugKey::Entry> instance;
  return instance;
}

/// Whether tables of the size of all() have been allocated.
std::atomic<bool>& areSealed() {
  static std::atomic<bool> sealed{false};
  return sealed;
}

bool isPath(std::string_view name) {
  if (name.empty() || name.front() == '/' || name.back() == '/') return false;
  if (name.find("//") != std::string_view::npos) return false;
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyz0123456789-/";
  return name.find_first_not_of(kAllowed) == std::string_view::npos;
}

/// Empty if a key may have this name.
std::string problemOf(const char* name) {
  if (!isPath(name))
    return "a name is a path of lowercase letters, digits and '-', with its parts separated by one '/'";
  if (areSealed()) return "declared after the first debug context was made; declare keys at namespace scope";
  return DebugKey::find(name) >= 0 ? "declared twice; names of keys are unique in a program" : "";
}

}  // namespace

DebugKey::DebugKey(const char* name, const char* help, std::string stream) {
  const std::string inWords = std::string("debug key \"") + name + "\"";
  if (keys().add({name, help, std::move(stream)}, inWords, problemOf(name)))
    number_ = static_cast<int>(all().size());
}

const std::string& DebugKey::name() const {
  return all()[static_cast<std::size_t>(index())].name;
}

const std::string& DebugKey::stream() const {
  return all()[static_cast<std::size_t>(index())].stream;
}

const std::vector<DebugKey::Entry>& DebugKey::all() {
  return keys().all();
}

int DebugKey::find(const std::string& name) {
  const auto found = std::ranges::find(all(), name, &Entry::name);
  return found == all().end() ? -1 : static_cast<int>(found - all().begin());
}

void DebugKey::seal() {
  areSealed() = true;
}

}  // namespace robotlink
