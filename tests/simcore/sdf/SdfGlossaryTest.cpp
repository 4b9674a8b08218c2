// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfGlossary.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "simcore/sdf/SdfOwnElements.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

const SdfGlossary& glossary() {
  static const SdfGlossary kGlossary;
  return kGlossary;
}

std::vector<std::string> namesIn(const SdfGlossary::Path& path) {
  std::vector<std::string> names;
  for (const SdfElementHelp& one : glossary().children(path)) names.push_back(one.name);
  return names;
}

TEST(SdfGlossaryTest, itSaysWhatMayBeInAWorldOrALink) {
  EXPECT_THAT(namesIn({}), testing::ElementsAre("sdf"));
  EXPECT_THAT(namesIn({"sdf", "world"}), testing::IsSupersetOf({"model", "light", "include", "gravity"}));
  EXPECT_THAT(namesIn({"sdf", "world", "model", "link"}),
              testing::IsSupersetOf({"pose", "inertial", "collision", "visual", "sensor"}));
  EXPECT_THAT(namesIn({"sdf", "nothing"}), testing::IsEmpty());
}

TEST(SdfGlossaryTest, aModelInAModelHasTheSameElements) {
  EXPECT_THAT(namesIn({"sdf", "world", "model", "model"}), testing::IsSupersetOf({"link", "joint", "pose"}));
}

TEST(SdfGlossaryTest, valuesAndAttributesHaveTypesAndExplanations) {
  const auto mass = glossary().element({"sdf", "model", "link", "inertial", "mass"});
  ASSERT_TRUE(mass.has_value());
  EXPECT_EQ(mass->type, "double");
  EXPECT_FALSE(mass->help.empty());
  EXPECT_EQ(mass->help.find('\n'), std::string::npos);
  const auto joint = glossary().element({"sdf", "model", "joint"});
  ASSERT_TRUE(joint.has_value());
  const auto type = std::ranges::find(joint->attributes, "type", &SdfAttribute::name);
  ASSERT_NE(type, joint->attributes.end());
  EXPECT_TRUE(type->required);
  EXPECT_THAT(type->help, testing::HasSubstr("revolute"));
}

TEST(SdfGlossaryTest, ourOwnElementsAreInItWhereTheyAreAllowed) {
  EXPECT_THAT(namesIn({"sdf", "model", "joint"}), testing::Contains("robotcontrol:servo"));
  EXPECT_THAT(namesIn({"sdf", "model", "joint", "robotcontrol:servo"}),
              testing::Contains("robotcontrol:initial_position"));
  EXPECT_FALSE(glossary().element({"sdf", "world", "robotcontrol:servo"}).has_value());
}

/// The text of a file that has all elements of our own that are allowed in `path`, whatever their values.
std::string textWithAllIn(SdfGlossary::Path path) {
  std::string inside;
  for (const SdfElementHelp& one : glossary().children(path)) {
    if (one.name.starts_with("robotcontrol:")) inside += "<" + one.name + "/>";
  }
  for (; !path.empty(); path.pop_back()) {
    const std::string space = path.back() == "sdf"
                                  ? " version='1.9' xmlns:robotcontrol='urn:robotcontrol:sdf'"
                                  : " name='" + path.back() + "' type='x'";
    inside = "<" + path.back() + space + ">" + inside + "</" + path.back() + ">";
  }
  return inside;
}

TEST(SdfGlossaryTest, theReaderKnowsAllOurElementsAtTheirPlaces) {
  const SceneFolder folder;
  const std::vector<SdfGlossary::Path> paths{{"sdf", "world"},
                                             {"sdf", "world", "include"},
                                             {"sdf", "world", "model"},
                                             {"sdf", "world", "model", "joint"},
                                             {"sdf", "world", "model", "link", "visual"},
                                             {"sdf", "world", "model", "link", "sensor"},
                                             {"sdf", "world", "model", "link", "sensor", "camera"}};
  for (const auto& path : paths) {
    const std::string errors = folder.errorsOf(textWithAllIn(path));
    EXPECT_THAT(errors, testing::Not(testing::HasSubstr("has no meaning in"))) << path.back();
    EXPECT_THAT(errors, testing::Not(testing::HasSubstr("there is no <robotcontrol"))) << path.back();
  }
}

TEST(SdfGlossaryTest, everyElementOfOurNamespaceIsExplainedWhereItMayBe) {
  for (const auto& [name, parent] : ownSdfElements()) {
    const auto help = glossary().element({"sdf", parent, name});
    ASSERT_TRUE(help.has_value()) << name << " in " << parent;
    EXPECT_FALSE(help->help.empty()) << name;
    const auto children = glossary().children({"sdf", parent});
    EXPECT_NE(std::ranges::find(children, name, &SdfElementHelp::name), children.end()) << name;
  }
}

}  // namespace
}  // namespace simcore
