// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colortool/image/ColorClasses.h"
#include "colortool/table/ColorTable.h"
#include "robotlink/base/Image.h"

namespace colortool {

/// Thresholds and weights of the kinds of suspicious pixels. Areas are shares of the image, so that they
/// apply to images of any size.
struct SuspicionOptions {
  /// Smaller connected areas are specks. 1/6400 of 320 x 240 pixels is 12 pixels: the size of a ball at six
  /// meters in the images of 2002 as well as in those of 2009.
  double speckArea = 1.0 / 6400;
  /// Smaller areas that a single other colored class encloses are suspicious; a ball in front of a goal is
  /// larger.
  double enclosedArea = 1.0 / 800;
  /// Larger areas of a colored class cover more than a thing does, unless it is right in front of the camera.
  double vastArea = 0.4;
  /// Pixels in cells with a smaller margin are ambiguous (TableTrainer::margins(): 255 is certain).
  std::uint8_t leastMargin = 64;
  /// Weights of a pixel of each kind in Suspicion::score.
  double speckWeight = 1;
  double enclosedWeight = 0.5;
  /// Small, since the edges of every thing have mixed colors.
  double ambiguousWeight = 0.1;
  /// Smaller still: there are many such pixels, and they may be right.
  double vastWeight = 0.02;
  bool operator==(const SuspicionOptions&) const = default;
};

/// Numbers of pixels of an image that a table may have classified wrongly. Each pixel counts once, for the
/// first applicable kind in the order speck, enclosed, ambiguous, vast.
struct SuspiciousPixels {
  std::uint32_t specks = 0;
  std::uint32_t enclosed = 0;
  std::uint32_t ambiguous = 0;
  std::uint32_t vast = 0;
  std::uint32_t all() const { return specks + enclosed + ambiguous + vast; }
  bool operator==(const SuspiciousPixels&) const = default;
};
/// The result of SuspicionMeter::measure() for one image.
struct Suspicion {
  SuspiciousPixels pixels;
  /// Indexed by class number, including 0.
  std::vector<SuspiciousPixels> byClass;
  /// Pixels times their weights; frames are sorted by it.
  double score = 0;
};

/// Finds pixels of an image that are probably misclassified, without any labels: colors where no thing of
/// that color can be. The image alone shows only some of them, and only for classes of things, not for those
/// of ground and walls, which are everywhere (see isThingColor()):
/// - specks: things are connected and, within useful distance, not tiny; the false colors of a table that
///   generalizes too far are many small areas, mostly along edges, where colors mix;
/// - enclosed areas: a patch of one color inside a thing of another color is usually a misclassified part of
///   that thing; carpet and lines may enclose things, so only colored classes count;
/// - ambiguous pixels: another class, or none, had nearly as many votes, so that the next stroke may change
///   them;
/// - vast areas: a table that confuses the wall with a thing does so all over the image.
/// A wrong area that is neither small nor vast, and whose colors are certain, looks like a thing and is not
/// found.
///
/// Reuses its memory from image to image; one thread at a time. Takes about 1.5 ns per pixel.
class SuspicionMeter {
 public:
  /// `margins`: by ColorTable::cellOf(); empty: no pixel is ambiguous. `things`: for each class whether it is
  /// examined.
  SuspicionMeter(const ColorTable& table, std::span<const std::uint8_t> margins, std::vector<bool> things,
                 const SuspicionOptions& options = {});

  /// Classifies and examines an image.
  Suspicion measure(const robotlink::ImageView& image);
  /// The class of each pixel of the image that was measured last (kMono8). Valid until the next call.
  const robotlink::Image& classes() const { return classes_; }

 private:
  /// Consecutive pixels of one class in a row, `end` exclusive.
  struct Run {
    int y, begin, end;
    std::uint8_t colorClass;
    /// Union-find: index of a run of the same area, its own for the first run of the area.
    std::uint32_t parent;
  };
  /// A connected area of a thing's class.
  struct Area {
    std::uint32_t pixels = 0;
    /// The class that it touches; kNone before the first.
    std::uint8_t around = ColorClasses::kNone;
    /// Whether it touches the edge of the image, several classes, or a class that is not that of a thing.
    bool open = false;
  };
  /// Collects the runs of things, and connects them.
  void findRuns();
  /// Joins the runs from `begin` on with those of the row above.
  void connect(std::size_t aboveBegin, std::size_t begin);
  /// The first run of an area; shortens the path to it.
  std::uint32_t root(std::uint32_t run);
  /// Counts the pixels of each area.
  void sumAreas();
  /// Determines what surrounds a run of an area that may be enclosed.
  void lookAround(const Run& run);
  /// Counts the ambiguous pixels of a run of an area that is no speck; `vast`: whether the area is vast.
  void countAmbiguous(const Run& run, bool vast, SuspiciousPixels& found) const;

  ColorTable table_;
  /// 1 in ambiguous cells, else 0.
  ColorTable ambiguousTable_;
  /// Indexed by all class numbers, 0 to 255.
  std::vector<bool> things_;
  std::size_t classCount_;
  SuspicionOptions options_;
  robotlink::Image classes_, ambiguous_;
  /// Runs of things only.
  std::vector<Run> runs_;
  /// Indexed by their first run.
  std::vector<Area> areas_;
};

/// Whether a display color is that of things rather than of ground, lines, walls and shadows: neither green,
/// nor white, gray or black.
bool isThingColor(robotlink::Rgb shown);
/// isThingColor() for all classes by number; false for class 0.
std::vector<bool> objectClasses(const ColorClasses& classes);

}  // namespace colortool
