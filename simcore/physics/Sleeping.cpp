// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/Sleeping.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "simcore/physics/FreeBodies.h"
#include "simcore/physics/OdeJoints.h"
#include "simcore/physics/Step.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

/// The number of steps for which a body must rest before it falls asleep.
constexpr int kQuietSteps = 125;
/// How far something may move and turn in the meantime.
struct Quiet {
  double way = 0;   // m
  double turn = 0;  // rad
};
constexpr Quiet kQuiet{0.0005, 0.003};
/// The same for parts on servos. The iterations of ODE's solver do not converge for a chain of light
/// links that stands on the ground: with 20 of them, the legs of a standing ERS-210 tremble by up to 6.7 mrad
/// and 0.7 mm in half a second, with 200 of them, or an exact solver, by nothing.
constexpr Quiet kQuietOnServo{0.001, 0.008};
// A sleeping model is not woken by changes of a motor's command below these: rad/s (a servo asks for it
// if its target is 0.0002 rad elsewhere), and a share of the torque.
constexpr double kSameSpeed = 0.02, kSameLimit = 0.01;

OdeModel& modelAt(OdeWorld& ode, int model) {
  return ode.models[static_cast<std::size_t>(model)];
}

/// Begins to wait for a body to stay where it is now.
void watchAnew(OdeFreeBody& body) {
  body.quietSteps = 0;
  std::copy_n(dBodyGetPosition(body.id), 3, body.quietPosition);
  std::copy_n(dBodyGetQuaternion(body.id), 4, body.quietRotation);
}

bool hasMoved(const OdeFreeBody& body, const Quiet& quiet) {
  const dReal *p = dBodyGetPosition(body.id), *q = dBodyGetQuaternion(body.id);
  double squared = 0, cosine = 0;
  for (int i = 0; i < 3; ++i) squared += (p[i] - body.quietPosition[i]) * (p[i] - body.quietPosition[i]);
  for (int i = 0; i < 4; ++i) cosine += q[i] * body.quietRotation[i];
  // The quaternions' product has the cosine of half of the angle.
  return squared > quiet.way * quiet.way || std::abs(cosine) < 1 - quiet.turn * quiet.turn / 8;
}

bool isQuiet(const OdeModel& model) {
  return model.maySleep() && model.sleepers.front()->quietSteps == kQuietSteps;
}

bool hasServos(const OdeWorld& ode, const OdeModel& model) {
  const auto first = ode.hingeHasMotor.begin() + static_cast<std::ptrdiff_t>(model.firstHinge);
  return std::any_of(first, first + static_cast<std::ptrdiff_t>(model.hingeCount),
                     [](const auto hasMotor) { return static_cast<bool>(hasMotor); });
}

/// Returns whether it has been quiet for long enough.
bool watch(const OdeWorld& ode, OdeModel& model) {
  int contacts = 0;
  bool stays = true;
  const Quiet& ofParts = hasServos(ode, model) ? kQuietOnServo : kQuiet;
  for (const OdeFreeBody* body : model.sleepers) {
    contacts += body->contacts;
    const Quiet& quiet = body == model.sleepers.front() ? kQuiet : ofParts;
    stays = stays && dBodyIsKinematic(body->id) == 0 && !hasMoved(*body, quiet);
  }
  // A foot that loses contact for a step, without having moved, only lets the model wait.
  const bool stands = contacts >= kStands;
  for (OdeFreeBody* body : model.sleepers) {
    if (stays)
      body->quietSteps =
          std::min(body->quietSteps + (stands ? 1 : 0), stands ? kQuietSteps : kQuietSteps - 1);
    else
      watchAnew(*body);
  }
  return isQuiet(model);
}

/// Brings the means of what the joints of a model exert up to date, while it stays where it is. From step to
/// step the solver's forces tremble by some percent.
void averageForces(OdeWorld& ode, const OdeModel& model) {
  const int steps = model.sleepers.front()->quietSteps;
  if (steps == 0) return;
  for (std::size_t i = model.firstHinge; i < model.firstHinge + model.hingeCount; ++i) {
    const dJointFeedback& now = ode.hingeForces[i];
    OdeWrench& mean = ode.restForces[i];
    if (steps == 1) mean = {};
    mean.force += (Vector3(now.f1[0], now.f1[1], now.f1[2]) - mean.force) / steps;
    mean.torque += (Vector3(now.t1[0], now.t1[1], now.t1[2]) - mean.torque) / steps;
  }
}

