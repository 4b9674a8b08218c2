// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/HostingMemory.h"

#include "robotcontrol/Hosting.pb.h"

#include <utility>
#include <vector>

namespace app {
namespace {

constexpr char kOwnKey[] = "/own-processes", kOtherwiseKey[] = "/otherwise", kThreadsKey[] = "/threads",
               kModelsKey[] = "models", kSceneKey[] = "teams/";

template <typename T>
T valueIn(const robotlink::Settings& settings, const std::string& name) {
  const auto found = settings.all().find(name);
  const T* value = found == settings.all().end() ? nullptr : std::get_if<T>(&found->second);
  return value == nullptr ? T() : *value;
}

}  // namespace

void HostingChoices::choose(const std::string& robot, bool own) {
  if (robot.empty()) {
    ownProcesses = own;
    otherwise.clear();
  } else if (own == ownProcesses) {
    otherwise.erase(robot);
  } else {
    otherwise.insert(robot);
  }
}

HostingMemory::HostingMemory(std::filesystem::path file) : settings_(std::move(file)) {
  // A file that cannot be read is put aside, and everything is as at first.
  static_cast<void>(settings_.load());
}

HostingChoices HostingMemory::choices(const std::string& adapter) const {
  const std::lock_guard lock(mutex_);
  HostingChoices choices;
  choices.ownProcesses = valueIn<bool>(settings_, adapter + kOwnKey);
  for (const auto& robot : valueIn<std::vector<std::string>>(settings_, adapter + kOtherwiseKey))
    choices.otherwise.insert(robot);
  choices.threads = valueIn<bool>(settings_, adapter + kThreadsKey);
  return choices;
}

void HostingMemory::choose(const std::string& adapter, const HostingChoices& choices) {
  if (this->choices(adapter) == choices) return;
  const std::lock_guard lock(mutex_);
  settings_.set(adapter + kOwnKey, choices.ownProcesses);
  settings_.set(adapter + kOtherwiseKey,
                std::vector<std::string>(choices.otherwise.begin(), choices.otherwise.end()));
  settings_.set(adapter + kThreadsKey, choices.threads);
  hasChanged_ = true;
}

std::vector<std::filesystem::path> HostingMemory::modelFolders() const {
  const std::lock_guard lock(mutex_);
  const auto texts = valueIn<std::vector<std::string>>(settings_, kModelsKey);
  return {texts.begin(), texts.end()};
}

void HostingMemory::chooseModelFolders(const std::vector<std::filesystem::path>& folders) {
  if (modelFolders() == folders) return;
  const std::lock_guard lock(mutex_);
  std::vector<std::string> texts;
  for (const auto& folder : folders) texts.push_back(folder.string());
  settings_.set(kModelsKey, texts);
  hasChanged_ = true;
}

std::optional<TeamPrograms> HostingMemory::teamPrograms(const std::filesystem::path& scene) const {
  const std::lock_guard lock(mutex_);
  const std::string key = kSceneKey + scene.string();
  if (!settings_.all().contains(key)) return std::nullopt;
  TeamPrograms programs;
  for (const auto& text : valueIn<std::vector<std::string>>(settings_, key)) {
    const auto equals = text.find('=');
    const auto slash = text.find('/');
    if (equals == std::string::npos) continue;
    const std::string value = text.substr(equals + 1);
    if (slash == 0) {
      programs.robotLayouts[text.substr(1, equals - 1)] = value;
    } else if (slash < equals) {
      programs.solutions[text.substr(0, slash)][text.substr(slash + 1, equals - slash - 1)] = value;
    } else {
      programs.layouts[text.substr(0, equals)] = value;
    }
  }
  return programs;
}

void HostingMemory::chooseTeamPrograms(const std::filesystem::path& scene, const TeamPrograms& programs) {
  // Scenes in which nothing was ever chosen take no room.
  if (teamPrograms(scene).value_or(TeamPrograms()) == programs) return;
  const std::lock_guard lock(mutex_);
  std::vector<std::string> texts;
  for (const auto& [kind, layout] : programs.layouts) texts.push_back(kind + "=" + layout.string());
  for (const auto& [name, layout] : programs.robotLayouts)
    texts.push_back("/" + name + "=" + layout.string());
  for (const auto& [name, solutions] : programs.solutions) {
    for (const auto& [task, solution] : solutions) texts.push_back(name + "/" + task + "=" + solution);
  }
  settings_.set(kSceneKey + scene.string(), texts);
  hasChanged_ = true;
}

robotlink::Result<void> HostingMemory::save() {
  const std::lock_guard lock(mutex_);
  if (!std::exchange(hasChanged_, false)) return {};
  return settings_.save();
}

HostingChoices hostingAtOpening(const HostingChoices& asked, const HostingMemory* memory,
                                const std::string& adapter) {
  return asked.ownProcesses || memory == nullptr ? asked : memory->choices(adapter);
}

void rememberHosting(HostingMemory* memory, const std::string& adapter,
                     const robotcontrol::HostProgram& fulfilled, const HostingChoices& now) {
  const bool chooses = fulfilled.where() != robotcontrol::HostProgram::UNCHANGED;
  if (memory != nullptr && chooses) memory->choose(adapter, now);
}

}  // namespace app
