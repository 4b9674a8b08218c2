// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/LogPlatform.h"

#include <google/protobuf/message.h>

namespace logplayer {

/// The stand-in for a process whose packages come from the log. It waits for nothing.
class LogPlatform::Turn final : public robotlink::Process {
 public:
  Turn(LogPlatform& platform, std::string process)
      : Process(process + " as logged", platform.clock()),
        platform_(platform),
        process_(std::move(process)) {}

 protected:
  void execute() override { platform_.sendTurn(process_); }

 private:
  LogPlatform& platform_;
  std::string process_;
};

LogPlatform::LogPlatform(const robotlink::Clock& clock, std::vector<Package> packages)
    : Platform("platform", clock) {
  for (Package& package : packages) {
    auto& turn = turns_[package.process];
    if (!turn && !package.process.empty()) turn = std::make_unique<Turn>(*this, package.process);
    Entry entry;
    entry.sender = std::make_unique<robotlink::AnySender>(*this, package.name, robotlink::Blocking::kNo);
    entry.package = std::move(package);
    entries_.emplace(entry.package.name, std::move(entry));
  }
}

LogPlatform::~LogPlatform() {
  stop();
}

bool LogPlatform::put(const std::string& package, const robotlink::PackagePtr& value) {
  const auto found = entries_.find(package);
  // Receivers rely on the type, and files are not trusted.
  if (found == entries_.end() || !value || value->GetDescriptor() != found->second.package.type) return false;
  found->second.waiting.push_back(value);
  return true;
}

robotlink::Process* LogPlatform::turnOf(const std::string& process) {
  const auto found = turns_.find(process);
  return found == turns_.end() ? nullptr : found->second.get();
}

void LogPlatform::execute() {
  sendTurn("");
}

void LogPlatform::sendTurn(const std::string& process) {
  for (auto& [name, entry] : entries_) {
    if (entry.package.process != process) continue;
    for (const auto& value : std::exchange(entry.waiting, {})) entry.sender->send(value);
  }
}

}  // namespace logplayer
