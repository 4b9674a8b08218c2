// SPDX-License-Identifier: GPL-3.0-or-later
// What is suspicious in whole images, of a real robot and of a made game, by good and by bad tables.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <random>

#include "colortool/image/ClassPresets.h"
#include "colortool/table/ColorTableFile.h"
#include "colortool/training/Suspicion.h"
#include "colortool/training/TableTrainer.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/game/Data.h"

namespace {

using namespace colortool;
namespace fs = std::filesystem;

constexpr int kSuspectWidth = 320, kSuspectHeight = 240;

/// Pixels of (Y1, Cb, Cr); as an image each is twice as wide.
robotlink::Image imageOf(const fs::path& data, const std::string& stem) {
  const std::string bytes = robotlink::readFile(data / "yuyv" / (stem + ".yuyv")).value();
  robotlink::Image image(2 * kSuspectWidth, kSuspectHeight, robotlink::PixelFormat::kYuyv);
  std::copy_n(bytes.begin(), std::min(bytes.size(), image.data.size()), image.data.begin());
  for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = image.data[i + 2];
  return image;
}

std::vector<std::string> stems(const fs::path& data) {
  std::vector<std::string> stems;
  for (const auto& entry : fs::directory_iterator(data / "yuyv")) stems.push_back(entry.path().stem());
  std::ranges::sort(stems);
  return stems;
}

robotlink::Image labelsOf(const fs::path& data, const std::string& stem) {
  const std::string bytes = robotlink::readFile(data / "labels" / (stem + ".png")).value();
  return logplayer::decodePng({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}).value();
}

constexpr std::uint8_t kAnyone = 255;  // a label

/// Whether all of a stroke of radius 3 is of one label.
bool isInside(const robotlink::Image& labels, int x, int y) {
  const std::uint8_t label = labels.row(y)[x];
  return labels.row(y - 3)[x] == label && labels.row(y + 3)[x] == label && labels.row(y)[x - 3] == label &&
         labels.row(y)[x + 3] == label;
}

/// A number of strokes a class in each labeled image at random places inside of the labels.
Samples strokes(const fs::path& data, const std::vector<std::string>& labeled, int perClass,
                const std::vector<std::uint8_t>& ofClasses, unsigned seed) {
  Samples samples;
  samples.classes = findClassPreset("bhuman2009")->classes();
  std::mt19937 random(seed);
  for (const std::string& stem : labeled) {
    const robotlink::Image labels = labelsOf(data, stem), image = imageOf(data, stem);
    const ColorImage colors = ColorImage::of(image.view());
    for (const std::uint8_t colorClass : ofClasses) {
      std::vector<ImagePoint> places;
      for (int y = 4; y < kSuspectHeight - 4; ++y) {
        for (int x = 4; x < kSuspectWidth - 4; ++x) {
          if (labels.row(y)[x] == colorClass && isInside(labels, x, y)) places.push_back({2.0 * x, 1.0 * y});
        }
      }
      for (int i = 0; i < perClass && !places.empty(); ++i) {
        const ImagePoint at[] = {places[random() % places.size()]};
        addStroke(samples, {0, stem, "nao", "", 2 * kSuspectWidth, kSuspectHeight}, colors,
                  brushArea(2 * kSuspectWidth, kSuspectHeight, at, 3), {colorClass});
      }
    }
  }
  return samples;
}
const std::vector<std::uint8_t> kEverything = {0, 1, 3, 4, 5, 7};

SuspicionMeter meterOf(const Samples& samples) {
  TableTrainer trainer;
  const ColorTable& table = trainer.train(samples);
  return {table, trainer.margins(), objectClasses(samples.classes)};
}

SuspicionMeter meterOfTheTeam(const fs::path& data) {
  const ColorTableFile file = ColorTableFile::load(data / "tables/default.c64").value();
  const ColorClasses classes = findClassPreset("bhuman2009")->classes();
  return {ColorTable::translated(file.singleClasses(), classNumbers(classes, classes)),
          {},
          objectClasses(classes)};
}

double scoreOfAll(const fs::path& data, SuspicionMeter meter) {
  double sum = 0;
  for (const std::string& stem : stems(data)) sum += meter.measure(imageOf(data, stem).view()).score;
  return sum;
}

/// Pixels of the image that was measured last that are of a thing's color, and labeled otherwise.
int falseColors(const SuspicionMeter& meter, const robotlink::Image& labels) {
  const std::vector<bool> things = objectClasses(findClassPreset("bhuman2009")->classes());
  int count = 0;
  for (int y = 0; y < kSuspectHeight; ++y) {
    for (int x = 0; x < kSuspectWidth; ++x) {
      const std::uint8_t label = labels.row(y)[x], found = meter.classes().row(y)[2 * x];
      count += label != kAnyone && label != found && things[found] ? 1 : 0;
    }
  }
  return count;
}

/// The parameter is the source of the images.
class SuspiciousViews : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!fs::exists(data())) GTEST_SKIP() << "the real images are not in " << data();
    labeled_ = game::labeledStems(game::dataOf(GetParam()));
  }
  fs::path data() const { return game::dataOf(GetParam()) / "colour/bhuman2009"; }
  std::vector<std::string> labeled_;
};

TEST_P(SuspiciousViews, aStrokeWithALargeRadiusMakesAWorseTableThanMany) {
  for (unsigned seed = 1; seed <= (GetParam() == "real" ? 3U : 1U); ++seed) {
    Samples bad = strokes(data(), labeled_, 1, {1}, seed);
    bad.strokes.resize(1);
    bad.settings.votes.radius = VoteOptions::kMaxRadius;
    const double worst = scoreOfAll(data(), meterOf(bad));
    for (const int perClass : {1, 3, 10}) {
      EXPECT_GT(worst,
                2 * scoreOfAll(data(), meterOf(strokes(data(), labeled_, perClass, kEverything, seed))))
          << seed;
    }
  }
}

/// In the made game tables of strokes make no mistakes: SuspicionTest and ColorFramesViewTest have images
/// with more of them and less.
TEST_P(SuspiciousViews, imagesWithFalseColorsComeFirst) {
  const bool real = GetParam() == "real";
  std::vector<SuspicionMeter> meters{meterOfTheTeam(data())};
  for (unsigned seed = 1; seed <= (real ? 2U : 1U); ++seed) {
    for (const int perClass : {1, 3, 10})
      meters.push_back(meterOf(strokes(data(), labeled_, perClass, kEverything, seed)));
  }
  int compared = 0;
  for (SuspicionMeter& meter : meters) {
    std::map<double, std::string> byScore;
    std::map<int, std::string> byFalseColors;
    for (const std::string& stem : labeled_) {
      byScore[meter.measure(imageOf(data(), stem).view()).score] = stem;
      byFalseColors[falseColors(meter, labelsOf(data(), stem))] = stem;
    }
    if (!real) {
      EXPECT_LT(byFalseColors.rbegin()->first, 50);
    }
    // Some good tables have next to none, of 76800 pixels.
    if (byFalseColors.rbegin()->first < 50) continue;
    EXPECT_EQ(byScore.rbegin()->second, byFalseColors.rbegin()->second);
    ++compared;
  }
  if (real) {
    EXPECT_GE(compared, 4);
  }
}

INSTANTIATE_TEST_SUITE_P(Data, SuspiciousViews, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

}  // namespace
