// SPDX-License-Identifier: GPL-3.0-or-later
// SimulatedWorld: keeping its state, and going back to it.
#include <algorithm>
#include <optional>
#include <utility>

#include "app/platforms/simulated/world/SimulatedWorld.h"
#include "simcore/Scene.h"
#include "simcore/world/StateStream.h"

namespace app {
namespace {

constexpr char kWorldPart[] = "world";
constexpr std::size_t kMaxCameras = 10'000, kMaxHeld = 10'000;

}  // namespace

/// The state of a world that is not in its simulation.
struct SimulatedWorld::Kept {
  std::uint64_t digest = 0, images = 0;
  simcore::LightAdjustment lighting;
  /// The cameras that had settings, by path.
  std::vector<std::pair<std::string, KeptCamera>> cameras;
  /// Ports and their values.
  std::vector<std::pair<std::string, std::vector<double>>> held;

  void transfer(simcore::StateStream& stream) {
    stream.raw(digest);
    stream.raw(images);
    stream.within(lighting.brightness, 0, simcore::LightAdjustment::kMaxBrightness);
    stream.within(lighting.warmth, -1, 1);
    stream.size(cameras, kMaxCameras);
    for (auto& [path, camera] : cameras) {
      stream.text(path);
      stream.within(camera.setting.exposure, 0, 1e6);
      stream.within(camera.setting.gain, 0, 1e6);
      stream.within(camera.setting.whiteBalance, -1, 1);
      stream.flag(camera.errorsChosen);
    }
    stream.size(held, kMaxHeld);
    for (auto& [port, values] : held) {
      stream.text(port);
      stream.size(values, 16);
      for (double& value : values) stream.number(value);
    }
  }
};

simcore::Snapshot SimulatedWorld::snapshot() const {
  simcore::Snapshot snapshot = simulation_->snapshot();
  Kept kept{digest_, costs_.images, options_.lighting, {}, {}};
  const auto cameras = simulation_->cameras();
  for (std::size_t i = 0; i < cameras.size(); ++i)
    kept.cameras.push_back({cameras[i].info.path, {cameraSettings_[i], cameraErrorsChosen_[i]}});
  for (const auto& [port, held] : held_.all()) kept.held.emplace_back(port, held.values);
  simcore::StateStream stream(snapshot.parts[kWorldPart]);
  kept.transfer(stream);
  return snapshot;
}

std::uint64_t SimulatedWorld::digestOf(const simcore::Snapshot& snapshot) {
  const auto part = snapshot.parts.find(kWorldPart);
  std::uint64_t digest = 0;
  if (part == snapshot.parts.end()) return digest;
  simcore::StateStream stream(part->second, simcore::StateStream::Trust::kForeign);
  stream.raw(digest);
  return digest;
}

robotlink::Result<std::vector<std::string>> SimulatedWorld::restore(const simcore::Snapshot& snapshot) {
  const auto part = snapshot.parts.find(kWorldPart);
  // A snapshot of a simulation alone leaves the rest as it is.
  std::optional<Kept> kept;
  if (part != snapshot.parts.end()) {
    kept.emplace();
    simcore::StateStream stream(part->second, snapshot.isForeign ? simcore::StateStream::Trust::kForeign
                                                                 : simcore::StateStream::Trust::kOwn);
    kept->transfer(stream);
    if (!stream.complete()) {
      return robotlink::failure("snapshot.damaged", "the snapshot of " + snapshot.scene + " is damaged", {},
                                {snapshot.scene});
    }
  }
  const bool isFresh = simulation_->steps() == 0 && clock_.now() == robotlink::Instant();
  auto restored = simulation_->restore(snapshot);
  if (!restored) return restored;
  if (isFresh) clock_.set(robotlink::Instant(simulation_->time()));
  settleAfterJump();
  if (kept) restoreKept(*kept, snapshot.of.get());
  return restored;
}

void SimulatedWorld::restoreKept(const Kept& kept, const simcore::Scene* of) {
  digest_ = kept.digest;
  costs_.images = kept.images;
  options_.lighting = kept.lighting;
  const auto cameras = simulation_->cameras();
  for (const auto& [path, camera] : kept.cameras) {
    const auto now = std::ranges::find(cameras, path, [](const auto& one) { return one.info.path; });
    if (now == cameras.end()) continue;
    const auto index = static_cast<std::size_t>(now - cameras.begin());
    cameraSettings_[index] = camera.setting;
    cameraErrorsChosen_[index] = camera.errorsChosen;
  }
  // Actuators held after the snapshot are released, except those of models added since then.
  auto before = std::exchange(held_, {}).all();
  if (of != nullptr) {
    for (const auto& model : of->models())
      std::erase_if(before, [&](const auto& held) { return held.second.model == model.name; });
    for (const auto& [port, held] : before) (void)held_.hold(*simulation_, port, held.values);
  }
  // Actuators that no longer exist are skipped.
  for (const auto& [port, values] : kept.held) (void)held_.hold(*simulation_, port, values);
}

void SimulatedWorld::settleAfterJump() {
  clockAhead_ = clock_.now().time_since_epoch() - simulation_->time();
  cameraWork_.forgetPast();
  costs_.steps = simulation_->steps();
  for (const auto& pioneer : pioneers_) pioneer->worldJumped();
}

robotlink::Duration SimulatedWorld::rewindable() const {
  const std::uint64_t steps = simulation_->steps() - simulation_->rewindableFrom();
  return simcore::Simulation::kStep * static_cast<std::int64_t>(steps);
}

robotlink::Result<void> SimulatedWorld::rewind(robotlink::Duration back) {
  constexpr std::uint64_t kTogether = kStep / simcore::Simulation::kStep;
  const robotlink::Duration most = rewindable();
  if (back > most) {
    return robotlink::failure(
        "simulation.rewind",
        "the simulation can go back by " + std::to_string(robotlink::seconds(most)) + " s at most");
  }
  const auto own = std::max<std::uint64_t>(1, static_cast<std::uint64_t>((back + kStep / 2) / kStep));
  if (kTogether * own > simulation_->steps())
    return robotlink::failure("simulation.rewind", "the simulation is at its start");
  if (auto done = simulation_->rewindTo(simulation_->steps() - kTogether * own); !done) return done;
  settleAfterJump();
  return {};
}

}  // namespace app
