// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/KnownMarkers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "foxglove/Scene.pb.h"
#include "robotlink/ros/MessageView.h"

namespace robotlink::ros {
namespace {

/// The numbers of visualization_msgs/Marker: kinds of figures, and what is to be done with one.
enum MarkerKind : std::uint32_t {
  kArrow = 0,
  kCube = 1,
  kSphere = 2,
  kCylinder = 3,
  kLineStrip = 4,
  kLineList = 5,
  kCubeList = 6,
  kSphereList = 7,
  kPoints = 8,
  kText = 9,
  kTriangles = 11
};
enum MarkerAction : std::uint32_t { kAdd = 0, kDelete = 2, kDeleteAll = 3 };

/// A definition may call anything a number.
std::string numberText(double number) {
  const bool isWhole = std::abs(number) <= std::numeric_limits<std::int32_t>::max();
  return isWhole ? std::to_string(static_cast<std::int32_t>(number)) : "?";
}

void assignColor(foxglove::Color& to, const MessageView& from) {
  to.set_r(from.number("r"));
  to.set_g(from.number("g"));
  to.set_b(from.number("b"));
  to.set_a(from.number("a"));
}

void assignPoint(foxglove::Point3& to, const MessageView& from) {
  to.set_x(from.number("x"));
  to.set_y(from.number("y"));
  to.set_z(from.number("z"));
}

/// Converts a marker to parts of an entity.
class MarkerShape {
 public:
  MarkerShape(const MessageView& marker, foxglove::SceneEntity& entity) : marker_(marker), entity_(entity) {
    assignColor(color_, marker.in("color"));
    assign(*pose_.mutable_position(), marker.in("pose").in("position"));
    assign(*pose_.mutable_orientation(), marker.in("pose").in("orientation"));
    assign(scale_, marker.in("scale"));
  }

  void add() {
    switch (marker_.natural("type")) {
      case kArrow:
        return addArrow();
      case kCube:
        return fill(*entity_.add_cubes(), pose_, color_);
      case kSphere:
        return fill(*entity_.add_spheres(), pose_, color_);
      case kCylinder: {
        auto& cylinder = *entity_.add_cylinders();
        cylinder.set_bottom_scale(1);
        cylinder.set_top_scale(1);
        return fill(cylinder, pose_, color_);
      }
      case kLineStrip:
        return addLines(foxglove::LinePrimitive::LINE_STRIP);
      case kLineList:
        return addLines(foxglove::LinePrimitive::LINE_LIST);
      case kCubeList:
        return addAtPoints(
            [this](const auto& at, const auto& color) { fill(*entity_.add_cubes(), at, color); });
      case kSphereList:
        return addAtPoints(
            [this](const auto& at, const auto& color) { fill(*entity_.add_spheres(), at, color); });
      case kPoints:
        // Squares in ROS; as high as they are wide, so that they are seen from all sides.
        scale_.set_z(scale_.x());
        return addAtPoints(
            [this](const auto& at, const auto& color) { fill(*entity_.add_cubes(), at, color); });
      case kText:
        return addText();
      case kTriangles:
        return addTriangles();
      default:
        return;
    }
  }

 private:
  template <typename Primitive>
  void fill(Primitive& primitive, const foxglove::Pose& pose, const foxglove::Color& color) {
    *primitive.mutable_pose() = pose;
    *primitive.mutable_size() = scale_;
    *primitive.mutable_color() = color;
  }
  foxglove::Color colorAt(int index) const {
    if (index >= marker_.count("colors")) return color_;
    foxglove::Color color;
    assignColor(color, marker_.element("colors", index));
    return color;
  }
  /// Points turned by the marker's pose, so that the primitives need no pose of a pose.
  foxglove::Pose poseOfPoint(int index) const {
    const MessageView point = marker_.element("points", index);
    const auto& q = pose_.orientation();
    const double x = point.number("x"), y = point.number("y"), z = point.number("z");
    // v + 2 w (u x v) + 2 u x (u x v), for the unit quaternion (u, w).
    const double cx = q.y() * z - q.z() * y, cy = q.z() * x - q.x() * z, cz = q.x() * y - q.y() * x;
    foxglove::Pose pose = pose_;
    auto& at = *pose.mutable_position();
    at.set_x(at.x() + x + 2 * (q.w() * cx + q.y() * cz - q.z() * cy));
    at.set_y(at.y() + y + 2 * (q.w() * cy + q.z() * cx - q.x() * cz));
    at.set_z(at.z() + z + 2 * (q.w() * cz + q.x() * cy - q.y() * cx));
    return pose;
  }
  template <typename Add>
  void addAtPoints(Add addOne) {
    for (int i = 0; i < marker_.count("points"); ++i) addOne(poseOfPoint(i), colorAt(i));
  }
  template <typename Primitive>
  void addPoints(Primitive& primitive) {
    *primitive.mutable_pose() = pose_;
    *primitive.mutable_color() = color_;
    for (int i = 0; i < marker_.count("points"); ++i)
      assignPoint(*primitive.add_points(), marker_.element("points", i));
    if (marker_.count("colors") != marker_.count("points")) return;
    for (int i = 0; i < marker_.count("colors"); ++i) *primitive.add_colors() = colorAt(i);
  }

