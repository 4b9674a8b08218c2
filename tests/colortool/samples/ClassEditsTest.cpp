// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/samples/ClassEdits.h"

#include <gtest/gtest.h>

#include "colortool/image/ClassPresets.h"
#include "tests/colortool/SampleFixture.h"

namespace colortool {
namespace {

std::vector<std::string> classesOfStrokes(const Samples& samples) {
  std::vector<std::string> names;
  for (const StrokePtr& stroke : samples.strokes) names.push_back(samples.classes.name(stroke->colorClass));
  return names;
}

const std::vector<std::string> kStrokes = {"orange", "green", "white", "none"};

TEST(ClassEditsTest, aMovedClassTakesItsStrokesAlong) {
  const Samples samples = quarterSamples();
  for (const auto& [from, to] : {std::pair{1, 3}, {3, 1}, {2, 3}, {2, 2}}) {
    const Samples moved = withMovedClass(samples, from, to);
    EXPECT_EQ(moved.classes.name(to), samples.classes.name(from));
    EXPECT_EQ(classesOfStrokes(moved), kStrokes);
    EXPECT_EQ(withMovedClass(moved, to, from), samples);
  }
}

TEST(ClassEditsTest, aClassGoesWithItsStrokes) {
  const Samples less = withoutClass(quarterSamples(), 2);
  EXPECT_EQ(less.classes.names(), (std::vector<std::string>{"orange", "white"}));
  EXPECT_EQ(classesOfStrokes(less), (std::vector<std::string>{"orange", "white", "none"}));
  EXPECT_EQ(strokesOf(less, 2), 1U);
  EXPECT_EQ(strokesOf(less, 0), 1U);
}

TEST(ClassEditsTest, namesAreRefusedWhenTakenOrImpossible) {
  const Samples samples = quarterSamples();
  EXPECT_EQ(withRenamedClass(samples, 1, "ball")->classes.name(1), "ball");
  EXPECT_EQ(withRenamedClass(samples, 1, "orange"), samples);
  for (const char* name : {"green", "background", "none", ""}) {
    EXPECT_FALSE(withRenamedClass(samples, 1, name)) << name;
    EXPECT_FALSE(withNewClass(samples, {name, {}})) << name;
  }
  EXPECT_NE(withRenamedClass(samples, 1, "green").error().text.find("'green'"), std::string::npos);
}

TEST(ClassEditsTest, newClassesComeLastUnderAFreeName) {
  Samples samples = quarterSamples();
  for (int i = 0; i < 2; ++i) {
    const auto more = withNewClass(samples, {freeClassName(samples.classes), {1, 2, 3}});
    ASSERT_TRUE(more);
    samples = *more;
  }
  EXPECT_EQ(samples.classes.name(4), "class 4");
  EXPECT_EQ(samples.classes.name(5), "class 5");
  EXPECT_EQ(withRecoloredClass(samples, 5, {9, 8, 7}).classes.shownColor(5), (robotlink::Rgb{9, 8, 7}));
}

TEST(ClassEditsTest, thereAreAtMostAsManyClassesAsNumbers) {
  Samples samples;
  for (int i = 0; i < ColorClasses::kMax; ++i)
    samples = *withNewClass(samples, {freeClassName(samples.classes), {}});
  const auto more = withNewClass(samples, {freeClassName(samples.classes), {}});
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().id, "color.classes");
}

TEST(ClassEditsTest, otherClassesKeepWhatHasStrokes) {
  Samples samples = *withNewClass(quarterSamples(), {"unused", {}});
  samples = *withRenamedClass(samples, 1, "ball");
  const Samples other = withClasses(samples, findClassPreset("2002")->classes());
  EXPECT_EQ(other.classes.name(1), "orange");
  EXPECT_EQ(other.classes.names().back(), "ball");
  EXPECT_EQ(classesOfStrokes(other), (std::vector<std::string>{"ball", "green", "white", "none"}));
}

}  // namespace
}  // namespace colortool
