// SPDX-License-Identifier: GPL-3.0-or-later
// How good tables of few strokes are in an image that none of the strokes is from: each labeled image of a
// real robot, or of a made game, is left out in turn.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <random>

#include "colortool/image/ClassPresets.h"
#include "colortool/scoring/Evaluation.h"
#include "colortool/training/TableTrainer.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/game/Data.h"

namespace {

using namespace colortool;
namespace fs = std::filesystem;

constexpr int kFrameWidth = 320, kHeight = 240;
constexpr std::array<std::uint8_t, 4> kThings = {1, 2, 3, 7};  // orange, yellow, blue, red

struct Frame {
  std::string name;
  ColorImage image{kFrameWidth, kHeight};
  std::vector<std::uint8_t> labels;
  std::array<std::vector<ImagePoint>, 9> places;  ///< by class, where a stroke lies inside of it
};

/// Pixels of (Y1, Cb, Cr).
Frame readFrame(const fs::path& data, const std::string& stem) {
  Frame frame;
  frame.name = stem;
  const std::string bytes = robotlink::readFile(data / "yuyv" / (stem + ".yuyv")).value();
  for (std::size_t i = 0; i < frame.image.pixels.size(); ++i) {
    const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(bytes.at(4 * i + at)); };
    frame.image.pixels[i] = {byte(2), byte(1), byte(3)};
  }
  const std::string png = robotlink::readFile(data / "labels" / (stem + ".png")).value();
  frame.labels =
      logplayer::decodePng({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()}).value().data;
  const auto label = [&](int x, int y) {
    return frame.labels[static_cast<std::size_t>(y * kFrameWidth + x)];
  };
  for (int y = 3; y < kHeight - 3; ++y) {
    for (int x = 3; x < kFrameWidth - 3; ++x) {
      bool inside = label(x, y) < frame.places.size();
      for (int off = -3; off <= 3 && inside; ++off) {
        const int across = std::abs(off) == 3 ? 0 : std::abs(off) == 2 ? 2 : off == 0 ? 3 : 2;
        inside = label(x - across, y + off) == label(x, y) && label(x + across, y + off) == label(x, y);
      }
      if (inside) frame.places[label(x, y)].push_back({1.0 * x, 1.0 * y});
    }
  }
  return frame;
}

/// Strokes of 29 pixels at random places of all images but `left`. Classes that only that one has are not
/// learned.
Samples strokes(const std::vector<Frame>& frames, const Frame& left, int perClass, unsigned seed) {
  Samples samples;
  samples.classes = findClassPreset("bhuman2009")->classes();
  std::mt19937 random(seed);
  for (std::uint8_t colorClass = 0; colorClass < 9; ++colorClass) {
    std::vector<std::pair<const Frame*, ImagePoint>> places;
    for (const Frame& frame : frames) {
      if (&frame == &left) continue;
      for (const ImagePoint place : frame.places[colorClass]) places.emplace_back(&frame, place);
    }
    for (int i = 0; i < perClass && !places.empty(); ++i) {
      const auto& [frame, place] = places[random() % places.size()];
      addStroke(samples, {0, frame->name, "nao", "", 0, 0}, frame->image,
                brushArea(kFrameWidth, kHeight, {&place, 1}, 3), {colorClass, false, 1, "brush"});
    }
  }
  return samples;
}

/// Of what can be known of the images that were left out: orange, white, green, and the background.
struct Score {
  double recall = 0, falseColor = 0;
};

Score score(const std::vector<Frame>& frames, int perClass, unsigned seeds) {
  Score sum;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    Evaluation all(9);
    for (const Frame& left : frames) {
      TableTrainer trainer;
      const Samples samples = strokes(frames, left, perClass, seed);
      Evaluation one(9);
      one.add(trainer.train(samples), left.image, left.labels);
      for (int label = 0; label < 9; ++label) {
        const bool learned =
            std::ranges::any_of(samples.strokes, [&](const StrokePtr& s) { return s->colorClass == label; });
        // Images of different sizes of a thing count the same.
        for (int found = 0; found < 9 && learned; ++found) {
          if (one.labeled(label) != 0)
            all.add(static_cast<std::uint8_t>(label), static_cast<std::uint8_t>(found),
                    1'000'000 * one.count(label, found) / one.labeled(label));
        }
      }
    }
    sum.recall += all.meanRecall() / seeds;
    sum.falseColor += all.falseColor(kThings) / seeds;
  }
  return sum;
}

/// The parameter is the source of the images.
class LeaveOneFrameOut : public testing::TestWithParam<std::string> {};

TEST_P(LeaveOneFrameOut, fewStrokesKnowTheColorsOfAnImageThatNoneIsFromAndMoreStrokesKnowThemBetter) {
  const fs::path data = game::dataOf(GetParam()) / "colour/bhuman2009";
  if (!fs::exists(data)) GTEST_SKIP() << "the real images are not in " << data;
  std::vector<Frame> frames;
  for (const std::string& stem : game::labeledStems(game::dataOf(GetParam())))
    frames.push_back(readFrame(data, stem));
  const unsigned seeds = GetParam() == "real" ? 5 : 1;
  const Score one = score(frames, 1, seeds), three = score(frames, 3, seeds), ten = score(frames, 10, seeds);
  for (const auto& [name, each] : {std::pair("1", one), std::pair("3", three), std::pair("10", ten)})
    std::printf("%2s strokes a class: mean recall %.2f %%, false colors %.3f %%\n", name, 100 * each.recall,
                100 * each.falseColor);
  EXPECT_GT(one.recall, 0.98);
  EXPECT_GT(three.recall, 0.985);
  EXPECT_GT(ten.recall, 0.985);
  EXPECT_GE(three.recall, one.recall - 0.001);
  // The ball in image 000 has 311 pixels, so that one of them is a tenth of a percent.
  EXPECT_GE(ten.recall, three.recall - 0.005);
  for (const Score& each : {one, three, ten}) EXPECT_LT(each.falseColor, 0.001);
}

INSTANTIATE_TEST_SUITE_P(Data, LeaveOneFrameOut, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

}  // namespace
