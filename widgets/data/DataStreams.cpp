// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/DataStreams.h"

#include <algorithm>
#include <set>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/NaturalOrder.h"
#include "robotlink/debugging/Streams.h"
#include "widgets/TypedStreams.h"

namespace widgets {
namespace {

robotlink::PackagePtr keyTable(const robotlink::StreamStore& store, const std::string& robot) {
  const auto* stream = store.find(robot + '/' + robotlink::streams::kKeys);
  return stream == nullptr || stream->messages.empty() ? nullptr : stream->messages.back().value;
}

}  // namespace

bool DataStreams::update(const robotlink::StreamStore& store) {
  bool isChanged = listVersion_ != store.listVersion();
  for (const auto& [robot, table] : tables_) isChanged = isChanged || keyTable(store, robot) != table;
  if (isChanged) list(store);
  return isChanged;
}

void DataStreams::list(const robotlink::StreamStore& store) {
  listVersion_ = store.listVersion();
  std::map<std::string, std::vector<DataStream>> byRobot;
  for (const auto* stream : store.streams())
    byRobot[robotlink::streams::robotOf(stream->path)].push_back({stream->path});
  robots_.clear();
  tables_.clear();
  for (auto& [robot, streams] : byRobot) {
    if (!robot.empty()) {
      tables_[robot] = keyTable(store, robot);
      addKeys(store, robot, streams);
    }
    std::ranges::sort(streams, robotlink::comesNaturallyBefore, &DataStream::path);
    robots_.emplace_back(robot, std::move(streams));
  }
  std::ranges::sort(robots_, [](const auto& a, const auto& b) {
    return a.first.empty() != b.first.empty() ? b.first.empty()
                                              : robotlink::comesNaturallyBefore(a.first, b.first);
  });
}

void DataStreams::addKeys(const robotlink::StreamStore& store, const std::string& robot,
                          std::vector<DataStream>& streams) const {
  const auto* table = dynamic_cast<const robotcontrol::KeyTable*>(tables_.at(robot).get());
  if (table == nullptr) return;
  std::set<std::string> added;
  for (const auto& key : table->keys()) {
    const std::string path = robot + '/' + key.stream();
    const bool isOff = key.in_use() && key.mode().kind() == robotcontrol::KeyMode::OFF;
    if (!isOff || key.stream().empty() || store.find(path) != nullptr) continue;
    if (!store.streams(path + '/').empty() || !added.insert(path).second) continue;
    streams.push_back({path, key.name()});
  }
}

}  // namespace widgets
