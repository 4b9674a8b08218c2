// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/ChannelSetups.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <array>
#include <map>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/PackageTypes.h"
#include "robotlink/packages/Schema.h"
#include "robotlink/session/LatchedMessages.h"

namespace robotlink::websocket {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::DescriptorPool;

struct StreamType {
  const char* prefix;
  const char* type;
};
/// The types of the streams of debug keys that are not packages.
constexpr std::array kStreamTypes{StreamType{streams::kImageDrawings, "foxglove.ImageAnnotations"},
                                  StreamType{streams::kFieldDrawings, "foxglove.SceneUpdate"},
                                  StreamType{streams::kRobotDrawings, "foxglove.SceneUpdate"},
                                  StreamType{streams::kImages, "foxglove.RawImage"},
                                  StreamType{streams::kPlots, "robotcontrol.PlotValue"}};
/// Types, in addition to latched ones, of which no message may be replaced by a newer one.
constexpr std::array kCompleteTypes{"robotcontrol.ViewEvents", "foxglove.Log",
                                    "foxglove.Event",          "robotcontrol.PlotValue",
                                    "robotcontrol.Request",    "robotcontrol.LinkPackets"};

constexpr std::array kImageTypes{"foxglove.RawImage", "foxglove.CompressedImage", "foxglove.CompressedVideo"};

/// The message type of a key's stream; null: it is not known.
const Descriptor* typeOf(const std::string& stream, const std::map<std::string, std::string>& packageTypes) {
  const auto known = std::ranges::find_if(
      kStreamTypes, [&](const StreamType& type) { return stream.starts_with(type.prefix); });
  const auto package = packageTypes.find(stream);
  std::string type;
  if (known != kStreamTypes.end()) type = known->type;
  if (package != packageTypes.end()) type = package->second;
  // Packages that the platform sends only to the debug process are in no table of processes.
  if (type.empty()) return typeOfPackage(stream);
  return DescriptorPool::generated_pool()->FindMessageTypeByName(type);
}

}  // namespace

ChannelSetup setupOf(const std::string& path, const Descriptor& type) {
  ChannelSetup setup{path, "protobuf", type.full_name(), schemaOf(type)};
  setup.latched = isLatched(path, type.full_name());
  const bool complete =
      setup.latched || std::ranges::find(kCompleteTypes, type.full_name()) != kCompleteTypes.end();
  setup.delivery = complete ? Delivery::kComplete : Delivery::kLatest;
  setup.isCompressible = std::ranges::find(kImageTypes, type.full_name()) == kImageTypes.end();
  return setup;
}

std::vector<ChannelSetup> keyChannels(const std::string& robot, const robotcontrol::KeyTable& keys,
                                      const robotcontrol::ProcessTable& processes,
                                      const std::function<bool(const std::string& path)>& isOffered) {
  std::map<std::string, std::string> packageTypes;
  for (const auto& process : processes.processes()) {
    for (const auto* ports : {&process.senders(), &process.receivers()})
      for (const auto& port : *ports) packageTypes[port.package()] = port.type();
  }
  std::map<std::string, const Descriptor*> types;
  bool areTimed = false;
  for (const auto& key : keys.keys()) {
    areTimed |= key.stream() + "/" == streams::kStopwatches;
    if (!key.stream().empty()) types.emplace(key.stream(), typeOf(key.stream(), packageTypes));
  }
  if (areTimed) {
    for (const auto& process : processes.processes())
      types.emplace(streams::kStopwatches + process.name(), robotcontrol::StopwatchTimes::descriptor());
  }
  std::vector<ChannelSetup> setups;
  for (const auto& [stream, type] : types) {
    std::string path = robot + "/" + stream;
    if (type != nullptr && !isOffered(path)) setups.push_back(setupOf(path, *type));
  }
  return setups;
}

}  // namespace robotlink::websocket
