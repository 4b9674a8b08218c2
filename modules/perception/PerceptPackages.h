// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "colortool/ColorCorrection.h"
#include "colortool/PaletteTable.h"
#include "colortool/Regions.h"
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

// Between the packages of perception and the values that its algorithms calculate with.

CameraView cameraView(const robotcontrol::CameraPose& from);
/// Sets the place; angles and size as given.
void assign(robotcontrol::CameraPose& to, const CameraView& from);

void assign(robotcontrol::ColorRegions& to, const std::vector<colortool::Region>& from,
            const colortool::ColorClasses& classes);
/// All regions, with the class numbers of `classes` instead of those that the package has.
void readRegions(const robotcontrol::ColorRegions& from, const colortool::ColorClasses& classes,
                 std::vector<colortool::Region>& to);
/// Those of one class only.
void readRegions(const robotcontrol::ColorRegions& from, std::string_view className,
                 std::vector<colortool::Region>& to);

/// The same table with the class numbers of `classes`, by their names; classes of other names are none.
colortool::ColorTable colorTable(const robotcontrol::ColorTable& from,
                                 const colortool::ColorClasses& classes);
/// None if its values are no numbers.
colortool::ColorCorrection colorCorrection(const robotcontrol::ColorCorrection& from);

colortool::LightingRange lightingRange(const robotcontrol::Lighting& from);
BallGeometry::Options ballGeometry(const robotcontrol::BallGeometryParameters& from, double ballRadius);
LandmarkGeometry::Options landmarkGeometry(const robotcontrol::LandmarkGeometryParameters& from);

}  // namespace modules
