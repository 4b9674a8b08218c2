// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/SceneRename.h"

#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonObject>

#include "robotcontrol/World.pb.h"

namespace widgets {
namespace {

using robotcontrol::WorldObject;
using robotcontrol::WorldObjects;

void add(WorldObjects& to, const char* path, WorldObject::Kind kind, const char* type) {
  auto& object = *to.add_objects();
  object.set_path(path);
  object.set_name(path);
  object.set_kind(kind);
  auto& property = *object.add_properties();
  property.set_name("type");
  property.set_text(type);
  auto& link = *to.add_objects();
  link.set_path(std::string(path) + "/link:body");
  link.set_parent(path);
}

WorldObjects withModel(const char* name, const char* type = "ball") {
  WorldObjects objects;
  add(objects, "room", WorldObject::MODEL, "room");
  add(objects, name, WorldObject::MODEL, type);
  return objects;
}

TEST(SceneRename, theOnlyObjectWithAnotherNameWasRenamed) {
  EXPECT_EQ(renameBetween(withModel("ball"), withModel("puck")), (SceneRename{"ball", "puck"}));
  EXPECT_EQ(renameBetween(withModel("ball"), withModel("ball")), std::nullopt);
  EXPECT_EQ(renameBetween(withModel("box", "box"), withModel("crate", "crate")),
            (SceneRename{"box", "crate"}))
      << "a model of the scene's own file";
}

TEST(SceneRename, whatComesAndGoesOrIsAnotherThingWasNot) {
  WorldObjects more = withModel("ball");
  add(more, "puck", WorldObject::MODEL, "ball");
  EXPECT_EQ(renameBetween(withModel("ball"), more), std::nullopt);
  EXPECT_EQ(renameBetween(more, withModel("ball")), std::nullopt);
  EXPECT_EQ(renameBetween(withModel("thing", "ball"), withModel("puck", "box")), std::nullopt);
  WorldObjects other = withModel("puck");
  other.set_file("other.sdf");
  EXPECT_EQ(renameBetween(withModel("ball"), other), std::nullopt);
}

TEST(SceneRename, comparisonsFollow) {
  EXPECT_EQ(withRename(QStringLiteral("robot:red1"), SceneRename{"red1", "rex"}),
            QStringLiteral("robot:rex"));
}

TEST(SceneRename, textsNameTheObjectAndItsParts) {
  const auto renamed = [](const char* text) {
    return withRename(QString::fromUtf8(text), SceneRename{"red1", "blue12"}).toStdString();
  };
  EXPECT_EQ(renamed("red1"), "blue12");
  EXPECT_EQ(renamed("red1/laser"), "blue12/laser");
  EXPECT_EQ(renamed("ports: readings[port=\"red1/a\"].x - red1/b: y"),
            "ports: readings[port=\"blue12/a\"].x - blue12/b: y");
  for (const char* other : {"red11/laser", "red12", "my red1", "team/red1/laser", "red1.x", "infrared1/x"})
    EXPECT_EQ(renamed(other), other);
}

TEST(SceneRename, statesOfViewsAreRenamedInDepth) {
  const QJsonObject state{{QStringLiteral("box"), QStringLiteral("box")},
                          {QStringLiteral("box/link:a"), 3},
                          {QStringLiteral("all"), QJsonArray{true, QStringLiteral("box/link:a")}}};
  const QJsonObject expected{{QStringLiteral("box"), QStringLiteral("crate")},
                             {QStringLiteral("crate/link:a"), 3},
                             {QStringLiteral("all"), QJsonArray{true, QStringLiteral("crate/link:a")}}};
  EXPECT_EQ(withRename(QJsonValue(state), SceneRename{"box", "crate"}).toObject(), expected);
}

}  // namespace
}  // namespace widgets
