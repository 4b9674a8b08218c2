// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/samples/Samples.h"

#include <gtest/gtest.h>

#include "colortool/samples/SampleDocument.h"
#include "tests/colortool/SampleFixture.h"

using namespace colortool;

TEST(Samples, aStrokeHoldsTheColorsItTouched) {
  const Samples samples = quarterSamples();
  ASSERT_EQ(samples.strokes.size(), 4U);
  ASSERT_EQ(samples.images.size(), 1U);
  EXPECT_EQ(samples.images[0].width, 40);
  const Stroke& orange = *samples.strokes[0];
  ASSERT_EQ(orange.colors.size(), 29U);
  for (const auto& color : orange.colors) EXPECT_EQ(color, (robotlink::YCbCr{140, 60, 200}));
  EXPECT_LE(orange.thumbnail.width, Thumbnail::kMaxSide);
  EXPECT_EQ(orange.thumbnail.pixels.size(),
            static_cast<std::size_t>(orange.thumbnail.width * orange.thumbnail.height));
}

TEST(Samples, nothingIsAddedWithoutPixelsOrPastTheImage) {
  Samples samples = emptySamples();
  const ColorImage image = quarters();
  EXPECT_EQ(addStroke(samples, placeOf("a"), image, {}, {1}), 0U);
  EXPECT_EQ(addStroke(samples, placeOf("a"), image, {{0, 0, 41}}, {1}), 0U);
  EXPECT_EQ(samples, emptySamples());
}

TEST(Samples, theEraserTakesPixelsAndWholeStrokes) {
  Samples samples = quarterSamples();
  ASSERT_TRUE(erase(samples, placeOf("a"), {{7, 0, 9}}));
  EXPECT_EQ(samples.strokes[0]->colors.size(), 25U);
  EXPECT_EQ(pixelCount(samples.strokes[0]->area), 25U);
  EXPECT_FALSE(erase(samples, placeOf("b"), {{7, 0, 40}})) << "another image";
  ASSERT_TRUE(erase(samples, placeOf("a"), rectangleArea(40, 30, {0, 0}, {19, 14})));
  EXPECT_EQ(samples.strokes.size(), 3U);
  ASSERT_TRUE(erase(samples, placeOf("a"), rectangleArea(40, 30, {0, 0}, {39, 29})));
  EXPECT_TRUE(samples.images.empty()) << "no stroke needs it any more";
}

TEST(Samples, classesAreMovedWithTheirStrokesAndRemovedWithThem) {
  Samples samples = quarterSamples();
  changeClasses(samples, ColorClasses({{"white", {255, 255, 255}}, {"ball", {255, 128, 0}}}), {0, 2, 0, 1});
  ASSERT_EQ(samples.strokes.size(), 3U);
  EXPECT_EQ(samples.strokes[0]->colorClass, 2);
  EXPECT_EQ(samples.strokes[1]->colorClass, 1);
  EXPECT_EQ(samples.strokes[2]->colorClass, ColorClasses::kNone) << "background stays";
}

TEST(Samples, mergingTwiceIsMergingOnce) {
  Samples samples = quarterSamples(), other = emptySamples();
  other.classes = ColorClasses({{"pink", {250, 90, 160}}, {"orange", {255, 128, 0}}});
  const ColorImage image = quarters(40, 30, 20);
  addStroke(other, placeOf("b", "other"), image, disc(image, 8, 7), {2});
  addStroke(other, placeOf("b", "other"), image, disc(image, 30, 7), {1});
  merge(samples, other);
  ASSERT_EQ(samples.strokes.size(), 6U);
  EXPECT_EQ(samples.classes.size(), 5) << "pink came";
  EXPECT_EQ(samples.strokes[4]->colorClass, samples.classes.index("orange"));
  EXPECT_EQ(samples.strokes[5]->colorClass, samples.classes.index("pink"));
  EXPECT_EQ(samples.image(samples.strokes[5]->image)->camera, "other");
  const Samples once = samples;
  merge(samples, other);
  EXPECT_EQ(samples, once);
}

TEST(SampleDocument, undoAndRedoAreExact) {
  SampleDocument document(emptySamples());
  std::vector<Samples> states{document.samples()};
  const ColorImage image = quarters();
  const auto make = [&](const std::string& text, const auto& change) {
    Samples next = document.samples();
    change(next);
    EXPECT_TRUE(document.change(text, std::move(next)));
    states.push_back(document.samples());
  };
  for (int i = 0; i < 10; ++i)
    make("stroke", [&](Samples& s) {
      addStroke(s, placeOf(i % 2 == 0 ? "a" : "b"), image, disc(image, 4 + 3 * i, 7), {1});
    });
  make("erase", [&](Samples& s) { erase(s, placeOf("a"), rectangleArea(40, 30, {0, 5}, {25, 9})); });
  make("restate", [&](Samples& s) { restate(s, {2, 4}, {2, true, 3}); });
  make("radius", [&](Samples& s) { s.settings.votes.radius = 12; });
  make("remove", [&](Samples& s) { removeStrokes(s, {1, 2, 6}); });
  make("classes", [&](Samples& s) {
    changeClasses(s, ColorClasses({{"green", {0, 160, 40}}, {"blue", {0, 0, 255}}}), {0, 0, 1});
  });
  for (std::size_t i = states.size() - 1; i > 0; --i) {
    document.undo();
    EXPECT_EQ(document.samples(), states[i - 1]) << i;
  }
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.changed());
  for (std::size_t i = 1; i < states.size(); ++i) {
    document.redo();
    EXPECT_EQ(document.samples(), states[i]) << i;
  }
  EXPECT_FALSE(document.canRedo());
  for (int i = 0; i < 5; ++i) document.undo();
  for (std::size_t i = 0; i < states.size(); ++i) EXPECT_EQ(document.samplesAt(i), states[i]) << i;
  EXPECT_EQ(document.samples(), states[10]);
  EXPECT_EQ(document.steps(), 15U);
  EXPECT_EQ(document.text(12), "radius");
}

TEST(SampleDocument, aGestureIsOneStep) {
  SampleDocument document(emptySamples());
  for (const double radius : {9.0, 10.0, 11.0}) {
    Samples next = document.samples();
    next.settings.votes.radius = radius;
    document.change("radius", std::move(next), "radius");
  }
  EXPECT_EQ(document.steps(), 1U);
  EXPECT_EQ(document.samples().settings.votes.radius, 11);
  document.undo();
  EXPECT_EQ(document.samples(), emptySamples());
  document.redo();
  Samples next = document.samples();
  next.settings.votes.radius = 4;
  document.change("radius", std::move(next), "radius");
  EXPECT_EQ(document.steps(), 2U) << "the gesture had ended";
}

TEST(SampleDocument, knowsWhetherItIsSaved) {
  SampleDocument document(emptySamples());
  Samples next = quarterSamples();
  EXPECT_FALSE(document.change("nothing", document.samples()));
  document.change("strokes", next);
  EXPECT_TRUE(document.changed());
  document.setSaved();
  document.undo();
  EXPECT_TRUE(document.changed());
  document.redo();
  EXPECT_FALSE(document.changed());
  document.undo();
  next.settings.votes.radius = 5;
  document.change("other", next);
  EXPECT_TRUE(document.changed()) << "what was saved cannot be reached any more";
  document.undo();
  EXPECT_TRUE(document.changed());
}
