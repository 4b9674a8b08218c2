// SPDX-License-Identifier: GPL-3.0-or-later
// Colour tables scored exactly: the simulation tells the class of every pixel.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "app/core/SimulatedWorld.h"
#include "app/core/Workbench.h"
#include "colortool/ClassPresets.h"
#include "colortool/ColorImage.h"
#include "colortool/ColorVotes.h"
#include "colortool/Evaluation.h"
#include "colortool/PaletteTable.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Random.h"
#include "robotlink/base/Resources.h"
#include "robotlink/config/FieldDescription.h"
#include "simcore/Scene.h"
#include "tests/TestFolder.h"

using namespace app;
using colortool::ColorTable;
using robotlink::Pose2;

namespace {

struct LabelledImage {
  colortool::ColorImage image;
  robotlink::Image labels;
};

/// A lighting, with a lens.
struct Light {
  const char* name;
  simcore::Lighting lighting;
  simcore::Vignetting vignetting;
};

constexpr Light kUsual{"usual", {1, 0}, {}};
constexpr Light kDimAndWarm{"dim and warm", {0.75, 0.2}, {}};
constexpr Light kBrightAndCool{"bright and cool, with vignetting", {1.2, -0.2}, {0.35, 0.1}};

// Where the robot looks from: at ball, goals, beacons and both robots, nearby and from afar.
constexpr Pose2 kLearnedViews[] = {{-0.8, 0, 0},      {-0.3, 0, 0},     {1.3, 0.9, 0.55}, {-1.3, 0, 3.14},
                                   {0.35, -0.5, 0},   {0.35, 0.5, 0},   {0, -0.8, -1.57}, {-1.4, 0.8, 2.5},
                                   {0.9, -0.7, -0.6}, {1.0, 0.15, 0.1}, {-0.5, 0.4, -0.5}};
constexpr Pose2 kOtherViews[] = {{-1.2, 0.3, -0.1}, {-0.3, 0.1, -0.2}, {1.0, 0.6, 0.6},   {-0.9, -0.2, 3.0},
                                 {0.3, -0.65, 0.3}, {0.3, 0.65, -0.3}, {0.1, 0.75, 1.57}, {-1.2, -0.7, -2.5},
                                 {1.5, 0.2, -0.1},  {0, 0, 2.9},       {-1.6, 0, 0}};

/// The field with a robot of each team more.
std::string sceneText() {
  std::string text = robotlink::readFile(Workbench::defaultOptions().scene).value();
  const auto robot = [](const char* name, const char* team, const char* pose) {
    return std::string("<include><uri>model://ers210</uri><name>") + name + "</name><pose>" + pose +
           "</pose><robotcontrol:team>" + team + "</robotcontrol:team></include>\n";
  };
  return text.insert(text.rfind("</world>"), robot("red2", "red", "0.8 0.5 0.1138 0 0 1.2") +
                                                 robot("blue1", "blue", "0.8 -0.5 0.1138 0 0 -1.2"));
}

class SimulatedCalibration : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const TestFolder folder;
    std::ofstream(folder / "game.sdf") << sceneText();
    auto loaded = simcore::Scene::load(folder / "game.sdf");
    ASSERT_TRUE(loaded) << robotlink::describe(loaded.error());
    scene_ = *loaded;
  }
  static void TearDownTestSuite() { scene_.reset(); }

  /// What the first robot's camera sees from some places, and what that truly is.
  static std::vector<LabelledImage> see(const Light& light, std::span<const Pose2> views) {
    SimulatedWorld::Options options;
    options.lighting = light.lighting;
    options.vignetting = light.vignetting;
    auto world = SimulatedWorld::create(scene_, options);
    EXPECT_TRUE(world) << world.error().describe();
    std::vector<LabelledImage> images;
    for (const Pose2& view : views) {
      const auto placed = (*world)->simulation().placeModel("red1", view);
      EXPECT_TRUE(placed) << placed.error().describe();
      (*world)->advance();
      const auto image = colortool::ColorImage::of((*world)->render(0).view());
      images.push_back({image, (*world)->trueClasses()});
    }
    return images;
  }

  static colortool::ColorClasses classes() { return colortool::findClassPreset("2002")->classes(); }

  static std::shared_ptr<const simcore::Scene> scene_;
};

std::shared_ptr<const simcore::Scene> SimulatedCalibration::scene_;

/// Where a disc of radius 3 lies in an area of one class.
struct Place {
  const LabelledImage* image;
  int x, y;
};
constexpr int kRadius = 3;

void visitStroke(const Place& at, const std::function<void(int, int)>& use) {
  colortool::visitDisc(at.image->image.width, at.image->image.height, at.x + 0.5, at.y + 0.5, kRadius, use);
}

/// By class.
std::vector<std::vector<Place>> placesIn(const std::vector<LabelledImage>& images, int classes) {
  std::vector<std::vector<Place>> places(static_cast<std::size_t>(classes));
  for (const LabelledImage& one : images) {
    for (int y = kRadius; y < one.image.height - kRadius; ++y) {
      for (int x = kRadius; x < one.image.width - kRadius; ++x) {
        const std::uint8_t label = one.labels.row(y)[x];
        bool fits = label < classes && one.labels.row(y)[x - kRadius] == label &&
                    one.labels.row(y)[x + kRadius] == label;
        if (!fits) continue;
        visitStroke({&one, x, y}, [&](int px, int py) { fits = fits && one.labels.row(py)[px] == label; });
        if (fits) places[label].push_back({&one, x, y});
      }
    }
  }
  return places;
}

