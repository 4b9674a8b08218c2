// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/FigureShapes.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "foxglove/Grid.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GridConversions.h"
#include "robotlink/ros/MessageView.h"

namespace widgets {
namespace {

using google::protobuf::Message;
using robotlink::Pose3;
using robotlink::Vector3;
using robotlink::ros::MessageView;

constexpr int kMaxDots = 5000, kMaxArrows = 2000, kMaxSquares = 100'000;
/// m
constexpr double kDotSize = 0.03, kArrowLength = 0.3;

struct Shade {
  double r, g, b;
};
constexpr Shade kScanShade{0.9, 0.2, 0.2}, kCloudShade{0.3, 0.6, 0.9}, kPoseShade{0.1, 0.7, 0.3},
    kPathShade{0.2, 0.8, 0.2};
/// A blue gray in the middle between the backgrounds of the light and the dark theme.
constexpr Shade kWallShade{0.42, 0.5, 0.6};

void setColor(foxglove::Color& to, const Shade& from) {
  to.set_r(from.r);
  to.set_g(from.g);
  to.set_b(from.b);
  to.set_a(1);
}

/// The frame is in the header in ROS, and in the message itself elsewhere.
void setFrame(foxglove::SceneEntity& entity, const MessageView& from) {
  const std::string& own = from.text("frame_id");
  entity.set_frame_id(own.empty() ? from.in("header").text("frame_id") : own);
}

Pose3 poseIn(const MessageView& from) {
  foxglove::Pose pose;
  robotlink::ros::assign(*pose.mutable_position(), from.in("position"));
  robotlink::ros::assign(*pose.mutable_orientation(), from.in("orientation"));
  const auto& q = pose.orientation();
  if (q.x() == 0 && q.y() == 0 && q.z() == 0 && q.w() == 0) pose.mutable_orientation()->set_w(1);
  return robotlink::pose3(pose);
}

bool isFinite(const Vector3& point) {
  return point.allFinite();
}

/// Squares that face up, as one list of triangles.
class Squares {
 public:
  Squares(foxglove::SceneEntity& entity, const Pose3& pose, const Shade& shade)
      : triangles_(*entity.add_triangles()) {
    robotlink::assign(*triangles_.mutable_pose(), pose);
    setColor(*triangles_.mutable_color(), shade);
  }
  void add(const Vector3& corner, double x, double y) {
    const int first = triangles_.points_size();
    for (const auto& [dx, dy] : {std::pair(0.0, 0.0), {x, 0.0}, {x, y}, {0.0, y}}) {
      auto& point = *triangles_.add_points();
      point.set_x(corner.x() + dx);
      point.set_y(corner.y() + dy);
      point.set_z(corner.z());
    }
    for (const int i : {0, 1, 2, 0, 2, 3}) triangles_.add_indices(static_cast<std::uint32_t>(first + i));
  }
  void addDot(const Vector3& at) {
    if (isFinite(at)) add(at - Vector3(kDotSize / 2, kDotSize / 2, 0), kDotSize, kDotSize);
  }