/// The groups of models that touch each other, among those that could sleep.
class TouchingModels {
 public:
  explicit TouchingModels(OdeWorld& ode)
      : ode_(ode), first_(ode.models.size()), sleeps_(first_.size(), true) {
    std::iota(first_.begin(), first_.end(), 0);
    for (const OdePair& pair : ode.pairs) add(pair.first->model, pair.second->model);
    for (int i = 0; i < static_cast<int>(first_.size()); ++i) {
      if (modelAt(ode_, i).maySleep() && !isQuiet(modelAt(ode_, i))) keepAwake(i);
    }
  }

  /// The first model of those that a model touches; -1 if they have to stay awake.
  int groupOf(int model) const {
    const int group = of(model);
    return sleeps_[static_cast<std::size_t>(group)] ? group : -1;
  }

 private:
  int of(int model) const {
    while (first_[static_cast<std::size_t>(model)] != model) model = first_[static_cast<std::size_t>(model)];
    return model;
  }
  void keepAwake(int model) { sleeps_[static_cast<std::size_t>(of(model))] = false; }
  void add(int a, int b) {
    const OdeModel &first = modelAt(ode_, a), &second = modelAt(ode_, b);
    if (first.space == nullptr || second.space == nullptr) return;
    if (!first.maySleep() || !second.maySleep()) {
      if (first.maySleep()) keepAwake(a);
      if (second.maySleep()) keepAwake(b);
      return;
    }
    const int groupA = of(a), groupB = of(b), low = std::min(groupA, groupB), high = std::max(groupA, groupB);
    if (!sleeps_[static_cast<std::size_t>(high)]) keepAwake(low);
    first_[static_cast<std::size_t>(high)] = low;
  }

  OdeWorld& ode_;
  std::vector<int> first_;
  std::vector<bool> sleeps_;
};

/// Keeps the contacts of a model that falls asleep.
void keepContacts(OdeWorld& ode) {
  const OdeGeom *first = nullptr, *second = nullptr;
  for (const OdeContactRecord& record : ode.contactRecords) {
    const int group =
        std::max(modelAt(ode, record.first->model).group, modelAt(ode, record.second->model).group);
    if (group < 0) continue;
    const dReal* force = record.exerted->f1;
    ode.asleepContacts.push_back(
        {record.first->index, record.second->index, group, first != record.first || second != record.second,
         record.point, record.normal, record.sign * Vector3(force[0], force[1], force[2]), record.depth});
    first = record.first;
    second = record.second;
  }
}

/// Sets the values with which the servos of a model are compared while it sleeps: the speeds that they will
/// request at the angles that they have reached in this step.
void keepWhatServosAskFor(OdeWorld& ode, const OdeModel& model) {
  for (std::size_t i = model.firstHinge; i < model.firstHinge + model.hingeCount; ++i) {
    if (!ode.hingeIsStiff[i]) continue;
    const MotorSetting motor = motorOf(ode.hinges[i]);
    driveJoint(ode.hinges[i], motor.speed - kStiffServoShare * jointRate(ode.hinges[i]), motor.limit);
  }
}

void sleep(OdeWorld& ode, OdeModel& model, int group) {
  model.group = group;
  keepWhatServosAskFor(ode, model);
  for (std::size_t i = model.firstHinge; i < model.firstHinge + model.hingeCount; ++i) {
    std::copy_n(ode.restForces[i].force.data(), 3, ode.hingeForces[i].f1);
    std::copy_n(ode.restForces[i].torque.data(), 3, ode.hingeForces[i].t1);
  }
  for (const OdeFreeBody* body : model.sleepers) {
    dBodySetLinearVel(body->id, 0, 0, 0);
    dBodySetAngularVel(body->id, 0, 0, 0);
    dBodyDisable(body->id);
  }
}

void wakeGroup(OdeWorld& ode, int group) {
  for (OdeModel& model : ode.models) {
    if (model.group != group) continue;
    model.group = OdeModel::kAwake;
    for (OdeFreeBody* body : model.sleepers) {
      dBodyEnable(body->id);
      watchAnew(*body);
    }
  }
  std::erase_if(ode.asleepContacts, [&](const OdeAsleepContact& one) { return one.group == group; });
}

/// Transfers the commands of a model's motors: while it sleeps, other commands are compared with these.
void transferMotors(StateStream& stream, const OdeWorld& ode, const OdeModel& model) {
  for (std::size_t i = model.firstHinge; i < model.firstHinge + model.hingeCount; ++i) {
    MotorSetting motor = motorOf(ode.hinges[i]);
    stream.within(motor.speed, -1e15, 1e15);
    stream.within(motor.limit, 0, 1e15);
    if (stream.isReading() && stream.good()) driveJoint(ode.hinges[i], motor.speed, motor.limit);
  }
}

