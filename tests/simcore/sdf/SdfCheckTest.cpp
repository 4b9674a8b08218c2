// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfCheck.h"

#include <gmock/gmock.h>
#include <tinyxml2.h>

#include "simcore/sdf/SdfSpec.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using testing::HasSubstr;
using testing::Lt;
using testing::StartsWith;

class SdfCheck : public testing::Test {
 protected:
  /// What is wrong with a text and what is left out of it, one per line.
  static std::string errorsOf(const std::string& text) {
    tinyxml2::XMLDocument document;
    EXPECT_EQ(document.Parse(text.c_str()), tinyxml2::XML_SUCCESS) << text;
    robotlink::Errors errors;
    LeftOuts leftOut;
    checkSdfTree(document, "m.sdf", SdfSpec::shared(), errors, leftOut);
    std::string found = describe(errors);
    for (const LeftOut& one : leftOut) {
      found += (found.empty() ? "" : "\n") + std::to_string(one.where.line) + " left out: " + one.object +
               ": " + one.what + ": " + one.why;
    }
    return found;
  }
  /// What is wrong with the small model after one replacement.
  static std::string broken(const std::string& from, const std::string& to) {
    return errorsOf(replaced(kSmallModel, from, to));
  }
};

TEST_F(SdfCheck, aSoundModelHasNoErrors) {
  EXPECT_EQ(errorsOf(kSmallModel), "");
}

TEST_F(SdfCheck, unknownElementsAndAttributesAreLeftOutWithTheirPlace) {
  EXPECT_EQ(
      broken("<child>arm</child>", "<child>arm</child><chilt>red</chilt>"),
      "21 left out: small/hip: <chilt> in <joint>: SDFormat 1.9 has no such element; is <child> meant?");
  EXPECT_EQ(broken("<mass>1.5", "<mass unit=\"kg\">1.5"),
            "7 left out: small/foot: attribute 'unit' of <mass>: SDFormat 1.9 has no such attribute");
  EXPECT_EQ(broken("<collision name=\"hand\">", "<collision>"),
            "m.sdf:16: small/arm: <collision> needs the attribute 'name'");
}

TEST_F(SdfCheck, elementsOfOtherNamespacesAreLeftAlone) {
  EXPECT_EQ(broken("<child>arm</child>", "<child>arm</child><gz:colour>red</gz:colour>"), "");
  EXPECT_EQ(broken("<child>arm</child>", "<child>arm</child><sensor name='s' type='force_torque'/>"), "");
}

TEST_F(SdfCheck, ourOwnElementsStandWhereTheyHaveAMeaning) {
  EXPECT_THAT(
      broken("<robotcontrol:servo>", "<robotcontrol:serwo>1</robotcontrol:serwo><robotcontrol:servo>"),
      "m.sdf:23: small/hip: there is no <robotcontrol:serwo>");
  EXPECT_THAT(broken("<child>arm</child>", "<child>arm</child><robotcontrol:ball>true</robotcontrol:ball>"),
              HasSubstr("<robotcontrol:ball> has no meaning in <joint>"));
}

TEST_F(SdfCheck, whatOurElementsCannotSayIsLeftOutWhereThereIsAMeaningWithoutIt) {
  EXPECT_EQ(broken("_position>0.5<", "_position>half<"),
            "23 left out: small/hip: <robotcontrol:initial_position>: must be one finite number");
}

TEST_F(SdfCheck, valuesHaveTheirTypes) {
  EXPECT_EQ(broken("<mass>1.5", "<mass>heavy"),
            "m.sdf:7: small/foot: <mass> must be one finite number, not 'heavy'");
  EXPECT_EQ(broken("<mass>1.5", "<mass>nan"),
            "m.sdf:7: small/foot: <mass> must be one finite number, not 'nan'");
  EXPECT_EQ(broken("<xyz>0 0 1", "<xyz>0 0"),
            "m.sdf:22: small/hip: <xyz> must be 3 finite numbers, not '0 0'");
  EXPECT_EQ(broken("0 0 0.1 0 0 0", "0 0 inf 0 0 0"),
            "m.sdf:14: small/arm: <pose> must be 6 finite numbers, not '0 0 inf 0 0 0'");
  EXPECT_EQ(broken("<link name=\"foot\">", "<static>maybe</static><link name=\"foot\">"),
            "m.sdf:5: small: <static> must be true or false, not 'maybe'");
}

