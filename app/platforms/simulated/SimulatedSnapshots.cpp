// SPDX-License-Identifier: GPL-3.0-or-later
// SimulatedRun: snapshots of the world, going back, and running programs again to where they were.
#include <fmt/format.h>

#include <algorithm>

#include "app/platforms/simulated/SimulatedRun.h"
#include "app/platforms/simulated/WorldChanges.h"
#include "simcore/Scene.h"
#include "simcore/world/StateStream.h"

namespace app {

using robotlink::Errors;
using robotlink::failure;
using robotlink::Result;

namespace {

constexpr char kGamePart[] = "game", kRadioPart[] = "radio", kJournalPart[] = "journal";
/// Steps of the simulation in one of the run.
constexpr std::uint64_t kStepsTogether = SimulatedWorld::kStep / simcore::Simulation::kStep;

auto cannotRunAgain(const std::string& why) {
  return failure("snapshot.programs",
                 "the programs cannot be brought to the state of the snapshot: " + why +
                     "; the world alone can be restored, without them",
                 {}, {why});
}

const char* onOff(bool on) {
  return on ? "on" : "off";
}

/// The first line in which two texts of settings differ.
std::pair<std::string, std::string> firstDifference(const std::string& a, const std::string& b) {
  const auto lineAt = [](const std::string& text, std::size_t at) {
    const auto before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    return text.substr(begin, text.find('\n', begin) - begin);
  };
  const auto differs = std::ranges::mismatch(a, b);
  const auto at = static_cast<std::size_t>(differs.in1 - a.begin());
  return {lineAt(a, at), lineAt(b, at)};
}

}  // namespace

std::string SimulatedRun::settings() const {
  std::string text = fmt::format("noise: {}\nkinematic: {}\nkick-offs: {}\n", onOff(options_.world.noise),
                                 onOff(options_.world.kinematic), onOff(options_.kickOffs));
  for (const auto& robot : robots_)
    text += fmt::format("layout of {}: {}\n", robot->name(), layoutOf(*robot, options_.layouts).string());
  if (rules_) text += fmt::format("rules of the game: {}\n", rules_->title);
  for (const auto& [name, solutions] : options_.robotSolutions) {
    for (const auto& [task, solution] : solutions)
      text += fmt::format("{} of {}: {}\n", task, name, solution);
  }
  for (const auto& [task, solution] : options_.solutions) text += fmt::format("{}: {}\n", task, solution);
  if (options_.preset || !options_.robotPresets.empty() || !options_.shadows.empty()) text += "a preset\n";
  for (const auto& [name, table] : options_.colorTables)
    text += fmt::format("color table of {}: {}\n", name.empty() ? "all" : name, table->source());
  return text;
}

void SimulatedRun::beginJournal() {
  std::vector<robotcontrol::Request> overrides;
  for (const auto& robot : robots_) {
    for (robotcontrol::Request& request : robot->overrides().requests(robot->name()))
      overrides.push_back(std::move(request));
  }
  stepsMade_ = 0;
  journal_.begin(options_.world.seed, settings(), std::move(overrides));
}

void SimulatedRun::spoilJournal(const std::string& what) {
  journal_.spoil(fmt::format("{} at {:.3f} s", what, robotlink::seconds(world_->clock().now())));
}

Result<void> SimulatedRun::changeWorld(const robotcontrol::Request& request) {
  auto done = app::changeWorld(*world_, request, stoppedRobots());
  if (done) journal_.add(stepsMade_, request);
  return done;
}

simcore::Snapshot SimulatedRun::snapshot() const {
  simcore::Snapshot snapshot = world_->snapshot();
  if (umpire_) {
    simcore::StateStream stream(snapshot.parts[kGamePart]);
    umpire_->transfer(stream);
  }
  simcore::StateStream radio(snapshot.parts[kRadioPart]);
  // Writing changes nothing.
  TeamRadio(radio_).transfer(radio, world_->clock().now());
  snapshot.parts[kJournalPart] = journal_.encode();
  return snapshot;
}

Result<std::vector<std::string>> SimulatedRun::restore(const simcore::Snapshot& snapshot) {
  const bool isFresh = stepsMade_ == 0;
  auto restored = world_->restore(snapshot);
  if (!restored) return restored;
  again_.reset();
  goneMotions_.clear();
  spoilJournal(isFresh ? "the simulation began from a snapshot"
                       : "the world was restored from a snapshot without the programs");
  restoreRadio(snapshot);
  restoreGame(snapshot);
  return restored;
}

/// Restores the game; one that cannot be read leaves it as it is.
void SimulatedRun::restoreGame(const simcore::Snapshot& snapshot) {
  if (!umpire_) return;
  umpire_->worldJumped();
  const auto part = snapshot.parts.find(kGamePart);
  if (part == snapshot.parts.end()) return;
  std::vector<std::uint8_t> before;
  simcore::StateStream keep(before);
  umpire_->transfer(keep);
  simcore::StateStream stream(part->second, snapshot.isForeign ? simcore::StateStream::Trust::kForeign
                                                               : simcore::StateStream::Trust::kOwn);
  umpire_->transfer(stream);
  if (stream.complete()) return;
  simcore::StateStream back(before, simcore::StateStream::Trust::kOwn);
  umpire_->transfer(back);
}

/// Restores the radio; data that cannot be read leaves it as it is.
void SimulatedRun::restoreRadio(const simcore::Snapshot& snapshot) {
  const auto part = snapshot.parts.find(kRadioPart);
  if (part == snapshot.parts.end()) return;
  simcore::StateStream stream(part->second, snapshot.isForeign ? simcore::StateStream::Trust::kForeign
                                                               : simcore::StateStream::Trust::kOwn);
  TeamRadio restored = radio_;
  restored.transfer(stream, world_->clock().now());
  if (!stream.complete()) return;
  radio_ = std::move(restored);
  for (auto& [robot, mail] : mails_) {
    mail->sent = nullptr;
    mail->received = nullptr;
  }
}

Result<void> SimulatedRun::rewind(robotlink::Duration back) {
  if (auto done = world_->rewind(back); !done) return done;
  spoilJournal("the world was rewound without the programs");
  if (umpire_) umpire_->worldJumped();
  return {};
}

Result<RunJournal> SimulatedRun::journalToRepeat(const simcore::Snapshot& snapshot) const {
  if (options_.executor() != ExecutorKind::kLockstep)
    return cannotRunAgain("programs in threads are not reproducible");
  if (options_.instead) return cannotRunAgain("they run elsewhere");
  if (ports_) return cannotRunAgain("other programs can drive the robots at their ports");
  const auto part = snapshot.parts.find(kJournalPart);
  if (part == snapshot.parts.end())
    return cannotRunAgain("the snapshot does not contain the requests to them");
  auto journal = RunJournal::decode(part->second);
  if (!journal) return tl::unexpected(journal.error());
  if (!journal->spoiled().empty()) return cannotRunAgain(journal->spoiled());
  if (const std::string now = settings(); journal->settings() != now) {
    const auto [then, here] = firstDifference(journal->settings(), now);
    return cannotRunAgain("it was taken with '" + then + "', and now it is '" + here + "'");
  }
  if (snapshot.step % kStepsTogether != 0) return cannotRunAgain("it was taken in the middle of a step");
  return journal;
}

Result<void> SimulatedRun::runAgain(const simcore::Snapshot& snapshot) {
  const bool isOther = snapshot.fingerprint != world_->simulation().fingerprint();
  if (isOther && snapshot.of && !robots_.empty())
    return cannotRunAgain("the scene was changed since it was taken");
  // Says what is wrong with a snapshot of another scene.
  if (robots_.empty() || isOther) return restore(snapshot).map([](const auto&) {});
  auto journal = journalToRepeat(snapshot);
  if (!journal) return tl::unexpected(journal.error());
  std::map<std::string, ProgramOverrides> overrides;
  for (const auto& robot : robots_) overrides[robot->name()];
  for (const auto& request : journal->overrides()) overrides[request.robot()].note(request);
  if (const Errors errors = restart(journal->seed(), &overrides); !errors.empty())
    return tl::unexpected(errors.front());
  againOutcome_.reset();
  again_.emplace(Again{snapshot, std::move(*journal)});
  if (snapshot.step == 0) endRunningAgain();
  return {};
}

std::optional<double> SimulatedRun::ranAgain() const {
  if (!again_) return std::nullopt;
  return static_cast<double>(world_->simulation().steps()) / static_cast<double>(again_->snapshot.step);
}

void SimulatedRun::repeatRequests() {
  const auto& entries = again_->journal.entries();
  for (; again_->next < entries.size() && entries[again_->next].step <= stepsMade_; ++again_->next) {
    // The request keeps its number, so that the programs do exactly the same.
    const robotcontrol::Request& request = entries[again_->next].request;
    // Requests that were accepted then are accepted now; if not, the state shows it at the end.
    if (changesWorld(request)) {
      (void)changeWorld(request);
    } else if (request.has_control_game()) {
      (void)controlGame(request);
    } else {
      (void)this->request(request);
    }
  }
}

void SimulatedRun::endRunningAgain() {
  const simcore::Snapshot snapshot = std::move(again_->snapshot);
  // Repeats the requests made after the last step before the snapshot.
  repeatRequests();
  again_.reset();
  againOutcome_ = "";
  if (world_->digest() == SimulatedWorld::digestOf(snapshot)) return;
  againOutcome_ =
      "the programs did not reach the state of the snapshot, perhaps because their files have changed; the "
      "world was restored";
  if (const auto restored = restore(snapshot); !restored) againOutcome_ = restored.error().text;
}

}  // namespace app
