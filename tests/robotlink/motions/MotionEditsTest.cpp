// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionEdits.h"

#include <gtest/gtest.h>

#include "robotlink/base/Geometry.h"
#include "robotlink/motions/MotionDocument.h"

namespace robotlink {
namespace {

const std::string kNod =
    "motion_id = nod\n"
    "joints = headPan legFL1 legFR1\n"
    "\n"
    "label start\n"
    "hardness 100 50 * 200\n"
    "  10   -5.5  40   1 300   \" look\n"
    "// between\n"
    " -10    *     -   0 100\n"
    "transition allMotions extern start\n";

const std::vector<MirroredJoint> kMirror{{"headPan", true}, {"legFR1", false}, {"legFL1", false}};

MotionFile motionOf(const std::string& text) {
  return parseMotion(text, "nod.mof").motion;
}

std::string rowOfText(const std::string& text, int line) {
  std::istringstream rows(text);
  std::string row;
  for (int i = 0; i < line; ++i) std::getline(rows, row);
  return row;
}

TEST(MotionEditsTest, keyFramesHaveTheirTimes) {
  const MotionFile motion = motionOf(kNod);
  const auto frames = keyFramesOf(motion);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].line, 6);
  EXPECT_EQ(frames[1].line, 8);
  EXPECT_EQ(frames[1].begin, std::chrono::milliseconds(300));
  EXPECT_EQ(keyFrameAt(motion, frames[1]).interpolation, 0);
}

TEST(MotionEditsTest, aValueIsReplacedAndTheRestOfTheLineStays) {
  const MotionFile motion = motionOf(kNod);
  const JointValue angle{JointValue::Kind::kAngle, radians(-117.5)};
  const std::string text = withValue(kNod, motion, 6, 0, angle);
  EXPECT_EQ(rowOfText(text, 6), "-117.5   -5.5  40   1 300   \" look");
  EXPECT_EQ(rowOfText(withValue(kNod, motion, 6, 1, {}), 6), "  10      *  40   1 300   \" look");
  EXPECT_EQ(rowOfText(withValue(kNod, motion, 8, 2, angle), 8), " -10    * -117.5   0 100");
  EXPECT_EQ(rowOfText(withInterpolation(kNod, motion, 6, 3), 6), "  10   -5.5  40   3 300   \" look");
  EXPECT_EQ(rowOfText(withDuration(kNod, motion, 6, std::chrono::milliseconds(1250)), 6),
            "  10   -5.5  40   1 1250   \" look");
  // What is not there does not change the text.
  EXPECT_EQ(withValue(kNod, motion, 7, 0, angle), kNod);
  EXPECT_EQ(withValue(kNod, motion, 6, 3, angle), kNod);
  EXPECT_EQ(withDuration(kNod, motion, 99, std::chrono::milliseconds(1)), kNod);
}

TEST(MotionEditsTest, valuesAreWrittenInTheUnitsOfTheText) {
  const std::string text = "motion_id = x\nunits = mrad\ntime = ticks\nlabel start\n100 200 1 4\n";
  const MotionFile motion = motionOf(text);
  EXPECT_EQ(rowOfText(withValue(text, motion, 5, 1, {JointValue::Kind::kAngle, 0.25}), 5), "100 250 1 4");
  EXPECT_EQ(rowOfText(withDuration(text, motion, 5, std::chrono::milliseconds(100)), 5), "100 200 1 13");
  EXPECT_EQ(rowOfText(withDuration(text, motion, 5, {}), 5), "100 200 1 1");
}

TEST(MotionEditsTest, keyFramesAreAddedMovedAndRemoved) {
  MotionFile motion = motionOf(kNod);
  const KeyFrame pose{{{JointValue::Kind::kAngle, radians(1.5)}, {}, {JointValue::Kind::kRelease, 0}},
                      2,
                      std::chrono::milliseconds(80)};
  std::string text = withFrame(kNod, motion, lastFrameLine(kNod, motion), pose);
  EXPECT_EQ(rowOfText(text, 9), "   1.5     *     - 2 80");
  motion = motionOf(text);
  ASSERT_EQ(keyFramesOf(motion).size(), 3U);
  EXPECT_EQ(keyFrameAt(motion, keyFramesOf(motion)[2]), pose);
  text = withLinesSwapped(text, 6, 9);
  EXPECT_EQ(rowOfText(text, 6), "   1.5     *     - 2 80");
  text = withLinesSwapped(text, 6, 9);
  EXPECT_EQ(withoutLine(text, 9), kNod);
  EXPECT_EQ(withoutLine(kNod, 0), kNod);
  EXPECT_EQ(withLinesSwapped(kNod, 1, 99), kNod);
}

