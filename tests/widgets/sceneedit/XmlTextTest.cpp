// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/XmlText.h"

#include <gtest/gtest.h>

#include "widgets/sceneedit/SceneFileObjects.h"
#include "widgets/sceneedit/XmlPlace.h"

namespace widgets {
namespace {

QStringList words(const char* text) {
  return QString::fromLatin1(text).split(QLatin1Char(' '));
}

/// A text with '|' where the cursor is.
struct Cursor {
  explicit Cursor(const char* marked) : text(QString::fromUtf8(marked)) {
    position = text.indexOf(QLatin1Char('|'));
    text.remove(position, 1);
  }
  XmlPlace place() const { return xmlPlaceAt(text, position); }
  QString text;
  int position = 0;
};

using Kind = XmlPlace::Kind;

TEST(XmlTextTest, aTagThatIsNotCompleteEndsAtTheNextOne) {
  const auto tags = xmlTags(QStringLiteral("<a x=\"1\"><b <c/></a><!-- <d> --><e y='>'>"));
  ASSERT_EQ(tags.size(), 6U);
  EXPECT_EQ(tags[1].name, QStringLiteral("b"));
  EXPECT_FALSE(tags[1].isComplete);
  EXPECT_EQ(tags[2].kind, XmlTag::Kind::kEmpty);
  EXPECT_EQ(tags[3].kind, XmlTag::Kind::kClosing);
  EXPECT_EQ(tags[4].kind, XmlTag::Kind::kOther);
  EXPECT_TRUE(tags[5].isComplete);
}

TEST(XmlTextTest, attributesAreReadWithEitherQuotes) {
  const QString text = QStringLiteral("<a one=\"1 2\" two='x' three");
  const auto attributes = xmlAttributes(text, xmlTags(text).front());
  EXPECT_EQ(attributes.size(), 2);
  EXPECT_EQ(attributes[QStringLiteral("one")], QStringLiteral("1 2"));
  EXPECT_EQ(attributes[QStringLiteral("two")], QStringLiteral("x"));
}

TEST(XmlTextTest, aClosingTagClosesWhatIsOpenInItsElement) {
  const auto elements = xmlElements(QStringLiteral("<a><b><c></a></x><d/>"));
  ASSERT_EQ(elements.size(), 4U);
  EXPECT_TRUE(elements[0].isClosed);
  EXPECT_FALSE(elements[1].isClosed);
  EXPECT_EQ(elements[2].parent, 1);
  EXPECT_EQ(elements[3].parent, -1);
}

TEST(XmlTextTest, aPlaceInTextKnowsWhatIsAroundIt) {
  const Cursor cursor("<sdf><world name=\"w\"><model>|</model></world></sdf>");
  EXPECT_EQ(cursor.place().kind, Kind::kText);
  EXPECT_EQ(cursor.place().path, words("sdf world model"));
}

TEST(XmlTextTest, aPlaceInATagKnowsItsWordAndItsAttributes) {
  EXPECT_EQ(Cursor("<sdf><|").place().kind, Kind::kTagName);
  EXPECT_EQ(Cursor("<sdf><wor|").place().prefix, QStringLiteral("wor"));
  EXPECT_EQ(Cursor("<sdf><wor|\n</sdf>").place().path, words("sdf"));
  const XmlPlace name = Cursor("<sdf><joint name=\"a\" ty|></sdf>").place();
  EXPECT_EQ(name.kind, Kind::kAttributeName);
  EXPECT_EQ(name.prefix, QStringLiteral("ty"));
  EXPECT_EQ(name.element, QStringLiteral("joint"));
  EXPECT_EQ(name.attributes, words("name"));
  const XmlPlace value = Cursor("<joint name=\"a\" type=\"rev|\">").place();
  EXPECT_EQ(value.kind, Kind::kAttributeValue);
  EXPECT_EQ(value.attribute, QStringLiteral("type"));
  EXPECT_EQ(value.prefix, QStringLiteral("rev"));
  EXPECT_EQ(Cursor("<joint type=|>").place().kind, Kind::kElsewhere);
  EXPECT_EQ(Cursor("<a></|").place().kind, Kind::kClosingName);
  EXPECT_EQ(Cursor("<a><!-- <b |--></a>").place().kind, Kind::kElsewhere);
}

TEST(XmlTextTest, openingTagsGetTheirClosingOnes) {
  const Cursor open("<model><link>|</model>");
  EXPECT_EQ(closingTagFor(open.text, open.position), QStringLiteral("</link>"));
  const Cursor before("<model><link>|<link></link></model>");
  EXPECT_EQ(closingTagFor(before.text, before.position), QStringLiteral("</link>"));
  const Cursor closed("<model><link>|</link></model>");
  EXPECT_EQ(closingTagFor(closed.text, closed.position), QString());
  const Cursor empty("<model><link/>|</model>");
  EXPECT_EQ(closingTagFor(empty.text, empty.position), QString());
}

TEST(XmlTextTest, anElementEndsByTheClosingTagThatComesNext) {
  const Cursor open("<model><link>|");
  EXPECT_EQ(closingAt(open.text, open.position).name, QStringLiteral("link>"));
  EXPECT_EQ(closingAt(open.text, open.position).end, -1);
  const Cursor closed("<model><link>1|</link></model>");
  EXPECT_EQ(closingAt(closed.text, closed.position).end, 21);
  const Cursor other("<model><link>1|</model>");
  EXPECT_EQ(closingAt(other.text, other.position).end, -1);
  const Cursor below("<model>\n  |\n</model>");
  const XmlClosing closing = closingAt(below.text, below.position);
  EXPECT_EQ(closing.end, below.text.size());
  EXPECT_EQ(closing.blankBegin, 8);
  EXPECT_EQ(closing.blankEnd, 11);
  EXPECT_EQ(closingAt(QStringLiteral("a"), 1).name, QString());
}

TEST(XmlTextTest, aNewLineIsIndentedAfterWhatItIsIn) {
  const Cursor open("  <model>|");
  EXPECT_EQ(newLineAt(open.text, open.position).text, QStringLiteral("\n    "));
  const Cursor between("  <model>|</model>");
  EXPECT_EQ(newLineAt(between.text, between.position).text, QStringLiteral("\n    \n  "));
  EXPECT_EQ(newLineAt(between.text, between.position).back, 3);
  const Cursor after("  <mass>1</mass>|");
  EXPECT_EQ(newLineAt(after.text, after.position).text, QStringLiteral("\n  "));
}

TEST(XmlTextTest, allLinesAreIndentedButThoseInComments) {
  EXPECT_EQ(indentedXml(QStringLiteral("<a>\n<b>\n   <c>1</c>\n      </b>\n<!-- x\n y -->\n</a>\n")),
            QStringLiteral("<a>\n  <b>\n    <c>1</c>\n  </b>\n  <!-- x\n y -->\n</a>\n"));
}

const char* const kWorld =
    "<sdf><world name=\"w\"><light "
    "name=\"lamp\"/><include><uri>model://rover</uri><name>rover1</name></include>"
    "<include><uri>model://crate</uri></include>"
    "<model name=\"desk\"><link name=\"top\"><sensor name=\"eye\"/></link></model></world></sdf>";

TEST(SceneObjectsTest, objectsAreFoundByTheirPaths) {
  const QString text = QLatin1String(kWorld);
  const auto eye = findSceneObject(text, QStringLiteral("desk/top/eye"));
  EXPECT_EQ(text.mid(eye.object.begin, eye.object.end - eye.object.begin),
            QStringLiteral("<sensor name=\"eye\"/>"));
  EXPECT_EQ(findSceneObject(text, QStringLiteral("desk::top")).object.path, QStringLiteral("desk/top"));
  EXPECT_TRUE(findSceneObject(text, QStringLiteral("desk/bottom")).object.path.isEmpty());
}

TEST(SceneObjectsTest, whatAnIncludedModelHasIsInItsFile) {
  const QString text = QLatin1String(kWorld);
  const auto camera = findSceneObject(text, QStringLiteral("rover1/head/camera"));
  EXPECT_EQ(camera.object.uri, QStringLiteral("model://rover"));
  EXPECT_EQ(camera.rest, QStringLiteral("head/camera"));
  EXPECT_TRUE(findSceneObject(text, QStringLiteral("rover1")).rest.isEmpty());
  EXPECT_EQ(findSceneObject(text, QStringLiteral("crate/lid")).rest, QStringLiteral("lid"));
}

TEST(SceneObjectsTest, objectsAreFoundAsTheViewsOfTheSceneCallThem) {
  const QString text = QStringLiteral(
      "<sdf><model name=\"m\"><link name=\"neck\"><collision name=\"skin\"/><visual name=\"skin\"/>"
      "<sensor name=\"eye\" type=\"camera\"/></link><joint name=\"neck\"/></model></sdf>");
  for (const SceneObject& object : sceneObjects(text))
    EXPECT_EQ(findSceneObject(text, object.selection).object.begin, object.begin)
        << object.selection.toStdString();
  EXPECT_EQ(sceneObjects(text)[4].selection, QStringLiteral("m/eye/image"));
  EXPECT_EQ(findSceneObject(text, QStringLiteral("m/joint:neck")).object.element, QStringLiteral("joint"));
  EXPECT_EQ(findSceneObject(text, QStringLiteral("m/link:neck/solid:skin")).object.element,
            QStringLiteral("collision"));
  EXPECT_EQ(findSceneObject(text, QStringLiteral("m/neck/position")).object.name, QStringLiteral("neck"));
}

TEST(SceneObjectsTest, theFilesOwnModelIsKnownAsAnInstance) {
  const QString text = QStringLiteral("<sdf><model name=\"rover\"><link name=\"head\"/></model></sdf>");
  EXPECT_EQ(findSceneObject(text, QStringLiteral("rover1/head"), QStringLiteral("rover1")).object.path,
            QStringLiteral("rover/head"));
  const int at = text.indexOf(QLatin1String("<link")) + 2;
  EXPECT_EQ(sceneObjectAt(text, at, QStringLiteral("rover1"))->path, QStringLiteral("rover1/head"));
  EXPECT_EQ(sceneObjectAt(text, at, QStringLiteral("rover1"))->selection, QStringLiteral("rover1/link:head"));
  EXPECT_EQ(sceneObjectAt(text, at)->path, QStringLiteral("rover/head"));
  EXPECT_FALSE(sceneObjectAt(text, 2).has_value());
}

TEST(SceneObjectsTest, anIncludeIsAddedBeforeTheEndOfTheWorld) {
  const QString text = QStringLiteral("<sdf>\n  <world name=\"w\">\n  </world>\n</sdf>\n");
  int position = 0;
  const QString added =
      withInclude(text, QStringLiteral("model://rover"), QStringLiteral("rover"), &position);
  EXPECT_EQ(added,
            QStringLiteral("<sdf>\n  <world name=\"w\">\n    <include>\n      <uri>model://rover</uri>\n"
                           "      <name>rover</name>\n      <pose>0 0 0 0 0 0</pose>\n    </include>\n"
                           "  </world>\n</sdf>\n"));
  EXPECT_TRUE(added.mid(position).startsWith(QStringLiteral("<include>")));
  EXPECT_EQ(withInclude(QStringLiteral("<sdf/>"), {}, {}, nullptr), QStringLiteral("<sdf/>"));
  EXPECT_EQ(freeObjectName(added, QStringLiteral("rover")), QStringLiteral("rover2"));
  EXPECT_EQ(freeObjectName(added, QStringLiteral("crate")), QStringLiteral("crate"));
}

}  // namespace
}  // namespace widgets
