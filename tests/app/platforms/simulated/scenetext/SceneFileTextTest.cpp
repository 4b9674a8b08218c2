// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/scenetext/SceneFileText.h"

#include <gmock/gmock.h>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using testing::HasSubstr;

constexpr char kWorld[] = R"(<?xml version="1.0"?>
<!-- A comment with <pose>1 2 3</pose> in it. -->
<sdf version="1.9">
  <world name="w">
    <include>
      <uri>model://ball</uri>
      <pose>0 0 0.0421 0 0 0</pose>  <!-- on the spot -->
    </include>
    <include>
      <uri>model://ers210</uri>
      <name>red1</name>
    </include>
    <model name="box">
      <link name='a'><collision name="c"><surface/></collision></link>
      <link name="b">
        <inertial>
          <mass>2</mass>
        </inertial>
      </link>
    </model>
  </world>
</sdf>
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST(SceneFileText, onlyTheElementChanges) {
  const auto changed = withElement(kWorld, "w.sdf", {"instance[ball]", "pose"}, "1 0 0 0 0 0");
  ASSERT_TRUE(changed) << changed.error().describe();
  EXPECT_EQ(*changed, replaced(kWorld, "0 0 0.0421 0 0 0", "1 0 0 0 0 0"));
}

TEST(SceneFileText, elementsOfAModelAreFoundByTheirNames) {
  const auto changed = withElement(kWorld, "w.sdf", {"instance[box]", "link[b]", "inertial", "mass"}, "3");
  ASSERT_TRUE(changed) << changed.error().describe();
  EXPECT_EQ(*changed, replaced(kWorld, "<mass>2</mass>", "<mass>3</mass>"));
}

TEST(SceneFileText, whatIsMissingIsAddedOnItsOwnLine) {
  const auto changed = withElement(kWorld, "w.sdf", {"instance[red1]", "pose"}, "1 2 0 0 0 0");
  ASSERT_TRUE(changed) << changed.error().describe();
  EXPECT_EQ(*changed,
            replaced(kWorld, "<name>red1</name>\n", "<name>red1</name>\n      <pose>1 2 0 0 0 0</pose>\n"));
}

TEST(SceneFileText, anEmptyTagIsOpenedForWhatIsMissing) {
  const auto changed =
      withElement(kWorld, "w.sdf",
                  {"instance[box]", "link[a]", "collision[c]", "surface", "friction", "ode", "mu"}, "0.5");
  ASSERT_TRUE(changed) << changed.error().describe();
  EXPECT_EQ(*changed, replaced(kWorld, "<surface/>",
                               "<surface><friction><ode><mu>0.5</mu></ode></friction></surface>"));
}

TEST(SceneFileText, valuesOfSeveralElementsAreWrittenTogether) {
  const std::vector<std::string> place{"instance[box]", "link[b]", "inertial", "inertia", "ixx,iyy,izz"};
  const auto changed = withElement(kWorld, "w.sdf", place, "1 2 2.5");
  ASSERT_TRUE(changed) << changed.error().describe();
  EXPECT_THAT(*changed, HasSubstr("<ixx>1</ixx>"));
  const auto again = withElement(*changed, "w.sdf", place, "3 4 5");
  ASSERT_TRUE(again) << again.error().describe();
  EXPECT_EQ(*again, replaced(replaced(replaced(*changed, "<ixx>1<", "<ixx>3<"), "<iyy>2<", "<iyy>4<"),
                             "<izz>2.5<", "<izz>5<"));
  EXPECT_FALSE(withElement(kWorld, "w.sdf", place, "1 2"));
}

TEST(SceneFileText, momentsInTurnedAxesAreLeftAlone) {
  const auto change = [](const char* pose) {
    return withElement(replaced(kWorld, "<mass>2</mass>", "<mass>2</mass>" + std::string(pose)), "w.sdf",
                       {"instance[box]", "link[b]", "inertial", "inertia", "ixx,iyy,izz"}, "1 1 1");
  };
  EXPECT_TRUE(change("<pose>0.1 0 0 0 0 0</pose>"));
  const auto turned = change("<pose>0 0 0 0 0 1.5</pose>");
  ASSERT_FALSE(turned);
  EXPECT_THAT(turned.error().describe(), HasSubstr("w.sdf:17"));
}

TEST(SceneFileText, whatIsNotThereIsNamedWithItsLine) {
  const auto missing = withElement(kWorld, "w.sdf", {"instance[box]", "link[c]", "inertial", "mass"}, "3");
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().describe(), HasSubstr("w.sdf:13"));
  EXPECT_THAT(missing.error().text, HasSubstr("link[c]"));
  EXPECT_FALSE(withElement(kWorld, "w.sdf", {"instance[nobody]", "pose"}, "0"));
}

TEST(SceneFileText, aPoseInAnotherFrameIsLeftAlone) {
  const std::string text = replaced(kWorld, "<pose>0 0 0.0421", "<pose relative_to='x'>0 0 0.0421");
  EXPECT_FALSE(withElement(text, "w.sdf", {"instance[ball]", "pose"}, "0 0 0 0 0 0"));
}

TEST(SceneFileText, damagedTextsAreRefused) {
  for (const char* text : {"<a><b></a>", "<a", "<a name=\"", "</a>", "<!-- ", "<a><![CDATA[ </a>"}) {
    EXPECT_FALSE(withElement(text, "w.sdf", {"model", "pose"}, "0")) << text;
  }
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_FALSE(withElement(deep, "w.sdf", {"model", "pose"}, "0"));
}

TEST(SceneFileText, aValueCannotEndItsElement) {
  const auto changed = withElement(kWorld, "w.sdf", {"instance[ball]", "pose"}, "</pose>&");
  ASSERT_TRUE(changed);
  EXPECT_THAT(*changed, HasSubstr("<pose>&lt;/pose&gt;&amp;</pose>"));
}

TEST(SceneFileText, filesElsewhereAreNotWritten) {
  const TestFolder folder;
  folder.write("scenes/w.sdf", kWorld);
  folder.write("other.sdf", kWorld);
  const auto scene = folder.path() / "scenes/w.sdf", other = folder.path() / "other.sdf";
  const auto models = folder.path() / "models";
  EXPECT_FALSE(
      writeSceneChanges(scene, models, {{other.string(), {"instance[ball]", "pose"}, "1 1 1 0 0 0"}}));
  const auto done =
      writeSceneChanges(scene, models, {{scene.string(), {"instance[ball]", "pose"}, "1 1 1 0 0 0"}});
  ASSERT_TRUE(done) << done.error().describe();
  EXPECT_THAT(*robotlink::readFile(scene), HasSubstr("<pose>1 1 1 0 0 0</pose>  <!-- on the spot -->"));
  EXPECT_EQ(*robotlink::readFile(other), kWorld);
}

}  // namespace app
