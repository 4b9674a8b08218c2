// SPDX-License-Identifier: GPL-3.0-or-later
// How objects are added to a scene file, renamed and removed; XmlTextTest has how they are found.
#include "widgets/sceneedit/SceneFileObjects.h"

#include <gtest/gtest.h>

namespace widgets::test {
namespace {

std::string without(const char* text, const char* path) {
  const QString scene = QString::fromUtf8(text);
  return withoutObject(scene, findSceneObject(scene, QString::fromUtf8(path)).object).toStdString();
}

std::string renamedTo(const char* element, const char* name) {
  return renamedObject(QString::fromUtf8(element), QString::fromUtf8(name)).toStdString();
}

std::vector<std::string> pathsIn(const char* text) {
  std::vector<std::string> paths;
  for (const SceneObject& object : sceneObjects(QString::fromUtf8(text)))
    paths.push_back(object.path.toStdString());
  return paths;
}

using Paths = std::vector<std::string>;

TEST(SceneObjects, anObjectIsRemovedWithTheLinesThatOnlyItWasIn) {
  EXPECT_EQ(
      without("<world>\n  <model name=\"a\">\n    <link/>\n  </model>  \n  <light name=\"b\"/>\n</world>",
              "a"),
      "<world>\n  <light name=\"b\"/>\n</world>");
  EXPECT_EQ(without("<light name=\"a\"/>\n<light name=\"b\"/>", "a"), "<light name=\"b\"/>");
  EXPECT_EQ(without("<light name=\"a\"/>\n\t<light name=\"b\"/>", "b"), "<light name=\"a\"/>\n");
}

TEST(SceneObjects, whatSharesALineWithAnObjectStays) {
  EXPECT_EQ(without("<world>\n  <light name=\"a\"/> <!-- new -->\n</world>", "a"),
            "<world>\n   <!-- new -->\n</world>");
  EXPECT_EQ(without("<world><light name=\"a\"/><light name=\"b\"/></world>", "b"),
            "<world><light name=\"a\"/></world>");
}

TEST(SceneObjects, onlyTheOutermostObjectIsRenamed) {
  EXPECT_EQ(renamedTo("<model name=\"a\"><link name=\"a\"/></model>", "b"),
            "<model name=\"b\"><link name=\"a\"/></model>");
  EXPECT_EQ(renamedTo("<joint type='fixed' name = 'neck'><parent>a</parent></joint>", "n"),
            "<joint type='fixed' name = \"n\"><parent>a</parent></joint>");
}

TEST(SceneObjects, anIncludeIsRenamedByItsElement) {
  EXPECT_EQ(renamedTo("<include><uri>model://p3at</uri><name>old</name></include>", "new"),
            "<include><uri>model://p3at</uri><name>new</name></include>");
  EXPECT_EQ(renamedTo("<include><uri>model://p3at</uri></include>", "new"),
            "<include><name>new</name><uri>model://p3at</uri></include>");
  EXPECT_EQ(renamedTo("<include><plugin><name>p</name></plugin><name>old</name></include>", "new"),
            "<include><plugin><name>p</name></plugin><name>new</name></include>");
}

TEST(SceneObjects, whatHasNoNameIsNotRenamed) {
  EXPECT_EQ(renamedTo("<model><link name=\"a\"/></model>", "b"), "<model><link name=\"a\"/></model>");
  EXPECT_EQ(renamedTo("no element", "b"), "no element");
  EXPECT_EQ(renamedTo("<model filename=\"a\"/>", "b"), "<model filename=\"a\"/>");
}

TEST(SceneObjects, namesAreEscaped) {
  EXPECT_EQ(renamedTo("<model name=\"a\"/>", "a<b & \"c\""), "<model name=\"a&lt;b &amp; &quot;c&quot;\"/>");
  const QString added =
      withInclude(QStringLiteral("<world>\n</world>"), QStringLiteral("a&b"), QStringLiteral("x>y"), nullptr);
  EXPECT_TRUE(added.contains(QStringLiteral("<uri>a&amp;b</uri>\n      <name>x&gt;y</name>")))
      << added.toStdString();
}

TEST(SceneObjects, elementsAreAddedAtTheEndOfTheModelIfThereIsNoWorld) {
  const QString text =
      QStringLiteral("<sdf>\n  <model name=\"a\">\n    <link name=\"l\"/>\n  </model>\n</sdf>");
  int position = 0;
  const QString added = withElements(text, QStringLiteral("    <link name=\"m\"/>\n"), &position);
  EXPECT_EQ(
      added.toStdString(),
      "<sdf>\n  <model name=\"a\">\n    <link name=\"l\"/>\n    <link name=\"m\"/>\n  </model>\n</sdf>");
  EXPECT_TRUE(added.mid(position).startsWith(QStringLiteral("<link name=\"m\"/>")));
}

TEST(SceneObjects, theWorldComesBeforeItsModels) {
  const QString text = QStringLiteral("<sdf><world>\n<model name=\"a\">\n</model>\n</world></sdf>");
  EXPECT_EQ(withElements(text, QStringLiteral("<light/>\n"), nullptr).toStdString(),
            "<sdf><world>\n<model name=\"a\">\n</model>\n<light/>\n</world></sdf>");
}

TEST(SceneObjects, aWorldInOneLineGetsLines) {
  int position = 0;
  const QString added =
      withElements(QStringLiteral("<world><light/></world>"), QStringLiteral("  <light/>\n"), &position);
  EXPECT_EQ(added.toStdString(), "<world><light/>\n  <light/>\n</world>");
  EXPECT_EQ(added.mid(position, 8).toStdString(), "<light/>");
}

TEST(SceneObjects, anEmptyWorldIsFilledButNotOneWithoutAnEnd) {
  const QString xml = QStringLiteral("<light/>\n");
  EXPECT_EQ(withElements(QStringLiteral("<world name=\"w\"></world>"), xml, nullptr).toStdString(),
            "<world name=\"w\">\n<light/>\n</world>");
  for (const char* text : {"<sdf><world name=\"w\"/></sdf>", "<sdf><world name=\"w\">", ""})
    EXPECT_EQ(withElements(QString::fromUtf8(text), xml, nullptr).toStdString(), text);
}

TEST(SceneObjects, objectsInOnesWithoutANameBelongToWhatIsAround) {
  EXPECT_EQ(pathsIn("<model name=\"m\"><link><visual name=\"v\"/></link></model>"), (Paths{"m", "m/v"}));
  EXPECT_EQ(pathsIn("<include><pose>0</pose></include><model name=\"m\"/>"), (Paths{"m"}));
}

TEST(SceneObjects, anIncludeIsCalledAfterItsUriUnlessItHasAName) {
  EXPECT_EQ(pathsIn("<include><uri> model://robots/p3at </uri></include>"), (Paths{"p3at"}));
  EXPECT_EQ(pathsIn("<include><uri>p3at</uri><name> rover </name></include>"), (Paths{"rover"}));
}

TEST(SceneObjects, whatIsBeingTypedHasItsObjectsAlready) {
  EXPECT_EQ(pathsIn("<world><model name=\"a\"><link name=\"b\"><visual name=\"c\""),
            (Paths{"a", "a/b", "a/b/c"}));
}

TEST(SceneObjects, theInnermostObjectIsAtAPosition) {
  const QString text = QStringLiteral("<model name=\"a\"><pose/><link name=\"b\"> </link></model> ");
  const auto at = [&](const char* part) {
    const auto object = sceneObjectAt(text, text.indexOf(QLatin1String(part)));
    return object ? object->path.toStdString() : std::string("none");
  };
  EXPECT_EQ(at("<model"), "a");
  EXPECT_EQ(at("<pose"), "a");
  EXPECT_EQ(at("> </link"), "a/b");
  EXPECT_EQ(at("</model"), "a");
  EXPECT_FALSE(sceneObjectAt(text, text.size() - 1));
  EXPECT_FALSE(sceneObjectAt(text, -1));
}

TEST(SceneObjects, aFreeNameHasTheFirstFreeNumber) {
  const QString text = QStringLiteral(
      "<world><model name=\"box\"><link name=\"ball\"/></model><model name=\"box2\"/><light name=\"box4\"/>"
      "</world>");
  const auto freeName = [&](const char* name) {
    return freeObjectName(text, QString::fromUtf8(name)).toStdString();
  };
  EXPECT_EQ(freeName("box"), "box3");
  EXPECT_EQ(freeName("box2"), "box22");
  EXPECT_EQ(freeName("ball"), "ball") << "a link's name is its model's affair";
}

TEST(SceneObjects, aPathToNothingFindsNothing) {
  const QString text = QStringLiteral("<model name=\"a\"><link name=\"b\"/></model>");
  for (const char* path : {"", "/", "a/", "b", "a/c", "link:a", "a/joint:b"})
    EXPECT_TRUE(findSceneObject(text, QString::fromUtf8(path)).object.path.isEmpty()) << path;
  EXPECT_TRUE(findSceneObject({}, QStringLiteral("a"), QStringLiteral("a")).object.path.isEmpty());
}

}  // namespace
}  // namespace widgets::test
