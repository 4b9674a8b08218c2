// SPDX-License-Identifier: GPL-3.0-or-later
// Drives in models: what is read, and what is refused.
#include <gmock/gmock.h>

#include "simcore/physics/shapes/DriveGeometry.h"
#include "simcore/physics/shapes/LumpedLink.h"
#include "simcore/sdf/SceneFiles.h"
#include "simcore/sdf/SdfReader.h"
#include "simcore/sdf/SdfSpec.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using testing::HasSubstr;

/// A cart of two wheels of 10 cm, 40 cm apart; the left wheel's joint looks to the right.
const char* const kSdfCart = R"(<sdf version="1.9" xmlns:robotcontrol="urn:robotcontrol:sdf">
<model name="cart">
<robotcontrol:drive name="motors">
<robotcontrol:left>l</robotcontrol:left>
<robotcontrol:right>r</robotcontrol:right>
<robotcontrol:track>0.4</robotcontrol:track>
<robotcontrol:idle_torque>0.5</robotcontrol:idle_torque>
</robotcontrol:drive>
<link name="body"><pose>0 0 0.2 0 0 0</pose>
<inertial><mass>4</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>
<collision name="box"><pose>0.1 0 0 0 0 0</pose><geometry><box><size>0.6 0.3 0.1</size></box></geometry></collision>
</link>
<link name="wheelL"><pose>0 0.2 0.1 0 0 0</pose>
<inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial>
<collision name="tyre"><pose>0 0 0 1.570796 0 0</pose><geometry><cylinder><radius>0.1</radius><length>0.05</length></cylinder></geometry></collision>
</link>
<link name="wheelR"><pose>0 -0.2 0.1 0 0 0</pose>
<inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial>
<collision name="tyre"><pose>0 0 0 1.570796 0 0</pose><geometry><cylinder><radius>0.1</radius><length>0.05</length></cylinder></geometry></collision>
</link>
<joint name="l" type="continuous"><parent>body</parent><child>wheelL</child>
<axis><xyz>0 -1 0</xyz><limit><velocity>8</velocity><effort>2</effort></limit></axis></joint>
<joint name="r" type="continuous"><parent>body</parent><child>wheelR</child>
<axis><xyz>0 1 0</xyz><limit><velocity>9</velocity><effort>3</effort></limit></axis></joint>
</model>
</sdf>
)";

struct Reading {
  std::shared_ptr<const ModelDescription> model;
  std::string errors;
};

Reading read(const std::string& text) {
  const SceneFolder folder;
  const std::filesystem::path file = folder.write("m.sdf", text);
  robotlink::Errors errors;
  const SceneFiles files(file, {}, {}, SdfSpec::shared(), errors);
  LeftOuts leftOut;
  MeshFiles meshes;
  Reading result;
  if (errors.empty())
    result.model =
        readSdfModel(*files.model(file), "m.sdf", {files, SdfSpec::shared(), meshes, errors, leftOut});
  for (robotlink::Error& error : errors) error.where.file = "m.sdf";
  result.errors = describe(errors);
  return result;
}

std::string errorsWith(const std::string& from, const std::string& to) {
  return read(replaced(kSdfCart, from, to)).errors;
}

TEST(SdfDrive, aDriveHasItsWheelsAndTheLeastOfTheirLimits) {
  const Reading cart = read(kSdfCart);
  ASSERT_EQ(cart.errors, "");
  const DriveDescription& drive = *cart.model->drive;
  EXPECT_EQ(drive.name, "motors");
  ASSERT_EQ(drive.left.size(), 1U);
  EXPECT_EQ(cart.model->joints[static_cast<std::size_t>(drive.left[0])].name, "l");
  EXPECT_TRUE(cart.model->joints[0].wheel);
  EXPECT_NEAR(drive.wheelRadius, 0.1, 1e-12);
  EXPECT_NEAR(drive.track, 0.4, 1e-12);
  EXPECT_NEAR(drive.maximumSpeed, 0.8, 1e-12);
  EXPECT_NEAR(drive.maximumForce, 20, 1e-9);
  EXPECT_NEAR(drive.idleForce, 5, 1e-9);
}

