// SPDX-License-Identifier: GPL-3.0-or-later
// SimulationFeed: snapshots, going back, and the forces in the world.
#include <fmt/format.h>

#include <algorithm>

#include "app/platforms/SceneMessages.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kForcesPeriod{33};
/// The time for which programs are run again before requests are handled.
constexpr std::chrono::milliseconds kAgainSlice{30};
constexpr std::chrono::milliseconds kAgainStatusEvery{100};

using Snapshots = robotcontrol::ControlSnapshots;

double worldTime(const simcore::Snapshot& snapshot) {
  return robotlink::seconds(simcore::Simulation::kStep * static_cast<std::int64_t>(snapshot.step));
}

}  // namespace

void SimulationFeed::say(const std::string& text, int level) {
  if (!run_->robots().empty()) gate_.publishText(run_->robots().front(), "simulation", now(), level, text);
}

void SimulationFeed::addSnapshots(robotcontrol::SimulationStatus& status) const {
  const simcore::Simulation& simulation = run_->world().simulation();
  status.set_world_time(robotlink::seconds(simulation.time()));
  for (const auto& [name, snapshot] : snapshots_.all()) {
    auto& info = *status.add_snapshots();
    info.set_name(name);
    info.set_time(worldTime(snapshot));
    info.set_bytes(snapshot.bytes());
  }
  status.set_rewindable(robotlink::seconds(run_->world().rewindable()));
  // Above 0, so that it is known from the beginning.
  if (const auto share = run_->ranAgain()) status.set_catching_up(std::clamp(*share, 1e-3, 1.0));
  for (const std::string& path : simulation.pinned()) status.add_pinned(path);
  for (const std::string& path : simulation.dragged()) status.add_dragged(path);
}

void SimulationFeed::publishJump(const std::string& text) {
  restartPace();
  if (!run_->robots().empty())
    gate_.publishText(run_->robots().front(), robotlink::streams::kWorldSource, now(), foxglove::Log::INFO,
                      text);
  publishTransforms();
  publishForces();
  if (lastPorts_ != Clock::time_point()) publishPorts();
  publishStatus();
}

robotlink::Result<void> SimulationFeed::controlSnapshots(const robotcontrol::Request& request) {
  const Snapshots& control = request.control_snapshots();
  robotlink::Result<void> done;
  switch (control.action()) {
    case Snapshots::TAKE:
      done = takeSnapshot(request);
      break;
    case Snapshots::RESTORE:
      return restoreSnapshot(request);
    case Snapshots::FORGET:
      done = snapshots_.forget(control.name());
      break;
    case Snapshots::REWIND:
      return rewind(control.seconds());
    case Snapshots::CANCEL:
      if (!run_->ranAgain()) break;
      run_->stopRunningAgain();
      running_ = false;
      publishJump("Replaying the programs was canceled before they reached the snapshot.");
      break;
    default:
      break;
  }
  publishStatus();
  return done;
}

robotlink::Result<void> SimulationFeed::takeSnapshot(const robotcontrol::Request& request) {
  const Snapshots& control = request.control_snapshots();
  simcore::Snapshot snapshot = run_->snapshot();
  const double time = worldTime(snapshot);
  const bool isFile = !control.file().empty();
  if (auto kept =
          isFile ? snapshot.write(control.file()) : snapshots_.keep(control.name(), std::move(snapshot));
      !kept)
    return kept;
  say(fmt::format("Snapshot '{}' was taken at {:.3f} s.", isFile ? control.file() : control.name(), time),
      foxglove::Log::INFO);
  return {};
}

robotlink::Result<void> SimulationFeed::restoreSnapshot(const robotcontrol::Request& request) {
  const Snapshots& control = request.control_snapshots();
  const bool isFile = !control.file().empty();
  simcore::Snapshot snapshot;
  if (isFile) {
    auto read = simcore::Snapshot::read(control.file());
    if (!read) return tl::unexpected(read.error());
    snapshot = std::move(*read);
  } else {
    const auto found = snapshots_.find(control.name());
    if (!found) return tl::unexpected(found.error());
    snapshot = **found;
  }
  stepsWanted_ = 0;
  const std::string name = isFile ? control.file() : control.name();
  if (!control.programs()) {
    const auto restored = run_->restore(snapshot);
    if (!restored) return tl::unexpected(restored.error());
    publishJump(fmt::format("The world is back at {:.3f} s (snapshot '{}'); the programs keep running.",
                            worldTime(snapshot), name));
    for (const std::string& model : *restored)
      say(model + " was changed since then; it is where the scene's file puts it.");
    return {};
  }
  if (auto done = run_->runAgain(snapshot); !done) return done;
  restartPace();
  publishScene();
  say(fmt::format("The programs are being replayed up to snapshot '{}' at {:.3f} s.", name,
                  worldTime(snapshot)),
      foxglove::Log::INFO);
  // Its state may be that of the start.
  if (!run_->ranAgain()) runAgain();
  return {};
}

robotlink::Result<void> SimulationFeed::rewind(double seconds) {
  if (running_) {
    return robotlink::failure("simulation.rewind", "the simulation is running; pause it to rewind it");
  }
  stepsWanted_ = 0;
  const double before = robotlink::seconds(run_->world().simulation().time());
  if (auto done = run_->rewind(robotlink::fromSeconds(seconds)); !done) return done;
  publishJump(fmt::format("The world was rewound from {:.3f} s to {:.3f} s; the programs keep running.",
                          before, robotlink::seconds(run_->world().simulation().time())));
  return {};
}

robotlink::Result<void> SimulationFeed::whetherFree(const robotcontrol::Request& request) {
  using Request = robotcontrol::Request;
  if (!run_->ranAgain()) return {};
  // A STOP request also ends a run toward a snapshot.
  if (robotlink::engagesStop(request)) {
    run_->stopRunningAgain();
    return {};
  }
  switch (request.what_case()) {
    case Request::kControlSimulation:
    case Request::kControlSnapshots:
    case Request::kReadForces:
    case Request::kReadPorts:
      return {};
    default:
      return robotlink::failure(
          "simulation.busy",
          "the programs are being replayed up to a snapshot; wait until that is done, or cancel it");
  }
}

void SimulationFeed::runAgain() {
  const auto until = Clock::now() + kAgainSlice;
  while (run_->ranAgain() && Clock::now() < until) run_->step();
  const auto real = Clock::now();
  publishTransforms();
  const auto outcome = run_->takeRunAgainOutcome();
  if (!outcome) {
    if (real - lastStatus_ >= kAgainStatusEvery) publishStatus();
    return;
  }
  const std::string text = outcome->empty() ? "World and programs are at the snapshot." : *outcome;
  publishJump(text);
  if (!outcome->empty()) say(text, foxglove::Log::WARNING);
  publishAnswers();
}

robotlink::Result<void> SimulationFeed::readForces(const robotcontrol::Request& request) {
  const auto lasts = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(request.read_forces().seconds()));
  forcesUntil_ = Clock::now() + lasts;
  chooseForces();
  publishForces();
  return {};
}

void SimulationFeed::chooseForces() {
  readsForces_ = demand_.forces || Clock::now() < forcesUntil_;
  run_->readForces(readsForces_);
}

void SimulationFeed::publishForces() {
  if (!readsForces_) return;
  lastForces_ = Clock::now();
  gate_.publish({robotlink::streams::kForces, now(), forcesMessage(run_->world().simulation(), now())});
}

void SimulationFeed::stepForces(Clock::time_point real) {
  if (running_ && real - lastForces_ < kForcesPeriod) return;
  publishForces();
  chooseForces();
}

}  // namespace app
