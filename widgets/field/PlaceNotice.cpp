// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/PlaceNotice.h"

#include <QCoreApplication>

#include "robotcontrol/Driving.pb.h"
#include "widgets/world/RobotBeliefs.h"

namespace widgets {
namespace {

/// m; robots plan no paths while their pose is less certain than this.
constexpr double kLost = 1;

struct PlaceText {
  Q_DECLARE_TR_FUNCTIONS(PlaceNotice)
};

}  // namespace

QString placeNotice(const RobotBelief& robot, const robotcontrol::DriveState* base, bool onMap) {
  const QString name = QString::fromStdString(robot.robot);
  if (robot.estimate && robot.positionDeviation <= kLost) return {};
  if (base == nullptr && !robot.estimate) return {};  // without any report other views say what to do
  if (!onMap) {
    return robot.truth
               ? QString()
               : PlaceText::tr(
                     "%1 has no map for localization: connect it again, and choose a map in the dialog (menu "
                     "Robot, Connect a Pioneer…); a program that runs elsewhere is started with --map.")
                     .arg(name);
  }
  if (base != nullptr && base->emergency_stop())
    return PlaceText::tr(
               "%1 is not localized yet, and is stopped: release its stop button or STOP, so that it "
               "can drive around.")
        .arg(name);
  if (base != nullptr && !base->motors_on())
    return PlaceText::tr(
               "%1 is not localized yet: switch its motors on (Robot state), then send it anywhere "
               "(G, and a click on the map). It drives around until it has localized itself.")
        .arg(name);
  return PlaceText::tr(
             "%1 is not localized yet: send it anywhere (G, and a click on the map), and it drives "
             "around until it has localized itself; or steer it with the motion tester.")
      .arg(name);
}

}  // namespace widgets