TEST(SdfDrive, whatIsWrongWithADriveIsReportedWithItsLine) {
  EXPECT_EQ(errorsWith("left>l<", "left>x<"),
            "m.sdf:4: cart/motors: the model has no joint 'x' for its drive");
  EXPECT_EQ(
      errorsWith("<robotcontrol:left>l</robotcontrol:left>", ""),
      "m.sdf:3: cart/motors: a drive needs a wheel on each side: <robotcontrol:left>, <robotcontrol:right>");
  EXPECT_THAT(errorsWith("right>r<", "right>l<"),
              HasSubstr("m.sdf:5: cart/motors: 'l' cannot be a wheel's joint: it is named twice"));
  EXPECT_THAT(errorsWith("\"r\" type=\"continuous\"", "\"r\" type=\"fixed\""),
              HasSubstr("it must turn freely, without a servo"));
  EXPECT_THAT(errorsWith("<parent>body<", "<parent>world<"),
              HasSubstr("it must be fixed to a link of the model"));
  EXPECT_THAT(errorsWith("<cylinder><radius>0.1</radius><length>0.05</length></cylinder>",
                         "<sphere><radius>0.1</radius></sphere>"),
              HasSubstr("a wheel has one <collision>, a cylinder"));
  EXPECT_THAT(errorsWith("<pose>0 0 0 1.570796 0 0</pose>", ""),
              HasSubstr("must be around the joint's axis"));
  EXPECT_THAT(errorsWith("<radius>0.1<", "<radius>0.12<"),
              HasSubstr("a drive's wheels must be of one radius"));
  EXPECT_THAT(errorsWith("<parent>body</parent><child>wheelR<", "<parent>wheelL</parent><child>wheelR<"),
              HasSubstr("nothing may be joined to a wheel"));
  EXPECT_THAT(errorsWith("<effort>2</effort>", ""), HasSubstr("a wheel's <effort> must be between"));
  EXPECT_THAT(errorsWith("<velocity>8</velocity>", ""), HasSubstr("a wheel's <velocity> must be between"));
  EXPECT_THAT(errorsWith("track>0.4<", "track>0<"),
              HasSubstr("m.sdf:3: cart/motors: a drive's track must be between 0.01 and 10"));
  EXPECT_THAT(errorsWith("track>0.4<", "track>far<"),
              HasSubstr("m.sdf:6: cart/motors: <robotcontrol:track> must be one finite number"));
  EXPECT_EQ(errorsWith("idle_torque>0.5<", "idle_torque>-1<"), "") << "without one it is 0";
  EXPECT_THAT(errorsWith("<model name=\"cart\">", "<model name=\"cart\"><static>true</static>"),
              HasSubstr("a static model has no drive"));
}

TEST(SdfDrive, aTrackThatWheelsCannotHaveIsRefused) {
  // Four wheels turn about more than their distance.
  std::string text = replaced(kSdfCart, "<pose>0 0.2 0.1 0 0 0</pose>", "<pose>0.3 0.2 0.1 0 0 0</pose>");
  EXPECT_THAT(read(text).errors, HasSubstr("cannot turn the model with that track"));
  text = replaced(text, "track>0.4<", "track>0.6<");
  EXPECT_EQ(read(text).errors, "");
  EXPECT_THAT(read(replaced(text, "<pose>0 -0.2 0.1 0 0 0</pose>", "<pose>0.3 0.2 0.1 0 0 0</pose>")).errors,
              HasSubstr("cannot turn the model with that track"))
      << "both on one side";
}

