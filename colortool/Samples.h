// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "colortool/ColorClasses.h"
#include "colortool/ColorCorrection.h"
#include "colortool/PixelArea.h"
#include "colortool/TrainingSettings.h"

namespace colortool {

/// An image that strokes were made in. Its pixels are not kept: strokes hold what they touched.
struct SampleImage {
  std::uint64_t id = 0;
  std::string name;      ///< as a person finds it again: "game.mcap nao/camera/image 12.340 s"
  std::string camera;    ///< whose colours are alike, a robot's name; corrections are per camera
  std::string lighting;  ///< a word of the user's for the light it was taken in; may be empty
  int width = 0;
  int height = 0;
  bool operator==(const SampleImage&) const = default;
};

/// A small picture of what a stroke touched, with some of its surroundings.
struct Thumbnail {
  static constexpr int kMaxSide = 32;
  int width = 0;
  int height = 0;
  std::vector<robotlink::Rgb> pixels;
  bool operator==(const Thumbnail&) const = default;
};

/// What a person said of some pixels of an image: that they are of a class, of none (background, the class
/// ColorClasses::kNone), or must not be of a class. Holds the pixels' colours, so that a table can be made of
/// it without the image. Never changed once it is part of samples.
struct Stroke {
  static constexpr double kMinWeight = 0.1, kMaxWeight = 10;

  std::uint64_t id = 0;     ///< unique in its samples; later strokes have larger ones
  std::uint64_t image = 0;  ///< SampleImage::id
  std::uint8_t colorClass = ColorClasses::kNone;
  bool mustNotBe = false;
  double weight = 1;
  std::string tool;  ///< how it was made: "brush"; for lists
  PixelArea area;
  std::vector<robotlink::YCbCr> colors;  ///< of the area's pixels, run by run
  Thumbnail thumbnail;
  bool operator==(const Stroke&) const = default;
};
using StrokePtr = std::shared_ptr<const Stroke>;

/// How the colours of a camera are made those of the others.
struct CameraCorrection {
  std::string camera;
  ColorCorrection correction;
  bool operator==(const CameraCorrection&) const = default;
};

/// Everything that a colour table is made of: what the user keeps. The table itself is only a product. A
/// plain value; copies share their strokes. Strokes are sorted by id, and each one's image is there.
struct Samples {
  ColorClasses classes;
  TrainingSettings settings;
  std::vector<CameraCorrection> corrections;
  std::vector<SampleImage> images;
  std::vector<StrokePtr> strokes;

  const SampleImage* image(std::uint64_t id) const;
  /// What the settings switch on of the correction of this camera's images.
  ColorCorrection correctionOf(const std::string& camera) const;
  bool operator==(const Samples&) const;
};

/// What of a stroke the tools decide.
struct StrokeMeaning {
  std::uint8_t colorClass = ColorClasses::kNone;
  bool mustNotBe = false;
  double weight = 1;
  std::string tool = {};
};
/// Adds what `area` touches of `image`; which image it is, is told by `where` (its id does not count: an
/// image of the same name, camera and size is the same). Without pixels nothing is added. Returns the new
/// stroke's id, 0 if there is none.
std::uint64_t addStroke(Samples& samples, const SampleImage& where, const ColorImage& image,
                        const PixelArea& area, const StrokeMeaning& meaning);
/// Takes an area away from all strokes of an image; strokes without a pixel left go. Whether anything
/// changed.
bool erase(Samples& samples, const SampleImage& where, const PixelArea& area);
/// Takes an area away from one stroke, by id; without a pixel left it goes.
void erasePart(Samples& samples, std::uint64_t id, const PixelArea& area);
/// Removes strokes by id, and images that no stroke needs any more.
void removeStrokes(Samples& samples, const std::vector<std::uint64_t>& ids);
/// Changes what strokes say, by id: class, "must not be", weight; tool stays.
void restate(Samples& samples, const std::vector<std::uint64_t>& ids, const StrokeMeaning& meaning);
/// Other classes: `newNumbers[old]` is what a class becomes; kNone for classes but 0 removes their strokes.
void changeClasses(Samples& samples, ColorClasses classes, const std::vector<std::uint8_t>& newNumbers);
/// Adds what another one holds: classes by their names, images that are the same once, strokes that are not
/// yet there. Settings stay.
void merge(Samples& samples, const Samples& other);

}  // namespace colortool