 private:
  foxglove::TriangleListPrimitive& triangles_;
};

void addArrow(foxglove::SceneEntity& entity, const Pose3& pose) {
  if (!pose.matrix().allFinite()) return;
  auto& arrow = *entity.add_arrows();
  robotlink::assign(*arrow.mutable_pose(), pose);
  arrow.set_shaft_length(0.7 * kArrowLength);
  arrow.set_head_length(0.3 * kArrowLength);
  arrow.set_shaft_diameter(0.1 * kArrowLength);
  arrow.set_head_diameter(0.3 * kArrowLength);
  setColor(*arrow.mutable_color(), kPoseShade);
}

/// A pose may be within one with a time, or with a covariance.
MessageView innerPose(const MessageView& from) {
  MessageView pose = from;
  for (int depth = 0; depth < 3 && pose.in("pose").isThere(); ++depth) pose = pose.in("pose");
  return pose;
}

/// The offset of a coordinate in a point of a cloud, as a float of 32 or 64 bits; -1: it has none.
struct CloudField {
  long offset = -1;
  bool isDouble = false;
};
CloudField cloudField(const MessageView& from, const char* name) {
  for (int i = 0; i < from.count("fields"); ++i) {
    const MessageView field = from.element("fields", i);
    if (field.text("name") != name) continue;
    // FLOAT32 and FLOAT64 are 7 and 8 in both.
    const auto type = field.natural(from.has("point_stride") ? "type" : "datatype");
    if (type == 7 || type == 8) return {static_cast<long>(field.natural("offset")), type == 8};
  }
  return {};
}
double valueOf(const std::string& bytes, std::size_t point, const CloudField& field) {
  const std::size_t at = point + static_cast<std::size_t>(field.offset), size = field.isDouble ? 8 : 4;
  if (field.offset < 0 || at + size > bytes.size()) return field.offset < 0 ? 0 : std::nan("");
  double wide = 0;
  float narrow = 0;
  std::memcpy(field.isDouble ? static_cast<void*>(&wide) : &narrow, bytes.data() + at, size);
  return field.isDouble ? wide : static_cast<double>(narrow);
}

}  // namespace

void scanFigure(const Message& message, foxglove::SceneEntity& entity) {
  const MessageView from(&message);
  setFrame(entity, from);
  const std::vector<double> ranges = from.numbers("ranges");
  const int count = static_cast<int>(ranges.size());
  const bool isRos = from.has("angle_min");
  const double start = from.number(isRos ? "angle_min" : "start_angle");
  const double step = isRos       ? from.number("angle_increment")
                      : count > 1 ? (from.number("end_angle") - start) / (count - 1)
                                  : 0;
  Squares dots(entity, isRos ? Pose3::Identity() : poseIn(from.in("pose")), kScanShade);
  const int stride = std::max(1, count / kMaxDots);
  for (int i = 0; i < count; i += stride) {
    const double range = ranges[static_cast<std::size_t>(i)], angle = start + i * step;
    if (range > 0) dots.addDot({range * std::cos(angle), range * std::sin(angle), 0});
  }
}

void cloudFigure(const Message& message, foxglove::SceneEntity& entity) {
  const MessageView from(&message);
  setFrame(entity, from);
  const bool isRos = !from.has("point_stride");
  const std::size_t size = from.natural(isRos ? "point_step" : "point_stride");
  const CloudField x = cloudField(from, "x"), y = cloudField(from, "y"), z = cloudField(from, "z");
  const std::string& bytes = from.text("data");
  if (size == 0 || x.offset < 0 || y.offset < 0) return;
  Squares dots(entity, isRos ? Pose3::Identity() : poseIn(from.in("pose")), kCloudShade);
  const std::size_t stride = std::max<std::size_t>(1, bytes.size() / size / kMaxDots);
  for (std::size_t at = 0; at + size <= bytes.size(); at += size * stride)
    dots.addDot({valueOf(bytes, at, x), valueOf(bytes, at, y), valueOf(bytes, at, z)});
}

void poseFigure(const Message& message, foxglove::SceneEntity& entity) {
  const MessageView from(&message);
  setFrame(entity, from);
  addArrow(entity, poseIn(innerPose(from)));
}

void posesFigure(const Message& message, foxglove::SceneEntity& entity) {
  const MessageView from(&message);
  setFrame(entity, from);
  for (int i = 0; i < std::min(from.count("poses"), kMaxArrows); ++i)
    addArrow(entity, poseIn(innerPose(from.element("poses", i))));
}

void pathFigure(const Message& message, foxglove::SceneEntity& entity) {
  const MessageView from(&message);
  setFrame(entity, from);
  auto& line = *entity.add_lines();
  line.set_thickness(2);
  line.set_scale_invariant(true);
  setColor(*line.mutable_color(), kPathShade);
  const int count = from.count("poses"), stride = std::max(1, count / kMaxDots);
  for (int i = 0; i < count; i += stride) {
    const Vector3 at = poseIn(innerPose(from.element("poses", i))).translation();
    if (!isFinite(at)) continue;
    auto& point = *line.add_points();
    point.set_x(at.x());
    point.set_y(at.y());
    point.set_z(at.z());
  }
}

void gridFigure(const Message& message, foxglove::SceneEntity& entity) {
  constexpr double kOccupied = 50;  // of 100; -1: unknown
  const MessageView from(&message), info = from.in("info");
  setFrame(entity, from);
  const double cell = info.number("resolution");
  const std::size_t width = info.natural("width");
  const std::vector<double> cells = from.numbers("data");
  if (!(cell > 0) || width == 0) return;
  Squares squares(entity, poseIn(info.in("origin")), kWallShade);
  // Neighbors in a row become one square.
  int added = 0;
  for (std::size_t row = 0; row + width <= cells.size() && added < kMaxSquares; row += width) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t begin = x;
      while (x < width && cells[row + x] >= kOccupied) ++x;
      if (x == begin) continue;
      squares.add({static_cast<double>(begin) * cell, static_cast<double>(row / width) * cell, 0},
                  static_cast<double>(x - begin) * cell, cell);
      ++added;
    }
  }
}

void packedGridFigure(const Message& message, foxglove::SceneEntity& entity) {
  setFrame(entity, MessageView(&message));
  // A message from a connection has a type that was made from its description.
  foxglove::Grid parsed;
  const auto* grid = dynamic_cast<const foxglove::Grid*>(&message);
  if (grid == nullptr && parsed.ParseFromString(message.SerializeAsString())) grid = &parsed;
  if (grid == nullptr) return;
  Squares squares(entity, robotlink::pose3(grid->pose()), kWallShade);
  int added = 0;
  robotlink::forOccupiedRuns(*grid, [&](const robotlink::GridRun& run) {
    squares.add({run.low.x(), run.low.y(), 0}, run.length, run.width);
    return ++added < kMaxSquares;
  });
}

void frameFigure(const std::string& frame, foxglove::SceneEntity& entity) {
  entity.set_frame_id(frame);
  entity.set_id(frame);
  constexpr Shade kAxes[]{{0.9, 0.1, 0.1}, {0.1, 0.7, 0.1}, {0.2, 0.3, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    auto& line = *entity.add_lines();
    line.set_thickness(2);
    line.set_scale_invariant(true);
    line.mutable_pose()->mutable_orientation()->set_w(1);
    setColor(*line.mutable_color(), kAxes[axis]);
    const Vector3 end = kArrowLength * Vector3::Unit(axis);
    line.add_points();
    auto& point = *line.add_points();
    point.set_x(end.x());
    point.set_y(end.y());
    point.set_z(end.z());
  }
  auto& text = *entity.add_texts();
  text.mutable_pose()->mutable_orientation()->set_w(1);
  text.set_billboard(true);
  text.set_scale_invariant(true);
  text.set_font_size(12);
  setColor(*text.mutable_color(), kPoseShade);
  text.set_text(frame);
}

}  // namespace widgets
