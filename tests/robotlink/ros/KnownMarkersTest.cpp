// SPDX-License-Identifier: GPL-3.0-or-later
// The figures that markers of ROS become, with poses, points and colors.
#include "robotlink/ros/KnownMarkers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "foxglove/Scene.pb.h"
#include "robotlink/base/Geometry.h"
#include "tests/robotlink/ros/RosMessages.h"

namespace robotlink::ros {
namespace {

constexpr char kMarkerDefinition[] =
    "string ns\nint32 id\nint32 type\nint32 action\nPose pose\nXyz scale\nRgba color\nXyz[] points\n"
    "Rgba[] colors\nstring text"
    "\n===\nMSG: a/Pose\nXyz position\nXyzw orientation\n===\nMSG: a/Xyz\nfloat64 x\nfloat64 y\nfloat64 z"
    "\n===\nMSG: a/Xyzw\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w"
    "\n===\nMSG: a/Rgba\nfloat32 r\nfloat32 g\nfloat32 b\nfloat32 a";

enum MarkerNumber : std::int32_t {
  kArrowMarker = 0,
  kCylinderMarker = 3,
  kLineListMarker = 5,
  kSphereListMarker = 7,
  kPointsMarker = 8,
  kTrianglesMarker = 11
};

struct MarkerColor {
  float r = 0, g = 0, b = 0, a = 1;
};

const Vector3 kOrigin = Vector3::Zero();
const Eigen::Quaterniond kUnturned = Eigen::Quaterniond::Identity();

/// A marker of the namespace "n" with the number 7; gray.
struct SentMarker {
  std::int32_t kind = 0;
  Vector3 position = Vector3::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Vector3 scale = {1, 1, 1};
  std::vector<Vector3> points = {};
  std::vector<MarkerColor> colors = {};
};

/// The bytes of a message of ROS 1.
class RosBytes {
 public:
  template <typename Number>
  RosBytes& put(Number number) {
    const auto* from = reinterpret_cast<const std::uint8_t*>(&number);
    bytes.insert(bytes.end(), from, from + sizeof number);
    return *this;
  }
  RosBytes& put(const Vector3& vector) { return put(vector.x()).put(vector.y()).put(vector.z()); }
  RosBytes& put(const MarkerColor& color) { return put(color.r).put(color.g).put(color.b).put(color.a); }
  RosBytes& put(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size()));
    bytes.insert(bytes.end(), text.begin(), text.end());
    return *this;
  }
  template <typename Element>
  RosBytes& put(const std::vector<Element>& list) {
    put(static_cast<std::uint32_t>(list.size()));
    for (const Element& element : list) put(element);
    return *this;
  }
  std::vector<std::uint8_t> bytes;
};

/// The only entity that a marker becomes.
foxglove::SceneEntity entityOf(const SentMarker& marker) {
  const auto type = RosType::of("a/Marker", "ros1msg", kMarkerDefinition, "ros1");
  if (!type) {
    ADD_FAILURE() << type.error().text;
    return {};
  }
  RosBytes data;
  data.put(std::string("n")).put(std::int32_t{7}).put(marker.kind).put(std::int32_t{0});
  data.put(marker.position).put(marker.turn.x()).put(marker.turn.y()).put(marker.turn.z());
  data.put(marker.turn.w()).put(marker.scale).put(MarkerColor{0.5F, 0.5F, 0.5F, 1});
  data.put(marker.points).put(marker.colors).put(std::string());
  const auto message = RosType::read(*type, data.bytes);
  if (!message) {
    ADD_FAILURE() << message.error().text;
    return {};
  }
  const PackagePtr scene = sceneOfMarker(**message);
  const auto& update = dynamic_cast<const foxglove::SceneUpdate&>(*scene);
  EXPECT_EQ(update.entities_size(), 1);
  return update.entities_size() == 1 ? update.entities(0) : foxglove::SceneEntity{};
}

Vector3 vectorOf(const foxglove::Vector3& from) {
  return {from.x(), from.y(), from.z()};
}
Vector3 placeOf(const foxglove::Pose& pose) {
  return vectorOf(pose.position());
}
/// Where the x-axis of a pose points.
Vector3 directionOf(const foxglove::Pose& pose) {
  const auto& q = pose.orientation();
  return Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()) * Vector3::UnitX();
}

TEST(KnownMarkers, pointsOfAListAreTurnedByThePoseOfTheirMarker) {
  SentMarker marker{kSphereListMarker, {10, 0, 0}};
  // A turn by 120 degrees about the diagonal: x becomes y, y becomes z, z becomes x.
  marker.turn = Eigen::AngleAxisd(2 * kPi / 3, Vector3(1, 1, 1).normalized());
  marker.points = {{1, 2, 3}, {0, 0, 0}};
  const auto entity = entityOf(marker);
  ASSERT_EQ(entity.spheres_size(), 2);
  EXPECT_TRUE(placeOf(entity.spheres(0).pose()).isApprox(Vector3(13, 1, 2)));
  EXPECT_TRUE(placeOf(entity.spheres(1).pose()).isApprox(Vector3(10, 0, 0)));
}

