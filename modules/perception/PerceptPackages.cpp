// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/PerceptPackages.h"

#include <algorithm>
#include <cmath>

#include "PerceptionParameters.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"

namespace modules {

using colortool::Region;

CameraView cameraView(const robotcontrol::CameraPose& from) {
  return CameraView::fromAngles(robotlink::pose3(from.camera_in_robot()), from.horizontal_angle(),
                                from.vertical_angle(), static_cast<int>(from.width()),
                                static_cast<int>(from.height()));
}

void assign(robotcontrol::CameraPose& to, const CameraView& from) {
  robotlink::assign(*to.mutable_camera_in_robot(), from.cameraInRobot);
  to.set_horizontal_angle(2 * std::atan(0.5 * from.width / from.focalX));
  to.set_vertical_angle(2 * std::atan(0.5 * from.height / from.focalY));
  to.set_width(static_cast<std::uint32_t>(from.width));
  to.set_height(static_cast<std::uint32_t>(from.height));
}

void assign(robotcontrol::ColorRegions& to, const std::vector<Region>& from,
            const colortool::ColorClasses& classes) {
  for (int i = 0; i < classes.size(); ++i) to.add_class_names(classes.name(i));
  to.mutable_regions()->Reserve(static_cast<int>(from.size()));
  for (const Region& region : from) {
    robotcontrol::ColorRegion& added = *to.add_regions();
    added.set_color_class(static_cast<std::uint32_t>(region.colorClass));
    added.set_area(static_cast<std::uint32_t>(region.area));
    added.set_left(static_cast<std::uint32_t>(region.left));
    added.set_top(static_cast<std::uint32_t>(region.top));
    added.set_right(static_cast<std::uint32_t>(region.right));
    added.set_bottom(static_cast<std::uint32_t>(region.bottom));
    added.set_center_x(region.centerX);
    added.set_center_y(region.centerY);
  }
}

namespace {

Region regionOf(const robotcontrol::ColorRegion& from, int colorClass) {
  return {colorClass,
          static_cast<int>(from.area()),
          static_cast<int>(from.left()),
          static_cast<int>(from.top()),
          static_cast<int>(from.right()),
          static_cast<int>(from.bottom()),
          from.center_x(),
          from.center_y()};
}

}  // namespace

void readRegions(const robotcontrol::ColorRegions& from, const colortool::ColorClasses& classes,
                 std::vector<Region>& to) {
  to.clear();
  std::vector<int> numbers;
  for (const std::string& name : from.class_names()) numbers.push_back(classes.index(name));
  for (const robotcontrol::ColorRegion& region : from.regions()) {
    const std::size_t number = region.color_class();
    if (number < numbers.size() && numbers[number] != 0) to.push_back(regionOf(region, numbers[number]));
  }
}

void readRegions(const robotcontrol::ColorRegions& from, std::string_view className,
                 std::vector<Region>& to) {
  to.clear();
  const auto found = std::ranges::find(from.class_names(), className);
  const int number = static_cast<int>(found - from.class_names().begin());
  for (const robotcontrol::ColorRegion& region : from.regions())
    if (static_cast<int>(region.color_class()) == number) to.push_back(regionOf(region, number));
}

colortool::ColorTable colorTable(const robotcontrol::ColorTable& from,
                                 const colortool::ColorClasses& classes) {
  std::vector<std::uint8_t> numbers{colortool::ColorClasses::kNone};
  for (const std::string& name : from.class_names()) numbers.push_back(classes.index(name));
  const auto* cells = reinterpret_cast<const std::uint8_t*>(from.cells().data());
  return colortool::ColorTable::translated({cells, from.cells().size()}, numbers);
}

colortool::ColorCorrection colorCorrection(const robotcontrol::ColorCorrection& from) {
  colortool::ColorCorrection to;
  to.vignetting = {
      {from.luma_r2(), from.luma_r4()}, {from.blue_r2(), from.blue_r4()}, {from.red_r2(), from.red_r4()}};
  if (from.has_y()) to.channels[0] = {from.y().gain(), from.y().offset()};
  if (from.has_cb()) to.channels[1] = {from.cb().gain(), from.cb().offset()};
  if (from.has_cr()) to.channels[2] = {from.cr().gain(), from.cr().offset()};
  return to.isFinite() ? to : colortool::ColorCorrection{};
}

colortool::LightingRange lightingRange(const robotcontrol::Lighting& from) {
  return {from.darkest(), from.brightest(), from.usual(), from.tolerance(), from.brightness_weight()};
}

BallGeometry::Options ballGeometry(const robotcontrol::BallGeometryParameters& from, double ballRadius) {
  return {ballRadius, from.maximum_distance(), from.tilt_deviation(), from.gate()};
}

LandmarkGeometry::Options landmarkGeometry(const robotcontrol::LandmarkGeometryParameters& from) {
  return {from.minimum_height(), from.maximum_distance(), from.tilt_tolerance()};
}

}  // namespace modules
