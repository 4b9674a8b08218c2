// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "robotlink/base/Image.h"

namespace colortool {

/// Coordinate systems for colors. A color table works in kYCbCr; the others exist for display only.
enum class ColorSpace : std::uint8_t { kYCbCr, kRgb, kHsi, kTsl };
inline constexpr std::array kColorSpaces = {ColorSpace::kYCbCr, ColorSpace::kRgb, ColorSpace::kHsi,
                                            ColorSpace::kTsl};

/// The display name: "YCbCr", "HSI".
const char* nameOf(ColorSpace space);
/// Returns the names of the three channels, in the order of the space's name.
std::array<const char*, 3> channelNames(ColorSpace space);
/// Whether the space is a cylinder (HSI, TSL): the first channel is an angle, the second the distance from
/// the gray axis, the third the height. The other spaces are cubes.
constexpr bool isCylinder(ColorSpace space) {
  return space == ColorSpace::kHsi || space == ColorSpace::kTsl;
}

/// Any color in YCbCr or RGB, also between those that pixels can have; channels range from 0 to 255.
using ColorValue = Eigen::Vector3f;
/// A color with channels from 0 to 1. Hue and tint are fractions of a turn in [0, 1).
using UnitColor = Eigen::Vector3f;

/// Converts by full-range BT.601 (JFIF 1.02) without rounding or clamping: some YCbCr colors have no RGB
/// equivalent and yield channels out of range.
ColorValue rgbOf(const ColorValue& yCbCr);
/// Whether the color has an RGB equivalent, or is off by at most `tolerance` in each channel.
bool hasRgb(const ColorValue& yCbCr, float tolerance = 0);

/// Gonzalez and Woods, Digital Image Processing, 3rd edition, 6.2.3: I = (r + g + b) / 3, S = 1 - min / I, H
/// is the angle from red around the gray axis. Gray gets hue 0, black gets saturation 0.
UnitColor hsiOf(const UnitColor& rgb);
/// Terrillon, David and Akamatsu, Automatic detection of human faces in natural scene images by use of a skin
/// color model, 1998: with r' = r / (r + g + b) - 1/3 and g' likewise, T = arctan(r' / g') / 2 pi + 1/4 (+
/// 1/2 where g' < 0), S = sqrt(9/5 (r'^2 + g'^2)), L = 0.299 r + 0.587 g + 0.114 b. The paper sets T to 0
/// where g' = 0; this uses the limit of T instead. Gray gets tint and saturation 0.
UnitColor tslOf(const UnitColor& rgb);

/// The channels of a color in a space. For all spaces but kYCbCr the color is first clamped to the nearest
/// RGB color.
UnitColor channelsIn(ColorSpace space, const ColorValue& yCbCr);

/// The position of a color for display, in a cube of side 1 around the origin, z up. Cubes: (Cb, Cr, Y) and
/// (R, G, B) along x, y, z. Cylinders: radius 0.5 around the z axis; the angle counts from x to y.
Eigen::Vector3f placeIn(ColorSpace space, const ColorValue& yCbCr);

inline ColorValue valueOf(robotlink::YCbCr color) {
  return {static_cast<float>(color.y), static_cast<float>(color.cb), static_cast<float>(color.cr)};
}

}  // namespace colortool