TEST(KnownMarkers, aPointHasItsOwnColorIfThereIsOne) {
  const auto entity =
      entityOf({kSphereListMarker, kOrigin, kUnturned, {1, 1, 1}, {{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0, 0.5F}}});
  ASSERT_EQ(entity.spheres_size(), 2);
  EXPECT_EQ(entity.spheres(0).color().r(), 1);
  EXPECT_EQ(entity.spheres(0).color().a(), 0.5);
  EXPECT_EQ(entity.spheres(1).color().r(), 0.5) << "the others have that of the marker";
}

TEST(KnownMarkers, linesAndTrianglesHaveColorsOnlyIfEachPointHasOne) {
  SentMarker marker{kTrianglesMarker};
  marker.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  marker.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(entityOf(marker).triangles(0).colors_size(), 3);
  EXPECT_EQ(entityOf(marker).triangles(0).colors(1).g(), 1);
  marker.colors.pop_back();
  EXPECT_EQ(entityOf(marker).triangles(0).colors_size(), 0);
  marker.kind = kLineListMarker;
  const auto lines = entityOf(marker).lines(0);
  EXPECT_EQ(lines.type(), foxglove::LinePrimitive::LINE_LIST);
  EXPECT_EQ(lines.points_size(), 3);
  EXPECT_EQ(lines.color().r(), 0.5);
}

TEST(KnownMarkers, squaresAtPointsAreAsHighAsWide) {
  const auto entity = entityOf({kPointsMarker, kOrigin, kUnturned, {0.2, 0.3, 0}, {{1, 2, 3}}, {}});
  ASSERT_EQ(entity.cubes_size(), 1);
  EXPECT_EQ(vectorOf(entity.cubes(0).size()), Vector3(0.2, 0.3, 0.2));
}

TEST(KnownMarkers, aCylinderIsAsWideAboveAsBelow) {
  const auto entity = entityOf({kCylinderMarker, {1, 2, 3}});
  ASSERT_EQ(entity.cylinders_size(), 1);
  EXPECT_EQ(entity.cylinders(0).bottom_scale(), 1);
  EXPECT_EQ(entity.cylinders(0).top_scale(), 1);
  EXPECT_EQ(placeOf(entity.cylinders(0).pose()), Vector3(1, 2, 3));
}

TEST(KnownMarkers, anArrowWithoutPointsIsAsLongAsItsMarker) {
  const auto entity = entityOf({kArrowMarker, {1, 0, 0}, kUnturned, {2, 0.4, 0.1}, {}, {}});
  ASSERT_EQ(entity.arrows_size(), 1);
  const auto& arrow = entity.arrows(0);
  EXPECT_NEAR(arrow.shaft_length() + arrow.head_length(), 2, 1e-12);
  EXPECT_NEAR(arrow.head_length(), 0.46, 1e-12);
  EXPECT_NEAR(arrow.head_diameter(), 0.4, 1e-12);
  EXPECT_NEAR(arrow.shaft_diameter(), 0.2, 1e-12);
}

TEST(KnownMarkers, anArrowGoesFromItsFirstPointToItsSecondInAnyDirection) {
  for (const Vector3& way : {Vector3(2, 0, 0), Vector3(-2, 0, 0), Vector3(0, -2, 0), Vector3(0, 0, 2),
                             Vector3(-1, 0.001, 0), Vector3(-3, 4, -12)}) {
    const Vector3 from(1, 2, 3);
    const auto entity = entityOf({kArrowMarker, kOrigin, kUnturned, {0.1, 0.2, 0}, {from, from + way}, {}});
    ASSERT_EQ(entity.arrows_size(), 1);
    const auto& arrow = entity.arrows(0);
    EXPECT_EQ(placeOf(arrow.pose()), from);
    EXPECT_TRUE(directionOf(arrow.pose()).isApprox(way.normalized(), 1e-6)) << way.transpose();
    EXPECT_NEAR(arrow.shaft_length() + arrow.head_length(), way.norm(), 1e-9);
    EXPECT_NEAR(arrow.head_length(), 0.23 * way.norm(), 1e-9);
    EXPECT_EQ(arrow.shaft_diameter(), 0.1);
  }
}

TEST(KnownMarkers, aHeadIsNotLongerThanItsArrow) {
  const auto entity = entityOf({kArrowMarker, kOrigin, kUnturned, {0.1, 0.2, 5}, {{0, 0, 0}, {2, 0, 0}}, {}});
  EXPECT_EQ(entity.arrows(0).head_length(), 2);
  EXPECT_EQ(entity.arrows(0).shaft_length(), 0);
}

TEST(KnownMarkers, anArrowToItsOwnStartIsNoNumberNowhere) {
  const auto entity = entityOf({kArrowMarker, kOrigin, kUnturned, {0.1, 0.2, 0}, {{1, 1, 1}, {1, 1, 1}}, {}});
  const auto& arrow = entity.arrows(0);
  EXPECT_EQ(arrow.shaft_length() + arrow.head_length(), 0);
  EXPECT_NEAR(directionOf(arrow.pose()).norm(), 1, 1e-9);
}

}  // namespace
}  // namespace robotlink::ros