TEST(SdfDrive, itsGeometryFollowsFromTheWheels) {
  const DriveGeometry geometry = driveGeometry(*read(kSdfCart).model);
  EXPECT_LT((geometry.center - Vector3(0, 0, 0.1)).norm(), 1e-9);
  EXPECT_LT((geometry.toLeft - Vector3(0, 1, 0)).norm(), 1e-9);
  EXPECT_EQ(geometry.slipRatio, 1) << "on one axle nothing slips";
  EXPECT_NEAR(geometry.footprint.center.x(), 0.1, 1e-9);
  EXPECT_NEAR(geometry.footprint.center.y(), 0, 1e-9);
  EXPECT_NEAR(geometry.footprint.halfLength, 0.3, 1e-9);
  EXPECT_NEAR(geometry.footprint.halfWidth, 0.15, 1e-9);
  EXPECT_GE(geometry.radius, std::hypot(0.4, 0.15));
  EXPECT_LT(geometry.radius, std::hypot(0.4, 0.15) * 1.01);
  // The balance of OdeWheels.h.
  EXPECT_NEAR(slipRatioFor(2 * (0.2 + 1.5 * 0.01 / 0.2), 0.1, 0.2), 1.5, 1e-9);
}

TEST(SdfDrive, wheelsStandWhereTheirCylindersAreWhereverTheirLinksHaveTheirOrigins) {
  const DriveGeometry usual = driveGeometry(*read(kSdfCart).model);
  // The same cart, its wheels' links with their origins in the cart's middle and turned.
  std::string text = replaced(kSdfCart, "<pose>0 0.2 0.1 0 0 0</pose>", "<pose>0 0 0.1 -1.570796 0 0</pose>");
  text = replaced(text, "<inertial><mass>1</mass>", "<inertial><pose>0 0 0.2 0 0 0</pose><mass>1</mass>");
  text = replaced(text, "<pose>0 0 0 1.570796 0 0</pose>", "<pose>0 0 0.2 0 0 0</pose>");
  text = replaced(text, "<axis><xyz>0 -1 0</xyz>", "<axis><xyz>0 0 -1</xyz>");
  const Reading moved = read(text);
  ASSERT_EQ(moved.errors, "");
  const DriveGeometry geometry = driveGeometry(*moved.model);
  EXPECT_LT((geometry.center - usual.center).norm(), 1e-6);
  EXPECT_LT((geometry.toLeft - usual.toLeft).norm(), 1e-6);
  EXPECT_NEAR(geometry.slipRatio, usual.slipRatio, 1e-6);
  EXPECT_NEAR(geometry.radius, usual.radius, 1e-6);
}

TEST(SdfDrive, aDriveObeysAPioneersControllerUnlessItSaysThatItHasNone) {
  EXPECT_EQ(read(kSdfCart).model->drive->controller, "arcos");
  const char* const drive = "<robotcontrol:drive name=\"motors\"";
  EXPECT_EQ(
      read(replaced(kSdfCart, drive, std::string(drive) + " controller=\"none\"")).model->drive->controller,
      "");
  EXPECT_THAT(errorsWith(drive, std::string(drive) + " controller=\"pigeon\""),
              HasSubstr("m.sdf:3: cart/motors: a drive has the controller 'arcos' or 'none', not 'pigeon'"));
}

TEST(SdfDrive, wheelsAndTheirCarrierAreLumpedIntoOneBody) {
  const auto model = read(kSdfCart).model;
  const LinkDescription body = lumpedLink(*model, rigidParts(*model), 0);
  EXPECT_NEAR(body.mass, 6, 1e-12);
  // 4 kg at the link's origin, 2 kg 10 cm below.
  EXPECT_LT((body.centerOfMass - Vector3(0, 0, -1 / 30.0)).norm(), 1e-9);
  const double below = 1 / 30.0, above = 0.1 - below;
  EXPECT_NEAR(body.inertia(0, 0), 0.1 + 4 * below * below + 2 * (0.01 + above * above + 0.04), 1e-9);
  EXPECT_NEAR(body.inertia(1, 1), 0.1 + 4 * below * below + 2 * (0.01 + above * above), 1e-9);
  EXPECT_NEAR(body.inertia(2, 2), 0.1 + 2 * (0.01 + 0.04), 1e-9);
  EXPECT_TRUE(isWheel(*model, 1));
  EXPECT_FALSE(isWheel(*model, 0));
}

}  // namespace
}  // namespace simcore
