// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/UserPackages.h"

#include <utility>

#include "robotlink/debugging/ColorTableInUse.h"
#include "robotlink/debugging/DebugContext.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Checksum.h"
#include "robotlink/packages/Conversions.h"

namespace robotlink {

using robotcontrol::Request;

struct UserPackages::Row {
  std::uint64_t (UserPackages::*send)(const Request& request);
  const AnySender& (UserPackages::*sender)() const;
  const char* use;
};

UserPackages::UserPackages(Process& process, DebugContext& debug, std::vector<std::string> joints)
    : process_(process),
      debug_(debug),
      remoteMotion_(process, kRemoteMotion.name, Blocking::kNo),
      colorTable_(process, kColorTable.name, Blocking::kNo),
      motions_(process, std::move(joints)),
      goal_(process, kDriveGoal.name, Blocking::kNo) {}

const UserPackages::Row* UserPackages::rowFor(const Request& request) {
  static constexpr RequestRow<Row> kRows[]{
      {Request::kMotion,
       {&UserPackages::sendRemoteMotion, &UserPackages::remoteMotionSender, "obeys remote motions"}},
      {Request::kSetColorTable,
       {&UserPackages::sendColorTable, &UserPackages::colorTableSender, "uses a color table"}},
      {Request::kSetMotion,
       {&UserPackages::sendMotionText, &UserPackages::motionTextSender, "plays key-frame motions"}},
      {Request::kSetGoal, {&UserPackages::sendGoal, &UserPackages::goalSender, "drives to goals"}}};
  const auto* row = rowOf(kRows, request.what_case());
  return row == nullptr ? nullptr : &row->handler;
}

bool UserPackages::has(const Request& request) {
  return rowFor(request) != nullptr;
}

const AnySender& UserPackages::senderFor(const Request& request) const {
  return (this->*rowFor(request)->sender)();
}

const char* UserPackages::useOf(const Request& request) {
  return rowFor(request)->use;
}

std::string UserPackages::whyNot(const Request& request) const {
  // A package that is repeated was accepted before, perhaps together with motions that are still to come.
  const bool isNewMotion = request.has_set_motion() && !isRepeated(request);
  return isNewMotion ? motions_.whyNot(request.set_motion().motion()) : "";
}

std::uint64_t UserPackages::send(const Request& request) {
  return (this->*rowFor(request)->send)(request);
}

std::uint64_t UserPackages::sendRemoteMotion(const Request& request) {
  auto motion = std::make_shared<robotcontrol::RemoteMotion>(request.motion());
  assign(*motion->mutable_timestamp(), process_.frameTime());
  remoteMotion_.send(std::move(motion));
  return 0;
}

/// A table without cells removes the one that was set.
std::uint64_t UserPackages::sendColorTable(const Request& request) {
  const robotcontrol::ColorTable& table = request.set_color_table().table();
  use(std::make_shared<robotcontrol::ColorTable>(table));
  if (!isRepeated(request))
    debug_.text(Level::kInfo, "colors", describeColorTable(robotlink::colorTableInUse(&table)));
  return checksum(table);
}

void UserPackages::use(std::shared_ptr<const robotcontrol::ColorTable> table) {
  colorTableInUse_ = table;
  colorTableDue_ = true;
  colorTable_.send(std::move(table));
}

/// A motion without a text takes back the one that was sent.
std::uint64_t UserPackages::sendMotionText(const Request& request) {
  const robotcontrol::MotionText& motion = request.set_motion().motion();
  motions_.set(motion, process_.frameTime());
  motionsDue_ = true;
  if (!isRepeated(request)) {
    debug_.text(Level::kInfo, "motion",
                "the motion '" + motion.name() + "' is now that " +
                    (motion.text().empty() ? "of the robot's files" : "which was sent"));
  }
  return 0;
}

std::uint64_t UserPackages::sendGoal(const Request& request) {
  auto goal = std::make_shared<robotcontrol::DriveGoal>(request.set_goal());
  assign(*goal->mutable_timestamp(), process_.frameTime());
  goal_.send(std::move(goal));
  return 0;
}

void UserPackages::offer(const PackagePtr& package) {
  if (dynamic_cast<const robotcontrol::RemoteMotion*>(package.get()) != nullptr) {
    remoteMotion_.send(std::static_pointer_cast<const robotcontrol::RemoteMotion>(package));
  } else if (const auto* table = dynamic_cast<const robotcontrol::ColorTable*>(package.get())) {
    if (!wrongWith(*table).empty()) return;
    use(std::static_pointer_cast<const robotcontrol::ColorTable>(package));
  } else if (const auto* motions = dynamic_cast<const robotcontrol::MotionTexts*>(package.get())) {
    motions_.add(*motions, process_.frameTime());
    motionsDue_ = true;
  } else if (dynamic_cast<const robotcontrol::DriveGoal*>(package.get()) != nullptr) {
    goal_.send(std::static_pointer_cast<const robotcontrol::DriveGoal>(package));
  }
}

std::optional<robotcontrol::ColorTable> UserPackages::colorTableInUse() const {
  if (!colorTable_.connected()) return std::nullopt;
  return robotlink::colorTableInUse(colorTableInUse_.get());
}

std::optional<robotcontrol::MotionTable> UserPackages::motions(
    const std::vector<robotcontrol::MotionText>& more) const {
  if (!motions_.sender().connected()) return std::nullopt;
  return motions_.table(more);
}

void UserPackages::publishChanged() {
  if (std::exchange(colorTableDue_, false)) {
    if (auto table = colorTableInUse())
      debug_.add<robotcontrol::ColorTable>(streams::kColorTableInUse) = std::move(*table);
  }
  if (std::exchange(motionsDue_, false)) {
    if (auto table = motions({}))
      debug_.add<robotcontrol::MotionTable>(streams::kMotions) = std::move(*table);
  }
}

}  // namespace robotlink