TEST(MotionEditsTest, aNewMotionEndsAsMotionsDo) {
  std::string text = newMotion("wave", {"a", "b"});
  EXPECT_EQ(text, "motion_id = wave\njoints = a b\n\nlabel start\n\ntransition allMotions extern start\n");
  MotionFile motion = motionOf(text);
  text = withFrame(text, motion, lastFrameLine(text, motion), {{{}, {}}, 1, std::chrono::milliseconds(8)});
  const auto parse = parseMotion(text, "wave.mof");
  EXPECT_TRUE(parse.errors.empty());
  EXPECT_EQ(keyFramesOf(parse.motion).front().line, 5);
  EXPECT_EQ(motionOf(withName(kNod, "shake")).name, "shake");
  EXPECT_EQ(withName("label start\n", "x"), "motion_id = x\nlabel start\n");
}

TEST(MotionEditsTest, aMirroredMotionIsThatOfTheOtherSide) {
  const MotionFile motion = motionOf(kNod);
  const auto text = mirrored(kNod, motion, kMirror);
  ASSERT_TRUE(text) << text.error().describe();
  EXPECT_EQ(rowOfText(*text, 5), "hardness 100  * 50 200");
  EXPECT_EQ(rowOfText(*text, 6), " -10     40 -5.5   1 300   \" look");
  EXPECT_EQ(rowOfText(*text, 8), "  10    -     *   0 100");
  // Twice is what it was.
  const auto twice = mirrored(*text, motionOf(*text), kMirror);
  EXPECT_EQ(motionOf(*twice).lines, motion.lines);
  // A single line.
  const auto one = mirrored(kNod, motion, kMirror, 8);
  EXPECT_EQ(rowOfText(*one, 6), rowOfText(kNod, 6));
  EXPECT_EQ(rowOfText(*one, 8), "  10    -     *   0 100");
}

TEST(MotionEditsTest, aMotionWithoutTheOtherSideCannotBeMirrored) {
  const std::string text = "motion_id = x\njoints = legFL1\nlabel start\n1 1 8\n";
  const auto result = mirrored(text, motionOf(text), {{"legFR1", false}});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().id, "motion.mirror");
}

TEST(MotionDocumentTest, stepsAreUndoneAndRedoneExactly) {
  MotionDocument document(kNod, "nod.mof");
  EXPECT_FALSE(document.changed());
  std::vector<std::string> states{document.text()};
  for (int i = 0; i < 4; ++i) {
    const std::string next = withDuration(document.text(), document.motion(), i % 2 == 0 ? 6 : 8,
                                          std::chrono::milliseconds(1000 * (i + 1)));
    EXPECT_TRUE(document.change("duration", next));
    states.push_back(document.text());
  }
  EXPECT_TRUE(document.changed());
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    document.undo();
    EXPECT_EQ(document.text(), states[i]);
  }
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.changed());
  for (std::size_t i = 1; i < states.size(); ++i) {
    document.redo();
    EXPECT_EQ(document.text(), states[i]);
  }
  EXPECT_FALSE(document.canRedo());
  // What can be read follows the text.
  EXPECT_EQ(keyFrameAt(document.motion(), keyFramesOf(document.motion())[1]).duration,
            std::chrono::milliseconds(4000));
}

TEST(MotionDocumentTest, aGestureIsOneStep) {
  MotionDocument document("ab");
  EXPECT_TRUE(document.change("type", "abc", "typing"));
  EXPECT_FALSE(document.change("type", "abcd", "typing"));
  EXPECT_FALSE(document.change("type", "abcde", "typing"));
  EXPECT_EQ(document.steps(), 1U);
  document.undo();
  EXPECT_EQ(document.text(), "ab");
  document.redo();
  EXPECT_EQ(document.text(), "abcde");
  EXPECT_TRUE(document.change("type", "abcdef", "typing"));  // after a redo it is another gesture
  document.endGesture();
  EXPECT_TRUE(document.change("type", "abcdefg", "typing"));
  EXPECT_EQ(document.steps(), 3U);
}

TEST(MotionDocumentTest, savedIsTheStateThatWasSavedNotTheNumberOfSteps) {
  MotionDocument document("a");
  document.change("1", "ab");
  document.setSaved();
  EXPECT_FALSE(document.changed());
  document.undo();
  EXPECT_TRUE(document.changed());
  document.change("2", "ac");  // the saved state is lost
  EXPECT_TRUE(document.changed());
  document.undo();
  EXPECT_TRUE(document.changed());
}

TEST(MotionDocumentTest, aTextWithErrorsShowsWhatCanBeRead) {
  MotionDocument document("motion_id = x\nlabel start\n1 2 1 8\n1 2 3 4 5\n3 4 1 8\n", "x.mof");
  ASSERT_EQ(document.errors().size(), 1U);
  EXPECT_EQ(document.errors()[0].where.line, 4);
  EXPECT_EQ(keyFramesOf(document.motion()).size(), 2U);
}

}  // namespace
}  // namespace robotlink