  void addLines(foxglove::LinePrimitive::Type type) {
    auto& lines = *entity_.add_lines();
    lines.set_type(type);
    lines.set_thickness(scale_.x());
    addPoints(lines);
  }
  void addTriangles() { addPoints(*entity_.add_triangles()); }
  void addText() {
    auto& text = *entity_.add_texts();
    *text.mutable_pose() = pose_;
    text.set_billboard(true);
    text.set_font_size(scale_.z());
    *text.mutable_color() = color_;
    text.set_text(marker_.text("text"));
  }
  void addArrow() {
    auto& arrow = *entity_.add_arrows();
    *arrow.mutable_color() = color_;
    *arrow.mutable_pose() = pose_;
    if (marker_.count("points") < 2) {
      // The head takes 0.23 of the length and is as wide as the marker, as in rviz.
      arrow.set_shaft_length(0.77 * scale_.x());
      arrow.set_head_length(0.23 * scale_.x());
      arrow.set_shaft_diameter(scale_.y() / 2);
      arrow.set_head_diameter(scale_.y());
      return;
    }
    const foxglove::Pose from = poseOfPoint(0), to = poseOfPoint(1);
    const double x = to.position().x() - from.position().x(), y = to.position().y() - from.position().y(),
                 z = to.position().z() - from.position().z();
    const double length = std::sqrt(x * x + y * y + z * z);
    const double head = scale_.z() > 0 ? std::min(scale_.z(), length) : 0.23 * length;
    *arrow.mutable_pose() = from;
    // The shortest turn of the x axis to that direction; half of the sum with it is its axis.
    auto& q = *arrow.mutable_pose()->mutable_orientation();
    const double w = length + x, norm = std::sqrt(w * w + y * y + z * z);
    q.set_x(0);
    q.set_y(norm > 0 ? -z / norm : 1);
    q.set_z(norm > 0 ? y / norm : 0);
    q.set_w(norm > 0 ? w / norm : 0);
    arrow.set_shaft_length(length - head);
    arrow.set_head_length(head);
    arrow.set_shaft_diameter(scale_.x());
    arrow.set_head_diameter(scale_.y());
  }

  const MessageView marker_;
  foxglove::SceneEntity& entity_;
  foxglove::Color color_;
  foxglove::Pose pose_;
  foxglove::Vector3 scale_;
};

void addMarker(foxglove::SceneUpdate& scene, const MessageView& marker) {
  const std::string id = marker.text("ns") + "/" + numberText(marker.number("id"));
  const std::uint32_t action = marker.natural("action");
  if (action == kDelete || action == kDeleteAll) {
    auto& deletion = *scene.add_deletions();
    assign(*deletion.mutable_timestamp(), marker.in("header").in("stamp"));
    deletion.set_type(action == kDelete ? foxglove::SceneEntityDeletion::MATCHING_ID
                                        : foxglove::SceneEntityDeletion::ALL);
    if (action == kDelete) deletion.set_id(id);
    return;
  }
  if (action != kAdd) return;
  auto& entity = *scene.add_entities();
  assign(*entity.mutable_timestamp(), marker.in("header").in("stamp"));
  entity.set_frame_id(marker.in("header").text("frame_id"));
  entity.set_id(id);
  entity.set_frame_locked(marker.number("frame_locked") != 0);
  const MessageView lifetime = marker.in("lifetime");
  entity.mutable_lifetime()->set_seconds(lifetime.natural("seconds"));
  entity.mutable_lifetime()->set_nanos(static_cast<std::int32_t>(lifetime.natural("nanos") % 1'000'000'000));
  MarkerShape(marker, entity).add();
}

}  // namespace

PackagePtr sceneOfMarker(const google::protobuf::Message& message) {
  auto scene = std::make_shared<foxglove::SceneUpdate>();
  addMarker(*scene, MessageView(&message));
  return scene;
}

PackagePtr sceneOfMarkers(const google::protobuf::Message& message) {
  auto scene = std::make_shared<foxglove::SceneUpdate>();
  const MessageView from(&message);
  for (int i = 0; i < from.count("markers"); ++i) addMarker(*scene, from.element("markers", i));
  return scene;
}

}  // namespace robotlink::ros
