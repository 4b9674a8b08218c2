// SPDX-License-Identifier: GPL-3.0-or-later
// How good tables of few strokes are in an image that none of the strokes is from: each labeled image of a
// real robot, or of a made game, is left out in turn. The protocol is described in colortool/QUALITY.md.
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

constexpr int kFrameWidth = 320, kFrameHeight = 240;
/// Mean recalls of repetitions with strokes at other places differ by so much.
constexpr double kNoise = 0.002;
constexpr std::array<std::uint8_t, 4> kThings = {1, 2, 3, 7};  // orange, yellow, blue, red

struct Frame {
  std::string name;
  ColorImage image{kFrameWidth, kFrameHeight};
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
  for (int y = 3; y < kFrameHeight - 3; ++y) {
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

/// What becomes of classes that only the image has that is left out.
enum class Protocol : std::uint8_t {
  /// They are neither learned nor tested.
  kStrict,
  /// They are learned from every other block of the image, and tested in the blocks between.
  kBlocks
};
/// Side of these blocks; they are like the fields of a chessboard.
constexpr int kBlock = 24;
int blockColor(int x, int y) {
  return (x / kBlock + y / kBlock) % 2;
}

/// The image that is left out of the strokes.
struct Fold {
  const std::vector<Frame>& frames;
  const Frame& left;
  Protocol protocol;
  /// The blocks that are learned from, of classes that no other image has.
  int learnedBlocks;

  bool isOnlyHere(std::uint8_t colorClass) const {
    return std::ranges::none_of(
        frames, [&](const Frame& frame) { return &frame != &left && !frame.places[colorClass].empty(); });
  }
  bool isLearned(ImagePoint place) const {
    const int x = static_cast<int>(place.x), y = static_cast<int>(place.y);
    for (const auto& [atX, atY] : {std::pair(x - 3, y), {x + 3, y}, {x, y - 3}, {x, y + 3}}) {
      if (blockColor(atX, atY) != learnedBlocks) return false;
    }
    return true;
  }
};

/// Strokes of 29 pixels at random places of all images but the one that is left out.
Samples strokes(const Fold& fold, int perClass, unsigned seed) {
  Samples samples;
  samples.classes = findClassPreset("bhuman2009")->classes();
  std::mt19937 random(seed);
  for (std::uint8_t colorClass = 0; colorClass < 9; ++colorClass) {
    std::vector<std::pair<const Frame*, ImagePoint>> places;
    for (const Frame& frame : fold.frames) {
      if (&frame == &fold.left) continue;
      for (const ImagePoint place : frame.places[colorClass]) places.emplace_back(&frame, place);
    }
    if (colorClass != 0 && fold.protocol == Protocol::kBlocks && fold.isOnlyHere(colorClass)) {
      for (const ImagePoint place : fold.left.places[colorClass]) {
        if (fold.isLearned(place)) places.emplace_back(&fold.left, place);
      }
    }
    for (int i = 0; i < perClass && !places.empty(); ++i) {
      const auto& [frame, place] = places[random() % places.size()];
      addStroke(samples, {0, frame->name, "nao", "", 0, 0}, frame->image,
                brushArea(kFrameWidth, kFrameHeight, {&place, 1}, 3), {colorClass, false, 1, "brush"});
    }
  }
  return samples;
}

/// The labels that the table of a fold is tested with.
std::vector<std::uint8_t> tested(const Fold& fold, const Samples& samples) {
  std::vector<std::uint8_t> labels = fold.left.labels;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::uint8_t label = labels[i];
    const int x = static_cast<int>(i) % kFrameWidth, y = static_cast<int>(i) / kFrameWidth;
    const bool learned =
        std::ranges::any_of(samples.strokes, [&](const StrokePtr& s) { return s->colorClass == label; });
    if (!learned || (fold.isOnlyHere(label) && blockColor(x, y) == fold.learnedBlocks))
      labels[i] = Evaluation::kIgnored;
  }
  return labels;
}

/// Adds the result of a fold. Images of different sizes of a thing count the same.
void addFold(const Fold& fold, int perClass, unsigned seed, Evaluation& all) {
  TableTrainer trainer;
  const Samples samples = strokes(fold, perClass, seed);
  Evaluation one(9);
  one.add(trainer.train(samples), fold.left.image, tested(fold, samples));
  for (int label = 0; label < 9; ++label) {
    for (int found = 0; found < 9 && one.labeled(label) != 0; ++found)
      all.add(static_cast<std::uint8_t>(label), static_cast<std::uint8_t>(found),
              1'000'000 * one.count(label, found) / one.labeled(label));
  }
}

struct Score {
  double recall = 0, falseColor = 0;
  std::array<double, 9> ofClass{};
};

Score score(const std::vector<Frame>& frames, Protocol protocol, int perClass, unsigned seeds) {
  Score sum;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    Evaluation all(9);
    for (const Frame& left : frames) {
      for (int blocks = 0; blocks < (protocol == Protocol::kBlocks ? 2 : 1); ++blocks)
        addFold({frames, left, protocol, blocks}, perClass, seed, all);
    }
    sum.recall += all.meanRecall() / seeds;
    sum.falseColor += all.falseColor(kThings) / seeds;
    for (std::size_t i = 0; i < 9; ++i) sum.ofClass[i] += all.recall(static_cast<int>(i)) / seeds;
  }
  return sum;
}