void transferRestForces(StateStream& stream, OdeWorld& ode, const OdeModel& model) {
  for (std::size_t i = model.firstHinge; i < model.firstHinge + model.hingeCount; ++i) {
    for (Vector3* vector : {&ode.restForces[i].force, &ode.restForces[i].torque})
      for (int k = 0; k < 3; ++k) stream.within((*vector)[k], -1e15, 1e15);
  }
}

}  // namespace

void wake(OdeWorld& ode, OdeModel& model) {
  if (model.isAsleep()) wakeGroup(ode, model.group);
}

void wakeIfDrivenOtherwise(OdeWorld& ode, std::size_t hinge, double speed, double limit) {
  OdeModel& model = modelAt(ode, ode.hingeModels[hinge]);
  if (!model.isAsleep()) return;
  const MotorSetting before = motorOf(ode.hinges[hinge]);
  const bool isSame = std::abs(speed - before.speed) <= kSameSpeed &&
                      std::abs(limit - before.limit) <= kSameLimit * before.limit;
  if (!isSame) wake(ode, model);
}

bool wakeTouched(OdeWorld& ode) {
  if (!ode.sleeps) return false;
  bool slept = false;
  for (const OdePair& pair : ode.pairs) {
    for (const OdeGeom* geom : {pair.first, pair.second}) {
      OdeModel& model = modelAt(ode, geom->model);
      slept |= model.isAsleep();
      wake(ode, model);
    }
  }
  return slept;
}

bool mayFallAsleep(dBodyID body) {
  const auto* free = body == nullptr ? nullptr : static_cast<const OdeFreeBody*>(dBodyGetData(body));
  return free != nullptr && free->quietSteps >= kQuietSteps - 1;
}

void letModelsSleep(OdeWorld& ode) {
  if (!ode.sleeps) return;
  bool anyIsQuiet = false;
  for (OdeModel& model : ode.models) {
    if (!model.maySleep() || model.isAsleep()) continue;
    anyIsQuiet |= watch(ode, model);
    averageForces(ode, model);
  }
  if (anyIsQuiet) {
    const TouchingModels touching(ode);
    bool anySleeps = false;
    for (int i = 0; i < static_cast<int>(ode.models.size()); ++i) {
      OdeModel& model = modelAt(ode, i);
      if (model.isAsleep() || !isQuiet(model)) continue;
      const int group = touching.groupOf(i);
      if (group < 0) continue;
      sleep(ode, model, group);
      anySleeps = true;
    }
    if (anySleeps) keepContacts(ode);
  }
  if (!ode.readsContacts) ode.contactRecords.clear();
}

void transferSleep(StateStream& stream, OdeWorld& ode) {
  const auto models = static_cast<int>(ode.models.size());
  for (OdeModel& model : ode.models) {
    if (!model.maySleep()) continue;
    stream.raw(model.group);
    stream.require(model.group >= OdeModel::kAwake && model.group < models);
    for (OdeFreeBody* body : model.sleepers) {
      stream.raw(body->quietSteps);
      stream.require(body->quietSteps >= 0 && body->quietSteps <= kQuietSteps);
      for (int i = 0; i < 3; ++i) stream.number(body->quietPosition[i]);
      for (int i = 0; i < 4; ++i) stream.within(body->quietRotation[i], -1.001, 1.001);
    }
    transferMotors(stream, ode, model);
    transferRestForces(stream, ode, model);
    if (!stream.isReading()) continue;
    if (!stream.good()) model.group = OdeModel::kAwake;
    for (const OdeFreeBody* body : model.sleepers)
      model.isAsleep() ? dBodyDisable(body->id) : dBodyEnable(body->id);
  }
  stream.size(ode.asleepContacts, std::size_t{1} << 24U);
  const auto isPossible = [&](const OdeAsleepContact& one) {
    return one.first < ode.geoms.size() && one.second < ode.geoms.size() && one.group >= 0 &&
           one.group < models;
  };
  for (OdeAsleepContact& one : ode.asleepContacts) {
    stream.raw(one.first);
    stream.raw(one.second);
    stream.raw(one.group);
    stream.flag(one.isFirstOfPair);
    for (Vector3* vector : {&one.point, &one.normal}) stream.vector(*vector);
    for (int i = 0; i < 3; ++i) stream.within(one.force[i], -1e15, 1e15);
    stream.number(one.depth);
    stream.require(isPossible(one));
  }
  if (stream.isReading() && !stream.good()) ode.asleepContacts.clear();
}

}  // namespace simcore
