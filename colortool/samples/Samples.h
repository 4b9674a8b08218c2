// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "colortool/image/ColorClasses.h"
#include "colortool/image/ColorCorrection.h"
#include "colortool/image/PixelArea.h"
#include "colortool/votes/TrainingSettings.h"

namespace colortool {

/// An image in which strokes were drawn. Its pixels are not stored: each stroke holds the colors that it
/// covers.
struct SampleImage {
  /// Unique in its samples.
  std::uint64_t id = 0;
  /// A name by which the user finds the image again: "game.mcap nao/camera/image 12.340 s".
  std::string name;
  /// The robot's name. All images of a camera have the same color characteristics; corrections are per
  /// camera.
  std::string camera;
  /// The user's word for the light in which it was taken; may be empty.
  std::string lighting;
  int width = 0;
  int height = 0;
  bool operator==(const SampleImage&) const = default;
};

/// A small picture of what a stroke covers, with some of its surroundings.
struct Thumbnail {
  static constexpr int kMaxSide = 32;
  int width = 0;
  int height = 0;
  std::vector<robotlink::Rgb> pixels;
  bool operator==(const Thumbnail&) const = default;
};

/// A statement of the user about some pixels of an image: that they belong to a class, to none (the
/// background, ColorClasses::kNone), or that they must not belong to a class. It holds the pixels' colors, so
/// that a table can be trained without the image. Immutable once it is part of samples.
struct Stroke {
  static constexpr double kMinWeight = 0.1, kMaxWeight = 10;

  /// Unique in its samples; later strokes have larger ids.
  std::uint64_t id = 0;
  /// The SampleImage::id of its image.
  std::uint64_t image = 0;
  std::uint8_t colorClass = ColorClasses::kNone;
  /// Whether the pixels must not belong to colorClass; otherwise they do.
  bool mustNotBe = false;
  /// How much its pixels count in training.
  double weight = 1;
  /// The tool that made it, for lists: "brush".
  std::string tool;
  /// The covered pixels.
  PixelArea area;
  /// The colors of the area's pixels, run by run, without correction.
  std::vector<robotlink::YCbCr> colors;
  Thumbnail thumbnail;
  bool operator==(const Stroke&) const = default;
};
/// Strokes are shared by copies of Samples and by the undo history.
using StrokePtr = std::shared_ptr<const Stroke>;

/// The correction that maps the colors of one camera to those of the reference camera.
struct CameraCorrection {
  std::string camera;
  ColorCorrection correction;
  bool operator==(const CameraCorrection&) const = default;
};

/// Everything that a color table is trained from; this is what the user edits and saves, the table is only
/// derived from it. A plain value; copies share their strokes. Strokes are sorted by id, and the image of
/// each stroke exists.
struct Samples {
  ColorClasses classes;
  TrainingSettings settings;
  std::vector<CameraCorrection> corrections;
  std::vector<SampleImage> images;
  std::vector<StrokePtr> strokes;

  /// Returns null if there is none.
  const SampleImage* image(std::uint64_t id) const;
  /// The part of the correction of this camera that the settings enable; the identity if there is none.
  ColorCorrection correctionOf(const std::string& camera) const;
  /// Compares strokes by value.
  bool operator==(const Samples&) const;
};

/// The properties of a stroke that the user's tool determines, apart from its area.
struct StrokeMeaning {
  std::uint8_t colorClass = ColorClasses::kNone;
  bool mustNotBe = false;
  double weight = 1;
  std::string tool = {};
};
/// Adds a stroke that covers `area` of `image`. `where` identifies the image; its id is ignored: an image
/// with the same name, camera and size is the same. Returns the new stroke's id, or 0 if the area has no
/// pixel in the image.
std::uint64_t addStroke(Samples& samples, const SampleImage& where, const ColorImage& image,
                        const PixelArea& area, const StrokeMeaning& meaning);
/// Removes an area from all strokes of an image; strokes without pixels are removed. Returns whether anything
/// changed.
bool erase(Samples& samples, const SampleImage& where, const PixelArea& area);
/// Removes an area from one stroke; without pixels it is removed.
void erasePart(Samples& samples, std::uint64_t id, const PixelArea& area);
/// Removes strokes by id, together with images that no stroke uses any longer.
void removeStrokes(Samples& samples, const std::vector<std::uint64_t>& ids);
/// Changes class, "must not be" and weight of strokes by id; their tools stay.
void restate(Samples& samples, const std::vector<std::uint64_t>& ids, const StrokeMeaning& meaning);
/// Replaces the classes. `newNumbers[old]` is the new number of a class; kNone, for any class but 0, removes
/// its strokes.
void changeClasses(Samples& samples, ColorClasses classes, const std::vector<std::uint8_t>& newNumbers);
/// Adds the contents of other samples: classes by name, images unless they exist, strokes unless they exist.
/// Settings stay.
void merge(Samples& samples, const Samples& other);

}  // namespace colortool
