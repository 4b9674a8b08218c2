// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/DebugKey.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string_view>
#include <utility>

namespace robotlink {
namespace {

// Filled before main() starts, by one thread; constructed by the first key, so that the order in which files
// are initialized does not matter.
struct Registry {
  std::vector<DebugKey::Entry> entries;
  std::map<std::string, int> indices;
  std::atomic<bool> sealed{false};
};

Registry& registry() {
  static Registry instance;
  return instance;
}

[[noreturn]] void refuseKey(const char* name, const char* why) {
  std::fprintf(stderr, "debug key \"%s\": %s\n", name, why);
  std::abort();
}

bool isPath(std::string_view name) {
  if (name.empty() || name.front() == '/' || name.back() == '/') return false;
  if (name.find("//") != std::string_view::npos) return false;
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyz0123456789-/";
  return name.find_first_not_of(kAllowed) == std::string_view::npos;
}

}  // namespace

DebugKey::DebugKey(const char* name, const char* help, std::string stream) {
  Registry& keys = registry();
  if (!isPath(name))
    refuseKey(name, "a name is a path of lower case letters, digits and '-', its parts separated by one '/'");
  if (keys.sealed)
    refuseKey(name, "declared after the first debug context was made; declare keys at namespace scope");
  keys.entries.push_back({name, help, std::move(stream)});
  number_ = static_cast<int>(keys.entries.size());
  if (!keys.indices.emplace(name, index()).second)
    refuseKey(name, "declared twice; names of keys are unique in a program");
}

const std::string& DebugKey::name() const {
  return all()[static_cast<std::size_t>(index())].name;
}

const std::string& DebugKey::stream() const {
  return all()[static_cast<std::size_t>(index())].stream;
}

const std::vector<DebugKey::Entry>& DebugKey::all() {
  return registry().entries;
}

int DebugKey::find(const std::string& name) {
  const auto found = registry().indices.find(name);
  return found == registry().indices.end() ? -1 : found->second;
}

void DebugKey::seal() {
  registry().sealed = true;
}

}  // namespace robotlink
