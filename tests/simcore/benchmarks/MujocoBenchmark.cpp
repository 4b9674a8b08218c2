// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <sstream>

#include "robotlink/base/threads/ThreadPool.h"
#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/Simulation.h"
#include "tests/simcore/SceneFixture.h"

// Eight four-legged robots that stand apart on a floor and move their joints, by MuJoCo and by simcore, in
// turns in one run. MuJoCo's model is made from that of the shipped robot: the same links, joints, masses,
// solids and limits; servos are its position actuators, and steps are of 8 ms with Newton's method, the
// longest with which it stands. Ours are of 4 ms. "times_real" is how many times real time.
namespace {

using namespace simcore;

constexpr int kRobots = 8;
constexpr double kMujocoStep = 0.008, kBatch = 0.2;

std::string text(const Eigen::Vector3d& v) {
  std::ostringstream out;
  out << v.x() << ' ' << v.y() << ' ' << v.z();
  return out.str();
}

std::string text(const Pose3& pose) {
  const Eigen::Quaterniond q(pose.linear());
  std::ostringstream out;
  out << "pos='" << text(pose.translation()) << "' quat='" << q.w() << ' ' << q.x() << ' ' << q.y() << ' '
      << q.z() << "'";
  return out.str();
}

/// A solid as a geom; empty for kinds that robots do not have.
std::string geomOf(const CollisionDescription& solid) {
  const Shape& shape = solid.shape;
  std::ostringstream out;
  out << "<geom " << text(solid.poseInLink) << " friction='" << solid.friction << "' ";
  switch (shape.kind) {
    case Shape::Kind::kBox:
      out << "type='box' size='" << text(shape.size / 2) << "'";
      break;
    case Shape::Kind::kSphere:
      out << "type='sphere' size='" << shape.radius << "'";
      break;
    case Shape::Kind::kCylinder:
      out << "type='cylinder' size='" << shape.radius << ' ' << shape.length / 2 << "'";
      break;
    case Shape::Kind::kCapsule:
      out << "type='capsule' size='" << shape.radius << ' ' << shape.length / 2 << "'";
      break;
    default:
      return {};
  }
  out << " contype='1' conaffinity='2'/>";
  return out.str();
}

/// A link with all that hangs on it.
std::string bodyOf(const ModelDescription& model, int link, const Pose3& parentInModel,
                   const std::string& robot, const std::string& joint) {
  const LinkDescription& one = model.links[static_cast<std::size_t>(link)];
  std::ostringstream out;
  out << "<body name='" << robot << one.name << "' "
      << text(Pose3(parentInModel.inverse(Eigen::Isometry) * one.poseInModel)) << ">" << joint
      << "<inertial pos='" << text(one.centerOfMass) << "' mass='" << one.mass << "' diaginertia='"
      << text(Eigen::Vector3d(one.inertia.diagonal())) << "'/>";
  for (const CollisionDescription& solid : one.collisions) out << geomOf(solid);
  for (const JointDescription& child : model.joints) {
    if (child.parent != link || child.closesCycle) continue;
    const Pose3& childInModel = model.links[static_cast<std::size_t>(child.child)].poseInModel;
    std::ostringstream own;
    if (child.kind == JointDescription::Kind::kHinge) {
      own << "<joint name='" << robot << child.name << "' type='hinge' pos='"
          << text(Eigen::Vector3d(childInModel.inverse(Eigen::Isometry) * child.anchorInModel)) << "' axis='"
          << text(Eigen::Vector3d(childInModel.linear().transpose() * child.axisInModel)) << "' range='"
          << child.lower << ' ' << child.upper << "' limited='true' damping='0.02' armature='0.0005'/>";
    }
    out << bodyOf(model, child.child, one.poseInModel, robot, own.str());
  }
  out << "</body>";
  return out.str();
}

std::string mujocoModel(const WorldDescription& world) {
  std::ostringstream bodies, servos;
  for (const ModelInstance& instance : world.models) {
    if (instance.type->robot.empty()) continue;
    bodies << bodyOf(*instance.type, 0, instance.poseInWorld.inverse(Eigen::Isometry), instance.name,
                     "<freejoint/>");
    for (const JointDescription& joint : instance.type->joints) {
      if (!joint.servo || joint.kind != JointDescription::Kind::kHinge) continue;
      servos << "<position joint='" << instance.name << joint.name
             << "' kp='20' forcelimited='true' forcerange='" << -joint.maximumTorque << ' '
             << joint.maximumTorque << "'/>";
    }
  }
  std::ostringstream out;
  out << "<mujoco><compiler angle='radian' boundmass='1e-3' boundinertia='1e-6'/><option timestep='"
      << kMujocoStep
      << "' solver='Newton' integrator='Euler'/><size nconmax='2000' njmax='4000'/><worldbody><geom "
         "type='plane' "
         "size='0 0 1' contype='2' conaffinity='1'/>"
      << bodies.str() << "</worldbody><actuator>" << servos.str() << "</actuator></mujoco>";
  return out.str();
}

std::shared_ptr<const Scene> robots(const SceneFolder& folder) {
  folder.copyShippedModels();
  std::string contents =
      "<model name='floor'><static>true</static><link name='l'><collision "
      "name='c'><geometry><plane/></geometry>"
      "</collision></link></model>";
  for (int i = 0; i < kRobots; ++i) {
    contents += "<include><uri>model://ers210</uri><name>red" + std::to_string(i + 1) + "</name><pose>" +
                std::to_string(0.6 * i) + " 0 0.1138 0 0 0</pose></include>";
  }
  return Scene::load(folder.write("world.sdf", worldAround(contents))).value();
}

double swing(const std::vector<double>& stance, std::size_t servo, double time) {
  return stance[servo] + 0.1 * std::sin(6 * time + static_cast<double>(servo));
}

/// The angles at which the robots stand, by servo.
std::vector<double> stanceOf(const WorldDescription& world) {
  std::vector<double> angles;
  for (const ModelInstance& instance : world.models) {
    for (const JointDescription& joint : instance.type->joints) {
      if (joint.servo && joint.kind == JointDescription::Kind::kHinge) angles.push_back(joint.initialAngle);
    }
  }
  return angles;
}

double secondsOf(const std::function<void()>& run) {
  const auto begin = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

void againstMujoco(benchmark::State& state) {
  const SceneFolder folder;
  const auto scene = robots(folder);
  const auto file = folder.write("mujoco.xml", mujocoModel(scene->contents().world));
  char error[500] = "";
  mjModel* model = mj_loadXML(file.string().c_str(), nullptr, error, sizeof error);
  if (model == nullptr) return state.SkipWithError(error);
  mjData* data = mj_makeData(model);
  const auto pool = std::make_shared<robotlink::ThreadPool>(static_cast<int>(state.range(0)));
  const auto simulation = std::move(Simulation::create(scene, {.noise = false, .pool = pool}).value());
  const std::vector<double> stance = stanceOf(scene->contents().world);
  for (int i = 0; i < model->nu; ++i)
    data->qpos[model->jnt_qposadr[model->actuator_trnid[2 * i]]] = stance[static_cast<std::size_t>(i)];
  std::vector<double> theirs, ours;
  const auto stepTheirs = [&] {
    for (double t = 0; t < kBatch - 1e-9; t += kMujocoStep) {
      for (int i = 0; i < model->nu; ++i)
        data->ctrl[i] = swing(stance, static_cast<std::size_t>(i), data->time);
      mj_step(model, data);
    }
  };
  const auto stepOurs = [&] {
    for (double t = 0; t < kBatch - 1e-9; t += 0.004) {
      for (std::size_t s = 0; s < simulation->servos().size(); ++s)
        simulation->requestAngle(s, swing(stance, s, robotlink::seconds(simulation->time())));
      simulation->step();
    }
  };
  for ([[maybe_unused]] const auto _ : state) {
    theirs.push_back(secondsOf(stepTheirs));
    ours.push_back(secondsOf(stepOurs));
  }
  // The heights of the robots' bodies, to see whether they stand.
  double lowest = 1, ourLowest = 1;
  for (int i = 0; i < kRobots; ++i) {
    const int body = mj_name2id(
        model, mjOBJ_BODY,
        ("red" + std::to_string(i + 1) + scene->contents().world.models.back().type->links[0].name).c_str());
    if (body >= 0) lowest = std::min(lowest, data->xpos[3 * body + 2]);
    ourLowest = std::min(ourLowest, simulation->modelPose("red" + std::to_string(i + 1))->translation().z());
  }
  state.counters["mujoco_times_real"] = kBatch / median(theirs);
  state.counters["our_times_real"] = kBatch / median(ours);
  state.counters["ours_to_mujoco"] = median(theirs) / median(ours);
  state.counters["mujoco_lowest_mm"] = 1000 * lowest;
  state.counters["our_lowest_mm"] = 1000 * ourLowest;
  mj_deleteData(data);
  mj_deleteModel(model);
}
BENCHMARK(againstMujoco)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
