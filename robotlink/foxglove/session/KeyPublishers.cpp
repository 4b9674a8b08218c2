// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/KeyPublishers.h"

#include <algorithm>

#include "robotcontrol/Debugging.pb.h"

namespace robotlink::websocket {
namespace {

/// The limit for a server that continues to invent processes.
constexpr std::size_t kMaxProcesses = 100;

}  // namespace

void KeyPublishers::setKeys(const std::string& process, const robotcontrol::KeyTable& keys) {
  if (streams_.size() >= kMaxProcesses && !streams_.contains(process)) return;
  std::set<std::string>& streams = streams_[process];
  streams.clear();
  for (const auto& key : keys.keys()) streams.insert(key.stream());
}

void KeyPublishers::setProcesses(const robotcontrol::ProcessTable& processes) {
  std::erase_if(streams_, [&](const auto& known) {
    return std::ranges::none_of(processes.processes(),
                                [&](const auto& process) { return process.name() == known.first; });
  });
}

std::string KeyPublishers::processOf(const std::string& stream) const {
  std::string found;
  for (const auto& [process, streams] : streams_) {
    if (!streams.contains(stream)) continue;
    if (!found.empty()) return {};
    found = process;
  }
  return found;
}

}  // namespace robotlink::websocket
