// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "colortool/image/ColorCorrection.h"
#include "colortool/image/Regions.h"
#include "colortool/table/PaletteTable.h"
#include "modules/perception/BallGeometry.h"
#include "modules/perception/LandmarkGeometry.h"

namespace robotcontrol {
class BallGeometryParameters;
class CameraPose;
class ColorCorrection;
class ColorRegions;
class ColorTable;
class LandmarkGeometryParameters;
class Lighting;
}  // namespace robotcontrol

namespace modules {

// Converts between the packages of perception and the values that its algorithms use.

CameraView cameraView(const robotcontrol::CameraPose& from);
/// Sets the pose; angles and size are those of `from`.
void assign(robotcontrol::CameraPose& to, const CameraView& from);

void assign(robotcontrol::ColorRegions& to, const std::vector<colortool::Region>& from,
            const colortool::ColorClasses& classes);
/// Reads all regions, with the class numbers of `classes` instead of those in the package.
void readRegions(const robotcontrol::ColorRegions& from, const colortool::ColorClasses& classes,
                 std::vector<colortool::Region>& to);
/// Reads only the regions of one class.
void readRegions(const robotcontrol::ColorRegions& from, std::string_view className,
                 std::vector<colortool::Region>& to);

/// The table with the class numbers of `classes`, matched by name; classes of other names become "none".
colortool::ColorTable colorTable(const robotcontrol::ColorTable& from,
                                 const colortool::ColorClasses& classes);
/// Converts a color correction; there is none if its values are not finite.
colortool::ColorCorrection colorCorrection(const robotcontrol::ColorCorrection& from);

colortool::LightingRange lightingRange(const robotcontrol::Lighting& from);
/// Unset parameters keep their built-in values.
BallGeometry::Options ballGeometry(const robotcontrol::BallGeometryParameters& from, double ballRadius);
LandmarkGeometry::Options landmarkGeometry(const robotcontrol::LandmarkGeometryParameters& from);

}  // namespace modules
