// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionImport.h"

#include <gtest/gtest.h>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/motions/MotionEdits.h"
#include "robotlink/motions/MotionLibrary.h"
#include "robotlink/motions/MotionReader.h"
#include "robotlink/motions/MotionWriter.h"
#include "tests/TestFolder.h"
#include "tests/robotlink/motions/CmpackBytes.h"

namespace robotlink {
namespace {

const std::vector<std::string> kErs210Joints{"neckTilt", "headPan", "headRoll", "mouth",   "earL",
                                             "earR",     "legFR1",  "legFR2",   "legFR3",  "legFL1",
                                             "legFL2",   "legFL3",  "legHR1",   "legHR2",  "legHR3",
                                             "legHL1",   "legHL2",  "legHL3",   "tailPan", "tailTilt"};

const std::string kPosKick =
    "2\r\n"
    "# a kick\r\n"
    "40  11 ?  -3  -114 11 114  -110 10 100  85 14 28  80 13 27\r\n"
    "\r\n"
    "15 -17.5 0 0  1 2 3  4 5 6  7 8 9  10 11 12";

double degreesOf(const MotionFile& motion, const KeyFrame& frame, const std::string& joint) {
  const auto found = std::ranges::find(motion.joints, joint);
  return degrees(frame.joints[static_cast<std::size_t>(found - motion.joints.begin())].angle);
}

std::string posError(const std::string& text) {
  const auto motion = readPosMotion(text, "x.pos");
  if (motion) return "none";
  return motion.error()[0].id + " " + std::to_string(motion.error()[0].where.line) + ":" +
         std::to_string(motion.error()[0].where.column);
}

std::string cmpackError(const std::string& bytes) {
  const auto motion = readCmpackMotion(bytes, "x.mot");
  return motion ? "none" : motion.error()[0].describe();
}

/// The text of an import is a motion that compiles for the robot, beside an entry table.
void expectItCompiles(const MotionFile& motion) {
  const TestFolder folder;
  folder.write("extern.mof", "motion_id = extern\nlabel start\ntransition extern extern start\n");
  MotionLibrary library = *MotionLibrary::load(folder.path());
  library.replace(motion.name, writeMotion(motion));
  const auto net = library.compile(kErs210Joints);
  EXPECT_TRUE(net) << describe(net.error());
}

TEST(MotionImportTest, aMotionOfRunswiftKeepsItsPosesAndTimes) {
  const auto motion = readPosMotion(kPosKick, "/somewhere/GT kick.pos");
  ASSERT_TRUE(motion) << describe(motion.error());
  EXPECT_EQ(motion->name, "GT_kick");
  const auto frames = keyFramesOf(*motion);
  ASSERT_EQ(frames.size(), 2U);
  const KeyFrame& first = keyFrameAt(*motion, frames[0]);
  EXPECT_EQ(first.duration, std::chrono::milliseconds(320));
  EXPECT_EQ(first.interpolation, 0);
  EXPECT_EQ(first.joints[1].kind, JointValue::Kind::kKeep);
  EXPECT_NEAR(degreesOf(*motion, first, "neckTilt"), 11, 1e-9);
  EXPECT_NEAR(degreesOf(*motion, first, "legFR1"), -114, 1e-9);
  EXPECT_NEAR(degreesOf(*motion, first, "legFL1"), -110, 1e-9);
  EXPECT_NEAR(degreesOf(*motion, first, "legHR1"), 85, 1e-9);
  EXPECT_NEAR(degreesOf(*motion, first, "legHL3"), 27, 1e-9);
  EXPECT_EQ(frames[1].begin, std::chrono::milliseconds(320));
  const std::string text = writeMotion(*motion);
  EXPECT_NE(text.find("// Imported from GT kick.pos\n"), std::string::npos);
  EXPECT_NE(text.find("// a kick\n"), std::string::npos);
  expectItCompiles(*motion);
}

TEST(MotionImportTest, faultsOfATextAreReportedWhereTheyStand) {
  EXPECT_EQ(posError(""), "motion.no-count 1:1");
  EXPECT_EQ(posError("x\n"), "motion.no-count 1:1");
  EXPECT_EQ(posError("0\n"), "motion.no-count 1:1");
  const std::string frame = "40 1 2 3  1 2 3  4 5 6  7 8 9  10 11 12\n";
  EXPECT_EQ(posError("1\n" + frame), "none");
  EXPECT_EQ(posError("2\n" + frame), "motion.wrong-count 1:1");
  EXPECT_EQ(posError("1\n40 1 2\n"), "motion.wrong-count 2:6");
  EXPECT_EQ(posError("1\n4.5 1 2 3  1 2 3  4 5 6  7 8 9  10 11 12\n"), "motion.bad-duration 2:1");
  EXPECT_EQ(posError("1\n40 1 2 3  ? 2 3  4 5 6  7 8 9  10 11 12\n"), "motion.bad-angle 2:11");
  EXPECT_EQ(posError("1\n40 nan 2 3  1 2 3  4 5 6  7 8 9  10 11 12\n"), "motion.bad-angle 2:4");
  EXPECT_EQ(posError("1\n40 1 2 3  1 2 3  4 5 6  7 8 9  10 11 1e9\n"), "motion.bad-angle 2:38");
}

TEST(MotionImportTest, aMotionOfCmpackBecomesAngles) {
  const auto motion = readCmpackMotion(cmpackBytes(cmpackKick()), "k_head.mot");
  ASSERT_TRUE(motion) << describe(motion.error());
  EXPECT_EQ(motion->name, "k_head");
  const auto frames = keyFramesOf(*motion);
  ASSERT_EQ(frames.size(), 3U);
  const KeyFrame& rest = keyFrameAt(*motion, frames[0]);
  EXPECT_EQ(rest.duration, std::chrono::milliseconds(300));
  for (const JointValue& value : rest.joints) EXPECT_EQ(value.kind, JointValue::Kind::kKeep);
  const KeyFrame& angles = keyFrameAt(*motion, frames[1]);
  EXPECT_EQ(angles.interpolation, 1);
  EXPECT_NEAR(degreesOf(*motion, angles, "legFL1"), 28.6, 1e-9);
  EXPECT_NEAR(degreesOf(*motion, angles, "headRoll"), 57.3, 1e-9);
  expectItCompiles(*motion);
}

TEST(MotionImportTest, pawsOnTheGroundBecomeAnglesThatPutThemThere) {
  const auto motion = readCmpackMotion(cmpackBytes(cmpackKick()), "k_head.mot");
  ASSERT_TRUE(motion);
  const KeyFrame& standing = keyFrameAt(*motion, keyFramesOf(*motion)[2]);
  // Both sides alike; the nose is down, so the fore legs are bent more.
  for (const char* joint : {"1", "2", "3"}) {
    for (const char* pair : {"legF", "legH"})
      EXPECT_NEAR(degreesOf(*motion, standing, std::string(pair) + "L" + joint),
                  degreesOf(*motion, standing, std::string(pair) + "R" + joint), 1e-9);
  }
  // Forward kinematics with the dimensions of the team gives the place of the left fore paw again.
  const double swing = radians(degreesOf(*motion, standing, "legFL1"));
  const double spread = radians(degreesOf(*motion, standing, "legFL2"));
  const double knee = radians(degreesOf(*motion, standing, "legFL3"));
  const Vector3 upper(12.8, 0.5, -64), lower(-18.88, 0, -66), shoulder(59.5, 59.2, 0);
  const auto turned = [](double angle, const Vector3& axis) { return Eigen::AngleAxisd(angle, axis); };
  const Vector3 leg = upper + turned(-knee, Vector3::UnitY()) * lower;
  const Vector3 inBody =
      shoulder + turned(-swing, Vector3::UnitY()) * (turned(spread, Vector3::UnitX()) * leg);
  const Vector3 onGround = turned(0.28, Vector3::UnitY()) * inBody + Vector3(0, 0, 104);
  EXPECT_NEAR(onGround.x(), 124, 0.5);
  EXPECT_NEAR(onGround.y(), 85, 0.5);
  EXPECT_NEAR(onGround.z(), 0, 0.5);
}

TEST(MotionImportTest, whatCannotBeConvertedIsACommentInItsLine) {
  auto frames = cmpackKick();
  frames[2].limbs[4].attributes = 2;
  frames[2].limbs[0].point = {400, 85, 0};
  const auto motion = readCmpackMotion(cmpackBytes(frames), "x.mot");
  ASSERT_TRUE(motion) << describe(motion.error());
  const MotionLine& line = motion->lines[keyFramesOf(*motion)[2].index];
  EXPECT_EQ(line.comment,
            "// the left fore paw cannot reach its place and comes close; the head looks at a point, which "
            "is left out");
  EXPECT_EQ(std::get<KeyFrame>(line.statement).joints[12].kind, JointValue::Kind::kKeep);
}

TEST(MotionImportTest, otherBytesAreNoMotionOfCmpack) {
  EXPECT_EQ(cmpackError("ab"), "x.mot: the file is shorter than the number of its key frames");
  EXPECT_EQ(cmpackError("#MSq"),
            "x.mot: this is not a motion of CMPack'02: those have 1 to 63 key frames, this one " +
                std::to_string(0x71534d23));
  std::string bytes = cmpackBytes(cmpackKick());
  bytes.pop_back();
  EXPECT_EQ(cmpackError(bytes), "x.mot: 3 key frames need 1012 bytes, but the file has 1011");
  auto frames = cmpackKick();
  frames[1].limbs[2].angles[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cmpackError(cmpackBytes(frames)), "x.mot: key frame 2: an angle is beyond -210 to 210 degrees");
  frames = cmpackKick();
  frames[2].body[2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(cmpackError(cmpackBytes(frames)),
            "x.mot: key frame 3: the place of the left fore paw is not a number");
  frames = cmpackKick();
  frames[0].timeMs = 2'000'000;
  EXPECT_EQ(cmpackError(cmpackBytes(frames)), "x.mot: key frame 1: it lasts longer than 1000 s");
}

TEST(MotionImportTest, theSuffixTellsTheFormat) {
  const TestFolder folder;
  const auto pos = folder.write("kick.pos", kPosKick);
  const auto mot = folder.write("kick.mot", cmpackBytes(cmpackKick()));
  EXPECT_TRUE(isForeignMotion(pos) && isForeignMotion(mot));
  EXPECT_FALSE(isForeignMotion("kick.mof"));
  EXPECT_EQ(keyFramesOf(*importMotion(pos)).size(), 2U);
  EXPECT_EQ(keyFramesOf(*importMotion(mot)).size(), 3U);
  EXPECT_FALSE(importMotion(folder / "missing.pos"));
}

/// Reads all files of a folder with real motions; returns how many.
int importAll(const std::filesystem::path& folder) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto motion = importMotion(entry.path());
    EXPECT_TRUE(motion) << describe(motion.error());
    if (!motion) continue;
    const auto read = readMotion(writeMotion(*motion), motion->path);
    EXPECT_TRUE(read) << describe(read.error());
    EXPECT_GT(keyFramesOf(*motion).size(), 0U) << entry.path();
    expectItCompiles(*motion);
    ++count;
  }
  return count;
}

TEST(MotionImportTest, motionsOfRealTeamsAreImported) {
  const std::filesystem::path folder = ROBOTCONTROL_SOURCE_DIR "/../shared/data/motions";
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << "the real motions in ../shared/data/motions are not here";
  EXPECT_EQ(importAll(folder / "pos"), 34);
  EXPECT_EQ(importAll(folder / "cmpack02"), 11);
}

TEST(MotionImportTest, madeUpMotionsAreImported) {
  const TestFolder folder;
  folder.write("kick.pos", kPosKick);
  folder.write("kick.mot", cmpackBytes(cmpackKick()));
  EXPECT_EQ(importAll(folder.path()), 2);
}

}  // namespace
}  // namespace robotlink
