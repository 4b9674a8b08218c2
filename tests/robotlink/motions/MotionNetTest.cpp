// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionLibrary.h"

#include <gtest/gtest.h>

#include "robotlink/motions/MotionReader.h"
#include "robotlink/motions/MotionWriter.h"

namespace robotlink {
namespace {

MotionFile file(const std::string& text, const std::string& path) {
  auto motion = readMotion(text, path, {"a", "b"});
  if (!motion) ADD_FAILURE() << describe(motion.error());
  return motion ? *motion : MotionFile{};
}

const char* const kExtern =
    "motion_id = extern\nlabel start\ntransition nod nod start\ntransition extern extern start\n";

/// The motions that can be requested: those in the entry table, in its order.
std::vector<std::string> requestable(const MotionNet& net) {
  std::vector<std::string> names;
  const int table = net.find(MotionNet::kEntryName);
  for (const MotionNet::Node& node : net.nodes) {
    const auto* transition = std::get_if<MotionNet::Transition>(&node.step);
    if (node.motion == table && transition != nullptr && transition->request >= 0 &&
        transition->request != table)
      names.push_back(net.motions[static_cast<std::size_t>(transition->request)]);
  }
  return names;
}

/// Describes what is wrong with a nod.mof beside an extern.mof.
std::string errorsOf(const std::string& nod, const std::string& table = kExtern) {
  const std::vector<MotionFile> files{file(table, "extern.mof"), file(nod, "nod.mof")};
  const auto net = compileMotions(files, {"a", "b"});
  return net ? "none" : describe(net.error());
}

TEST(MotionNetTest, labelsBecomeNodeNumbers) {
  const std::vector<MotionFile> files{
      file(kExtern, "extern.mof"),
      file("motion_id = nod\nlabel start\n1 2 1 8\nlabel hold\n1 2 1 8\ntransition nod nod hold\n"
           "transition allMotions extern start\n",
           "nod.mof")};
  const auto net = compileMotions(files, {"a", "b"});
  ASSERT_TRUE(net) << describe(net.error());
  EXPECT_EQ(requestable(**net), std::vector<std::string>{"nod"});
  ASSERT_EQ((*net)->nodes.size(), 6u);
  EXPECT_EQ(std::get<MotionNet::Transition>((*net)->nodes[0].step).target, 2);
  EXPECT_EQ(std::get<MotionNet::Transition>((*net)->nodes[4].step).target, 3);
  EXPECT_EQ((*net)->nodes[4].line, 6);
}

TEST(MotionNetTest, columnsFollowTheJointsOfTheRobot) {
  const std::vector<MotionFile> files{
      file("motion_id = extern\nlabel start\ntransition extern extern start\n", "extern.mof"),
      file("motion_id = nod\njoints = c a\nlabel start\n30 10 1 8\ntransition allMotions extern start\n",
           "nod.mof")};
  const auto net = compileMotions(files, {"a", "b", "c"});
  ASSERT_TRUE(net) << describe(net.error());
  const auto& frame = std::get<KeyFrame>((*net)->nodes[1].step);
  EXPECT_NEAR(frame.joints[0].angle, 0.1745, 1e-4);
  EXPECT_EQ(frame.joints[1].kind, JointValue::Kind::kKeep);
  EXPECT_NEAR(frame.joints[2].angle, 0.5236, 1e-4);
}

TEST(MotionNetTest, whatOneFileAloneCannotShowIsCheckedHere) {
  const std::string end = "transition allMotions extern start\n";
  EXPECT_EQ(errorsOf("motion_id = nod\nlabel start\n" + end), "none");
  EXPECT_EQ(errorsOf("motion_id = nod\nlabel start\ntransition nod nod stop\n" + end),
            "nod.mof:3:1: the motion 'nod' has no label 'stop'");
  EXPECT_EQ(errorsOf("motion_id = nod\nlabel start\ntransition wink nod start\n" + end),
            "nod.mof:3:1: there is no motion 'wink' to request");
  EXPECT_EQ(errorsOf("motion_id = nod\nlabel start\ntransition nod wink start\n" + end),
            "nod.mof:3:1: there is no motion 'wink' to go to");
  EXPECT_EQ(errorsOf("motion_id = nod\n1 2 1 8\nlabel start\n" + end),
            "nod.mof:2:1: this line is never played; put a label before it");
  EXPECT_EQ(errorsOf("motion_id = nod\nlabel start\n" + end + "1 2 1 8\n" + "label a\n" + end),
            "nod.mof:4:1: this line is never played; put a label before it");
  EXPECT_EQ(errorsOf("motion_id = nod\nlabel start\n1 2 1 8\n"),
            "nod.mof:3:1: the motion 'nod' must end in 'transition allMotions MOTION LABEL'");
  EXPECT_EQ(errorsOf("motion_id = nod\nlabel start\nlabel start\n" + end),
            "nod.mof:3:1: the label 'start' appears here for the second time");
  EXPECT_EQ(errorsOf("motion_id = nod\njoints = a z\nlabel start\n" + end),
            "nod.mof:2:1: the robot has no joint 'z'");
  EXPECT_EQ(errorsOf("motion_id = extern\nlabel start\n" + end),
            "nod.mof:1:1: another file already is the motion 'extern'\nnod.mof:2:1: the label 'start' "
            "appears here for the second time");
}

TEST(MotionNetTest, withoutAnEntryTableNothingCanBePlayed) {
  const std::vector<MotionFile> files{
      file("motion_id = nod\nlabel start\ntransition allMotions nod start\n", "nod.mof")};
  const auto net = compileMotions(files, {"a", "b"});
  ASSERT_FALSE(net);
  EXPECT_EQ(net.error()[0].id, "motion.no-entry");
  EXPECT_FALSE(compileMotions({}, {"a"}));
}

TEST(MotionNetTest, aFolderThatIsMissingIsAnError) {
  const auto net = loadMotions("/nonexistent", {"a"});
  ASSERT_FALSE(net);
  EXPECT_EQ(net.error()[0].id, "motion.unreadable");
}

TEST(MotionNetTest, theShippedMotionsCompileAndKeepTheirText) {
  const std::filesystem::path folder = ROBOTCONTROL_SOURCE_DIR "/resources/motions";
  const auto net =
      loadMotions(folder, {"neckTilt", "headPan", "legFL1", "legFL2", "legFL3", "legFR1", "legFR2", "legFR3",
                           "legHL1", "legHL2", "legHL3", "legHR1", "legHR2", "legHR3"});
  ASSERT_TRUE(net) << describe(net.error());
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto motion = readMotionFile(entry.path());
    ASSERT_TRUE(motion) << describe(motion.error());
    EXPECT_EQ(*readMotion(writeMotion(*motion), motion->path), *motion) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 10U);
  EXPECT_EQ((*net)->motions.size(), files);
  EXPECT_EQ(requestable(**net).size(), files - 1) << "all but the entry table";
}

/// Motions of a real team, for a robot of 22 joints.
TEST(MotionNetTest, theMotionsOfARealTeamCompileAndKeepTheirText) {
  const std::filesystem::path folder = ROBOTCONTROL_SOURCE_DIR "/../shared/data/motions/mof";
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << "the real motions in ../shared/data/motions are not here";
  std::vector<std::string> joints;
  for (int i = 0; i < 22; ++i) joints.push_back("joint" + std::to_string(i));
  const auto net = loadMotions(folder, joints);
  ASSERT_TRUE(net) << describe(net.error());
  EXPECT_EQ((*net)->motions.size(), 9u);
  EXPECT_EQ(requestable(**net).size(), 8u);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto motion = readMotionFile(entry.path());
    ASSERT_TRUE(motion) << describe(motion.error());
    EXPECT_EQ(*readMotion(writeMotion(*motion), motion->path), *motion) << entry.path();
  }
}

}  // namespace
}  // namespace robotlink
