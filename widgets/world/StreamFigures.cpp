// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/StreamFigures.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <array>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/PackageTypes.h"
#include "robotlink/session/StreamStore.h"
#include "widgets/world/FigureShapes.h"

namespace widgets {

using robotlink::Instant;
using robotlink::StreamMessage;
using robotlink::StreamStore;

namespace {

constexpr char kSceneType[] = "foxglove.SceneUpdate";

bool isOfTransforms(const std::string& type) {
  return type == "foxglove.FrameTransforms" || type == "foxglove.FrameTransform";
}
/// At most this many messages of a scene's stream are read when going back in time.
constexpr std::ptrdiff_t kMaxSceneMessages = 2000;

struct FigureType {
  std::string_view type;
  FigureShape shape;
};
constexpr std::string_view kGridType = "foxglove.Grid";
constexpr std::array<FigureType, 13> kFigureTypes{{
    {kGridType, &packedGridFigure},
    {"foxglove.LaserScan", &scanFigure},
    {"foxglove.PointCloud", &cloudFigure},
    {"foxglove.PoseInFrame", &poseFigure},
    {"foxglove.PosesInFrame", &posesFigure},
    {"geometry_msgs.PoseArray", &posesFigure},
    {"geometry_msgs.PoseStamped", &poseFigure},
    {"geometry_msgs.PoseWithCovarianceStamped", &poseFigure},
    {"nav_msgs.OccupancyGrid", &gridFigure},
    {"nav_msgs.Odometry", &poseFigure},
    {"nav_msgs.Path", &pathFigure},
    {"sensor_msgs.PointCloud2", &cloudFigure},
    {"sensor_msgs.LaserScan", &scanFigure},
}};

const FigureType* figureType(std::string_view type) {
  const auto found = std::ranges::find(kFigureTypes, type, &FigureType::type);
  return found == kFigureTypes.end() ? nullptr : &*found;
}

/// Whether views show a stream in another way; the map that a robot makes is a figure like those of others.
bool isOwn(const std::string& path, const std::string& type) {
  if (type == kGridType) return false;
  if (path == robotlink::streams::kScene || path == robotlink::streams::kSolids ||
      path == robotlink::streams::kTransforms)
    return true;
  const std::string rest = path.substr(path.find('/') + 1);
  return rest.starts_with(robotlink::streams::kShadow) || rest.starts_with("drawings/") ||
         robotlink::typeOfPackage(rest) != nullptr;
}

}  // namespace

bool StreamFigures::canShow(const std::string& path, const std::string& type) {
  const bool isKnown = type == kSceneType || isOfTransforms(type) || figureType(type) != nullptr;
  return isKnown && !isOwn(path, type);
}

std::shared_ptr<const foxglove::SceneUpdate> figureOf(const google::protobuf::Message& message) {
  const FigureType* type = figureType(message.GetDescriptor()->full_name());
  if (type == nullptr) return nullptr;
  auto update = std::make_shared<foxglove::SceneUpdate>();
  type->shape(message, *update->add_entities());
  return update;
}

void StreamFigures::addFrame(const std::string& frame, Instant time, Shown& at) {
  if (at.entities.contains(frame)) return;
  const auto axes = std::make_shared<foxglove::SceneUpdate>();
  frameFigure(frame, *axes->add_entities());
  at.entities[frame] = {{&axes->entities(0), axes}, time};
}

void StreamFigures::follow(const StreamStore& store, const std::string& path, Instant shown, Shown& at) {
  const auto& messages = store.find(path)->messages;
  const auto end = std::ranges::upper_bound(messages, shown, {}, &StreamMessage::time);
  auto begin = end - std::min(end - messages.begin(), kMaxSceneMessages);
  if (at.message != nullptr && at.time <= shown)
    begin =
        std::max(begin, std::ranges::lower_bound(messages.begin(), end, at.time, {}, &StreamMessage::time));
  else
    at.entities.clear();
  for (; begin < end; ++begin) {
    for (const auto* transform : transformsOf(*begin->value))
      addFrame(transform->child_frame_id(), begin->time, at);
    const auto* update = dynamic_cast<const foxglove::SceneUpdate*>(begin->value.get());
    if (update == nullptr) continue;
    for (const auto& deletion : update->deletions()) {
      if (deletion.type() == foxglove::SceneEntityDeletion::ALL)
        at.entities.clear();
      else
        at.entities.erase(deletion.id());
    }
    for (const auto& entity : update->entities())
      at.entities[entity.id()] = {{&entity, begin->value}, begin->time};
  }
}

std::vector<StreamFigures::Figure> StreamFigures::of(const StreamStore& store, const std::string& path,
                                                     Instant shown) {
  std::vector<Figure> figures;
  const StreamMessage* message = store.latest(path, shown);
  if (message == nullptr) return figures;
  Shown& at = shown_[path];
  if (at.generation != store.generation()) at = {};
  at.generation = store.generation();
  const std::string& type = message->value->GetDescriptor()->full_name();
  const bool isScene = type == kSceneType || isOfTransforms(type);
  if (at.message != message->value) {
    if (isScene)
      follow(store, path, shown, at);
    else
      at.made = figureOf(*message->value);
    at.message = message->value;
    at.time = message->time;
  }
  for (const auto& [id, one] : at.entities) {
    const auto& lifetime = one.first.entity->lifetime();
    const auto life = std::chrono::seconds(lifetime.seconds()) + std::chrono::nanoseconds(lifetime.nanos());
    if (life.count() <= 0 || shown - one.second <= life) figures.push_back(one.first);
  }
  if (at.made)
    for (const auto& entity : at.made->entities()) figures.push_back({&entity, at.made});
  return figures;
}

}  // namespace widgets
