// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "robotlink/base/Image.h"

namespace colortool {

/// Ways to tell a colour by three numbers. What a table knows is kYCbCr; the others are for people to look
/// at.
enum class ColorSpace : std::uint8_t { kYCbCr, kRgb, kHsi, kTsl };
inline constexpr std::array kColorSpaces = {ColorSpace::kYCbCr, ColorSpace::kRgb, ColorSpace::kHsi,
                                            ColorSpace::kTsl};

/// "YCbCr", "HSI".
const char* nameOf(ColorSpace space);
/// Returns the names of the three channels, in the order of the space's name.
std::array<const char*, 3> channelNames(ColorSpace space);
/// HSI and TSL: the first channel is an angle, the second the distance from the grey axis, the third the
/// height in a cylinder. The others fill a cube.
constexpr bool isCylinder(ColorSpace space) {
  return space == ColorSpace::kHsi || space == ColorSpace::kTsl;
}

/// Any colour, also one between those that pixels have: channels from 0 to 255.
using ColorValue = Eigen::Vector3f;
/// The same, each channel from 0 to 1; hue and tint are fractions of a turn, less than 1.
using UnitColor = Eigen::Vector3f;

/// Full-range BT.601 (JFIF 1.02), without rounding. Not clamped: YCbCr has colours that no RGB is of.
ColorValue rgbOf(const ColorValue& yCbCr);
/// Whether there is an RGB colour of it, or one that is off by no more than `tolerance` in each channel.
bool hasRgb(const ColorValue& yCbCr, float tolerance = 0);

/// Gonzalez and Woods, Digital Image Processing, 3rd edition, 6.2.3: I = (r + g + b) / 3, S = 1 - min / I, H
/// the angle from red around the grey axis. Grey has hue 0, black saturation 0.
UnitColor hsiOf(const UnitColor& rgb);
/// Terrillon, David and Akamatsu, Automatic detection of human faces in natural scene images by use of a skin
/// color model, 1998: of r' = r / (r + g + b) - 1/3 and g' likewise, T = arctan(r' / g') / 2 pi + 1/4 (+ 1/2
/// where g' < 0), S = sqrt(9/5 (r'^2 + g'^2)), L = 0.299 r + 0.587 g + 0.114 b. Where the paper sets T to 0
/// for all of g' = 0, this has the limit of T instead. Grey has tint and saturation 0.
UnitColor tslOf(const UnitColor& rgb);

/// The channels of a colour in a space. All but kYCbCr take the nearest colour that RGB has.
UnitColor channelsIn(ColorSpace space, const ColorValue& yCbCr);

/// Where a colour is seen, in a cube of side 1 around the origin, z up. Cubes: (Cb, Cr, Y) and (R, G, B)
/// along x, y, z. Cylinders: radius 0.5 around z; the angle counts from x to y.
Eigen::Vector3f placeIn(ColorSpace space, const ColorValue& yCbCr);

inline ColorValue valueOf(robotlink::YCbCr color) {
  return {static_cast<float>(color.y), static_cast<float>(color.cb), static_cast<float>(color.cr)};
}

}  // namespace colortool