TEST_F(SdfCheck, attributesHaveTheirTypesToo) {
  const std::string pose = "<pose relative_to=\"foot\">0 0 0.1 0 0 0</pose>";
  const auto with = [&](const std::string& attribute, const std::string& numbers) {
    return broken(pose, "<pose " + attribute + ">" + numbers + "</pose>");
  };
  EXPECT_EQ(with("rotation_format='euler_rpy' degrees='true'", "0 0 0.1 0 0 90"), "");
  EXPECT_EQ(with("rotation_format='quat_xyzw'", "0 0 0.1 0 0 0 1"), "");
  EXPECT_EQ(with("rotation_format='yard'", "0 0 0.1 0 0 0"),
            "m.sdf:14: small/arm: the attribute 'rotation_format' of <pose> must be euler_rpy or quat_xyzw, "
            "not 'yard'");
  EXPECT_EQ(with("degrees='90'", "0 0 0.1 0 0 0"),
            "m.sdf:14: small/arm: the attribute 'degrees' of <pose> must be true or false, not '90'");
  EXPECT_THAT(with("degrees='" + std::string(5000, 'x') + "'", "0 0 0.1 0 0 0"), testing::SizeIs(Lt(200)));
}

TEST_F(SdfCheck, onlyAPoseWithAQuaternionHasSevenNumbers) {
  const std::string pose = "<pose relative_to=\"foot\">0 0 0.1 0 0 0</pose>";
  EXPECT_THAT(broken(pose, "<pose>0 0 0.1 0 0 0 1</pose>"), HasSubstr("must be 6 finite numbers"));
  EXPECT_THAT(broken(pose, "<pose rotation_format='quat_xyzw'>0 0 0.1 0 0 0</pose>"),
              HasSubstr("must be 7 finite numbers"));
}

TEST_F(SdfCheck, onlyLimitsMayBeInfinite) {
  EXPECT_EQ(broken("<lower>-1", "<lower>-inf"), "");
  EXPECT_THAT(broken("<mass>1.5", "<mass>inf"), StartsWith("m.sdf:7: "));
}

TEST_F(SdfCheck, jointsJoinLinksThatExist) {
  EXPECT_EQ(broken("<child>arm<", "<child>leg<"),
            "m.sdf:21: small/hip: the joint 'hip' has as its child 'leg', which is not a link of the model");
  EXPECT_EQ(broken("<child>arm</child>", ""), "m.sdf:19: small/hip: the joint 'hip' has no <child>");
  EXPECT_EQ(broken("<parent>foot<", "<parent>world<"), "");
  EXPECT_EQ(broken("<child>arm<", "<child>world<"), "");
}

TEST_F(SdfCheck, namesStandOnce) {
  EXPECT_THAT(broken("<link name=\"arm\">", "<link name=\"foot\">"),
              StartsWith("m.sdf:13: small/foot: the name 'foot' appears here twice"));
  EXPECT_EQ(broken("<joint name=\"hip\"", "<joint name=\"foot\""),
            "m.sdf:19: small/foot: the name 'foot' appears here twice");
}

TEST_F(SdfCheck, aModelHasAtMostFiveThousandFrames) {
  std::string frames;
  for (int i = 0; i < 5000; ++i) frames += "<frame name='f" + std::to_string(i) + "'/>";
  EXPECT_EQ(
      broken("<joint", frames + "<joint"),
      "m.sdf:3: small: there are 5003 links, joints and frames here; at most 5000 can be in one <model>");
  EXPECT_EQ(errorsOf("<sdf version='1.9'><world name='w'>" + frames + "</world></sdf>"), "");
}

TEST_F(SdfCheck, bodiesThatCannotBeAreRefused) {
  EXPECT_EQ(broken("<mass>1.5", "<mass>-1.5"),
            "m.sdf:7: small/foot: <mass> must be between 0 and 1e+09 kg, not -1.5");
  EXPECT_THAT(broken("<mass>1.5", "<mass>1e30"), HasSubstr("m.sdf:7: small/foot: <mass> must be between"));
  EXPECT_EQ(broken("<ixx>0.1", "<ixx>5"),
            "8 left out: small/foot: <inertia>: no body has such moments: ixx exceeds the sum of the other "
            "two; they are used "
            "as they are");
  EXPECT_EQ(broken("<size>0.1 0.1 0.1", "<size>0.1 0 0.1"),
            "m.sdf:10: small/foot/sole: <size> must be between 1e-06 and 100000 m, not 0");
  EXPECT_EQ(broken("<radius>0.02", "<radius>1e9"),
            "m.sdf:16: small/arm/hand: <radius> must be between 1e-06 and 100000 m, not 1e+09");
  EXPECT_EQ(broken("<box><size>0.1 0.1 0.1</size></box>", ""),
            "m.sdf:10: small/foot/sole: 'sole' has no shape in its <geometry>");
}

TEST_F(SdfCheck, otherFilesAndVersionsAreRefused) {
  EXPECT_EQ(errorsOf("<html/>"), "m.sdf:1: this is not an SDFormat file: its root is not <sdf>, but <html>");
  EXPECT_EQ(broken("version=\"1.9\"", "version=\"3.7\""),
            "m.sdf:2: the version must be 1.9, or another one from 1.2 to 1.12, not '3.7'");
  EXPECT_EQ(broken("version=\"1.9\"", "version=\"1.7\""), "");
}

}  // namespace
}  // namespace simcore