/// Ten strokes for each class and the background, at places that a seed chooses.
ColorTable learnt(const std::vector<std::vector<Place>>& places, std::uint64_t seed) {
  colortool::ColorVotes votes(static_cast<int>(places.size()));
  for (std::size_t c = 0; c < places.size(); ++c) {
    const auto colorClass = static_cast<std::uint8_t>(c);
    EXPECT_FALSE(places[c].empty()) << "class " << c << " is nowhere large enough for a stroke";
    robotlink::Random random(seed, colorClass);
    for (int stroke = 0; stroke < 10 && !places[c].empty(); ++stroke) {
      const Place& at = places[c][random.bits() % places[c].size()];
      visitStroke(at, [&](int x, int y) {
        votes.add(ColorTable::cellOf(at.image->image.at(x, y)), colorClass, colortool::ColorVotes::kUnit);
      });
    }
  }
  return votes.update();
}

/// Of several seeds of strokes.
struct Scores {
  double mean = 0, worst = 1;  ///< mean recall of the classes
  double mostFalse = 0;        ///< share of the background that was taken for a colour
};

Scores scoresOf(const std::vector<ColorTable>& tables, const std::vector<LabelledImage>& images,
                int classes) {
  // All but green, white and black, which carpet, walls and the robots' bodies may well be taken for.
  constexpr std::uint8_t kColors[] = {1, 2, 3, 4, 7, 8};
  Scores scores;
  for (const ColorTable& table : tables) {
    colortool::Evaluation evaluation(classes);
    for (const LabelledImage& one : images) evaluation.add(table, one.image, one.labels.data);
    scores.mean += evaluation.meanRecall() / static_cast<double>(tables.size());
    scores.worst = std::min(scores.worst, evaluation.meanRecall());
    scores.mostFalse = std::max(scores.mostFalse, evaluation.falseColor(kColors));
  }
  return scores;
}

std::vector<ColorTable> learntWithSeeds(const std::vector<LabelledImage>& images, int classes) {
  const auto places = placesIn(images, classes);
  std::vector<ColorTable> tables;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) tables.push_back(learnt(places, seed));
  return tables;
}

/// The table that can be made of the field's colours alone, without an image.
ColorTable paletteTable(const colortool::ColorClasses& classes) {
  std::vector<colortool::NamedColor> palette;
  for (int i = 1; i < classes.size(); ++i) palette.push_back({classes.name(i), classes.shownColor(i)});
  const auto field = robotlink::FieldDescription::load(robotlink::resource("fields/2002.yaml"));
  EXPECT_TRUE(field);
  for (const char* name : {"carpet", "silver"}) palette.push_back({name, *field->color(name)});
  return colortool::paletteTable(palette, classes);
}

std::string described(const Light& light, const Scores& scores) {
  return fmt::format("{}: mean recall {:.4f}, worst {:.4f}, false colour {:.5f}", light.name, scores.mean,
                     scores.worst, scores.mostFalse);
}

}  // namespace

TEST_F(SimulatedCalibration, aTableLearntInOneLightingIsScoredInThree) {
  const colortool::ColorClasses all = classes();
  const std::vector<ColorTable> tables = learntWithSeeds(see(kUsual, kLearnedViews), all.size());
  const std::vector<ColorTable> palette = {paletteTable(all)};
  // Measured with five seeds: mean recall 0.995, 0.896 and 0.977, the worst 0.993, 0.854 and 0.972; false
  // colour at most 0, 0 and 0.025 (the grey hall, which is bluish then). The palette's table has a mean
  // recall of 0.973, 0.931 and 0.888.
  const std::tuple<Light, double, double, double> expected[] = {
      {kUsual, 0.985, 0.97, 0.001}, {kDimAndWarm, 0.84, 0.80, 0.001}, {kBrightAndCool, 0.96, 0.94, 0.05}};
  std::vector<Scores> ours, ofPalette;
  for (const auto& [light, mean, worst, mostFalse] : expected) {
    const std::vector<LabelledImage> images = see(light, kOtherViews);
    ours.push_back(scoresOf(tables, images, all.size()));
    ofPalette.push_back(scoresOf(palette, images, all.size()));
    SCOPED_TRACE(described(light, ours.back()) + "\nthe palette's table " +
                 described(light, ofPalette.back()));
    EXPECT_GT(ours.back().mean, mean);
    EXPECT_GT(ours.back().worst, worst);
    EXPECT_LT(ours.back().mostFalse, mostFalse);
  }
  EXPECT_GT(ours[0].mean, ours[1].mean) << "it knows its own lighting best";
  EXPECT_GT(ours[0].mean, ours[2].mean);
  EXPECT_GT(ours[0].mean, ofPalette[0].mean) << "and is better than one that knows but the colours";
  EXPECT_GT(ours[2].mean, ofPalette[2].mean);
}

TEST_F(SimulatedCalibration, aTableLearntInThreeLightingsStandsAllOfThem) {
  const colortool::ColorClasses all = classes();
  std::vector<LabelledImage> images;
  for (const Light& light : {kUsual, kDimAndWarm, kBrightAndCool}) {
    for (LabelledImage& image : see(light, kLearnedViews)) images.push_back(std::move(image));
  }
  const std::vector<ColorTable> tables = learntWithSeeds(images, all.size());
  for (const Light& light : {kUsual, kDimAndWarm, kBrightAndCool}) {
    const Scores scores = scoresOf(tables, see(light, kOtherViews), all.size());
    SCOPED_TRACE(described(light, scores));
    // Measured: mean recall 0.995, 0.974 and 0.991; false colour at most 0, 0 and 0.005.
    EXPECT_GT(scores.mean, 0.95);
    EXPECT_LT(scores.mostFalse, 0.02);
  }
}
