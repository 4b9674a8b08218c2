// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colortool/ColorClasses.h"
#include "colortool/ColorTable.h"
#include "robotlink/base/Image.h"

namespace colortool {

/// What makes a pixel suspicious, and how much each kind counts. Areas are shares of the image, so that they
/// mean the same in images of any size.
struct SuspicionOptions {
  /// Connected areas below this are specks. 1/6400 of 320 x 240 pixels are 12: so large a ball is six metres
  /// away, in the images of 2002 as in those of 2009.
  double speckArea = 1.0 / 6400;
  /// Areas below this that one other coloured class encloses are suspicious, too; a ball in front of a goal
  /// is larger.
  double enclosedArea = 1.0 / 800;
  /// Areas of a coloured class above this are more than a thing covers, unless it is right before the camera.
  double vastArea = 0.4;
  /// Pixels of cells with a margin below this are ambiguous (TableTrainer::margins(): 255 is sure).
  std::uint8_t leastMargin = 64;
  double speckWeight = 1;
  double enclosedWeight = 0.5;
  /// Small, since every thing's rim has mixed colours.
  double ambiguousWeight = 0.1;
  /// Smaller still: there are many of them, and what they show may be true.
  double vastWeight = 0.02;
  bool operator==(const SuspicionOptions&) const = default;
};

/// Pixels of an image that a table may well have sorted wrong. Each counts once, as the first that it is of
/// speck, enclosed, ambiguous, vast.
struct SuspiciousPixels {
  std::uint32_t specks = 0;
  std::uint32_t enclosed = 0;
  std::uint32_t ambiguous = 0;
  std::uint32_t vast = 0;
  std::uint32_t all() const { return specks + enclosed + ambiguous + vast; }
  bool operator==(const SuspiciousPixels&) const = default;
};
struct Suspicion {
  SuspiciousPixels pixels;
  std::vector<SuspiciousPixels> byClass;  ///< by number, 0 included
  double score = 0;                       ///< what frames are sorted by: pixels by their weights
};

/// Finds in an image what no label is needed for to see that it is probably wrong: colours where no thing of
/// that colour can be. What that is, the image itself shows only in part, and only for classes that things
/// have, not those of ground and walls, which are everywhere (see isThingColor()):
/// - specks: things are connected and, from where they matter, not tiny; false colours of a table that
///   reaches too far are many small areas, along edges above all, where colours mix;
/// - enclosed areas: a piece of one colour inside of another one's thing is mostly a part of that thing which
///   the table sorts wrong; carpet and lines may enclose things, so only coloured classes count;
/// - ambiguous pixels: where another class, or none, had nearly as many votes, the next stroke may turn it;
/// - vast areas: a table that takes the wall for a thing does so all over the image.
/// A wrong area that is neither small nor vast, and of sure colours, looks like a thing and is not found.
///
/// Keeps its memory from image to image; one thread at a time. About 1.5 ns a pixel.
class SuspicionMeter {
 public:
  /// `margins`: by ColorTable::cellOf; empty: no pixel is ambiguous. `things`: by class, which are looked at.
  SuspicionMeter(const ColorTable& table, std::span<const std::uint8_t> margins, std::vector<bool> things,
                 const SuspicionOptions& options = {});

  Suspicion measure(const robotlink::ImageView& image);
  /// The class of each pixel of the image that was measured last. Valid until the next call.
  const robotlink::Image& classes() const { return classes_; }

 private:
  struct Run {
    int y, begin, end;
    std::uint8_t colorClass;
    std::uint32_t parent;  ///< index of a run of the same area, its own for the area's first
  };
  struct Area {
    std::uint32_t pixels = 0;
    std::uint8_t around = ColorClasses::kNone;  ///< the class of what it touches
    bool open = false;  ///< it touches the image's edge, several classes, or one that things do not have
  };
  void findRuns();
  /// The runs from `begin` on with those of the row above.
  void connect(std::size_t aboveBegin, std::size_t begin);
  std::uint32_t root(std::uint32_t run);
  void sumAreas();
  /// Sees what is around a run of an area that may be enclosed.
  void lookAround(const Run& run);
  /// In a run of an area that is no speck; `vast`: it is.
  void countAmbiguous(const Run& run, bool vast, SuspiciousPixels& found) const;

  ColorTable table_;
  ColorTable ambiguousTable_;  ///< 1 in cells that are
  std::vector<bool> things_;   ///< by all numbers
  std::size_t classCount_;
  SuspicionOptions options_;
  robotlink::Image classes_, ambiguous_;
  std::vector<Run> runs_;    ///< of things
  std::vector<Area> areas_;  ///< by their first run
};

/// Whether things have this colour, rather than the ground, lines, walls and shadows: by how it is shown, it
/// is neither green, nor white, grey or black.
bool isThingColor(robotlink::Rgb shown);
/// The same of all classes, by number; class 0 is none.
std::vector<bool> thingClasses(const ColorClasses& classes);

}  // namespace colortool
