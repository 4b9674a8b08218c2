// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionLibrary.h"

#include <gtest/gtest.h>

#include <fstream>

#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"

namespace robotlink {
namespace {

const std::string kMotionEnd = "transition allMotions extern start\n";

std::string motion(const std::string& name, int angle) {
  return "motion_id = " + name + "\nlabel start\n" + std::to_string(angle) + " 1 100\n" + kMotionEnd;
}

/// A folder with an entry table and the motion nod.
struct Folder {
  Folder() {
    write("extern.mof",
          "motion_id = extern\nlabel start\ntransition nod nod start\ntransition extern extern start\n");
    write("nod.mof", motion("nod", 10));
  }
  void write(const std::string& name, const std::string& text) const {
    ASSERT_TRUE(writeFileAtomically(folder.path() / name, text));
  }
  MotionLibrary load() const { return *MotionLibrary::load(folder.path()); }
  TestFolder folder;
};

double firstAngle(const MotionNet& net, const std::string& name) {
  for (const MotionNet::Node& node : net.nodes) {
    const auto* frame = std::get_if<KeyFrame>(&node.step);
    if (frame != nullptr && node.motion == net.find(name)) return frame->joints[0].angle * 180 / 3.14159265;
  }
  return -1;
}

TEST(MotionLibraryTest, aReplacedMotionIsPlayedUntilItIsRemoved) {
  MotionLibrary library = Folder().load();
  library.replace("nod", motion("nod", 20));
  EXPECT_TRUE(library.find("nod")->isReplaced);
  EXPECT_NEAR(firstAngle(**library.compile({"a"}), "nod"), 20, 1e-6);
  library.replace("nod", motion("nod", 30));
  EXPECT_NEAR(firstAngle(**library.compile({"a"}), "nod"), 30, 1e-6);
  library.replace("nod", {});
  EXPECT_FALSE(library.find("nod")->isReplaced);
  EXPECT_NEAR(firstAngle(**library.compile({"a"}), "nod"), 10, 1e-6);
  library.replace("nod", {});
  EXPECT_EQ(library.entries().size(), 2U);
}

TEST(MotionLibraryTest, anAddedMotionCanBeRequested) {
  MotionLibrary library = Folder().load();
  library.replace("bow", motion("bow", 5));
  const auto net = library.compile({"a"});
  ASSERT_TRUE(net) << describe(net.error());
  const int bow = (*net)->find("bow");
  const auto leads = [&](const MotionNet::Node& node) {
    const auto* jump = std::get_if<MotionJump>(&node.step);
    return jump != nullptr && node.motion == (*net)->find("extern") && jump->request == bow;
  };
  EXPECT_EQ(std::ranges::count_if((*net)->nodes, leads), 1);
  library.replace("bow", {});
  EXPECT_EQ(library.find("bow"), nullptr);
}

TEST(MotionLibraryTest, errorsOfReplacedTextsNameTheMotion) {
  MotionLibrary library = Folder().load();
  library.replace("bow", "motion_id = bow\nlabel start\n1 1\n" + kMotionEnd);
  const auto net = library.compile({"a"});
  ASSERT_FALSE(net);
  EXPECT_EQ(net.error()[0].describe().substr(0, 9), "bow.mof:3");
  library.replace("bow", "motion_id = bow\nlabel start\n1 1 100\ntransition allMotions nowhere start\n");
  const auto lost = library.compile({"a"});
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error()[0].id, "motion.unknown-motion");
}

TEST(MotionLibraryTest, theNameIsThatInTheTextNotThatOfTheFile) {
  Folder folder;
  folder.write("another-file.mof", motion("bow", 7));
  MotionLibrary library = folder.load();
  ASSERT_NE(library.find("bow"), nullptr);
  library.replace("bow", motion("bow", 8));
  EXPECT_TRUE(library.compile({"a"}));
}

TEST(MotionLibraryTest, aFolderThatCannotBeReadIsAnError) {
  EXPECT_FALSE(MotionLibrary::load("/nonexistent"));
  Folder folder;
  folder.write("long.mof", std::string(MotionLibrary::kMaxTextBytes + 1, ' '));
  const auto library = MotionLibrary::load(folder.folder.path());
  ASSERT_FALSE(library);
  EXPECT_EQ(library.error()[0].id, "motion.unreadable");
}

}  // namespace
}  // namespace robotlink