/// For 1, 3 and 10 strokes a class.
std::array<Score, 3> scores(const std::string& source, Protocol protocol, unsigned seeds) {
  const fs::path data = game::dataOf(source) / "colour/bhuman2009";
  std::vector<Frame> frames;
  for (const std::string& stem : game::labeledStems(game::dataOf(source)))
    frames.push_back(readFrame(data, stem));
  std::array<Score, 3> result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const int perClass = std::array{1, 3, 10}[i];
    result[i] = score(frames, protocol, perClass, seeds);
    std::printf("%2d strokes a class: mean recall %.2f %%, false colors %.3f %%; recall:", perClass,
                100 * result[i].recall, 100 * result[i].falseColor);
    for (std::uint8_t colorClass = 1; colorClass < 9; ++colorClass) {
      if (result[i].ofClass[colorClass] == 0) continue;
      std::printf(" %s %.1f", findClassPreset("bhuman2009")->classes().name(colorClass).c_str(),
                  100 * result[i].ofClass[colorClass]);
    }
    std::printf("\n");
  }
  return result;
}

void expectThatMoreStrokesAreNotWorse(const std::array<Score, 3>& of) {
  EXPECT_GE(of[1].recall, of[0].recall - kNoise);
  EXPECT_GE(of[2].recall, of[1].recall - kNoise);
}

void expectGoodTables(const std::string& source, unsigned seeds) {
  // Measured with 20 seeds: 99.21, 99.41 and 99.42 %; false colors 0.006, 0.005 and 0.007 %.
  const auto strict = scores(source, Protocol::kStrict, seeds);
  EXPECT_GT(strict[0].recall, 0.988);
  EXPECT_GT(strict[1].recall, 0.991);
  EXPECT_GT(strict[2].recall, 0.992);
  for (const Score& each : strict) EXPECT_LT(each.falseColor, 0.0002);
  expectThatMoreStrokesAreNotWorse(strict);

  // Blue and red are in one image each. Measured with 20 seeds: 94.98, 95.89 and 96.12 %; false colors 0.079,
  // 0.053 and 0.056 %. A table made of the labels themselves has 97.9 % with 0.1 % false colors: a sixth of
  // the blue goal's pixels are at its edges, and as gray as the blinds on the wall.
  const auto blocks = scores(source, Protocol::kBlocks, seeds);
  EXPECT_GT(blocks[0].recall, 0.945);
  EXPECT_GT(blocks[1].recall, 0.955);
  EXPECT_GT(blocks[2].recall, 0.958);
  for (const Score& each : blocks) EXPECT_LT(each.falseColor, 0.001);
  expectThatMoreStrokesAreNotWorse(blocks);
}

/// The parameter is the source of the images.
class LeaveOneFrameOut : public testing::TestWithParam<std::string> {};

TEST_P(LeaveOneFrameOut, fewStrokesKnowTheColorsOfAnImageThatNoneIsFromAndMoreStrokesKnowThemBetter) {
  if (!fs::exists(game::dataOf(GetParam()) / "colour/bhuman2009"))
    GTEST_SKIP() << "the real images are not in " << game::dataOf(GetParam());
  expectGoodTables(GetParam(), GetParam() == "real" ? 3 : 1);
}

/// Measures on real images if they are there, otherwise on the made game.
TEST(SlowLeaveOneFrameOut, wherever20TimesTheStrokesAre) {
  const bool real = fs::exists(game::dataOf("real") / "colour/bhuman2009");
  expectGoodTables(real ? "real" : "made", 20);
}

INSTANTIATE_TEST_SUITE_P(Data, LeaveOneFrameOut, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

}  // namespace
