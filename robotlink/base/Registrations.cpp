// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Registrations.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace robotlink {
namespace {

struct State {
  std::atomic<bool> areSealed{false};
  bool isTrial = false;
  std::string problem;
  /// All registries of the process, in no particular order.
  std::vector<RegistryBase*> registries;
};

/// Never destroyed: registries at namespace scope may be used until the very end.
State& state() {
  static State& instance = *new State;
  return instance;
}

}  // namespace

void Registrations::seal() {
  state().areSealed = true;
}

bool Registrations::areSealed() {
  return state().areSealed;
}

void Registrations::refuse(const std::string& text) {
  State& now = state();
  if (!now.isTrial) {
    std::fprintf(stderr, "%s\n", text.c_str());
    std::abort();
  }
  now.problem += (now.problem.empty() ? "" : "; ") + text;
}

RegistrationTrial::RegistrationTrial() {
  State& now = state();
  if (std::exchange(now.isTrial, true)) std::abort();
  now.problem.clear();
  for (RegistryBase* registry : now.registries) registry->rememberEntries();
}

RegistrationTrial::~RegistrationTrial() {
  State& now = state();
  now.isTrial = false;
  if (isKept_) return;
  for (RegistryBase* registry : now.registries) registry->restoreEntries();
}

const std::string& RegistrationTrial::problem() {
  return state().problem;
}

RegistryBase::RegistryBase() {
  state().registries.push_back(this);
}

bool RegistryBase::accepts(const std::string& what, const std::string& problem) {
  const std::string why =
      problem.empty() && Registrations::areSealed()
          ? "registered after programs were opened; register at namespace scope, or in a plug-in"
          : problem;
  if (!why.empty()) Registrations::refuse(what + ": " + why);
  return why.empty();
}

}  // namespace robotlink
