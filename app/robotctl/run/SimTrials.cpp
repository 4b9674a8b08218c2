// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/SimTrials.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/core/platform/JsonOutput.h"
#include "app/core/platform/ProgramTroubles.h"
#include "app/robotctl/Commands.h"
#include "app/robotctl/Interrupt.h"

namespace app {

using nlohmann::json;

namespace {

json trialJson(const BallTrials::Trial& trial, bool goals) {
  if (goals) {
    return {{"seed", trial.seed},
            {"robot", {trial.robot.x, trial.robot.y, trial.robot.heading}},
            {"ball", {trial.ball.x(), trial.ball.y()}},
            {"scored", trial.scored},
            {"scored_after", trial.scored ? json(trial.scoredAfter) : json()}};
  }
  return {{"seed", trial.seed},        {"ball", {trial.ball.x(), trial.ball.y()}},
          {"touched", trial.touched},  {"touched_after", trial.touched ? json(trial.touchedAfter) : json()},
          {"ball_moved", trial.moved}, {"fell", trial.fell}};
}

void printGoal(const BallTrials::Trial& trial) {
  std::cerr << "seed " << trial.seed << ": "
            << (trial.scored ? fmt::format("scored after {:.1f} s", trial.scoredAfter) : "not scored")
            << "\n";
}

void printTrial(const BallTrials::Trial& trial) {
  std::cerr << "seed " << trial.seed << ": "
            << (trial.touched ? fmt::format("touched after {:.1f} s", trial.touchedAfter) : "not touched")
            << (trial.fell ? ", fell" : "") << "\n";
}

}  // namespace

json troublesJson(const ProgramTroubles& troubles) {
  json list = json::array();
  for (const auto& trouble : troubles.all())
    list.push_back({{"robot", trouble.robot}, {"text", trouble.text}});
  return list;
}

/// The exit status of what ended with a status, whose programs may have been in trouble.
int withTroubles(int status, const ProgramTroubles& troubles) {
  return status == kDone && troubles.any() ? kDoneWithLosses : status;
}

int playTrials(BallTrials trials, const ProgramTroubles& troubles, bool asJson) {
  const Interrupt interrupt;
  trials.stop = &Interrupt::noted;
  trials.onTrial = trials.goals ? printGoal : printTrial;
  const auto results = trials.play();
  if (!results) return printErrors(results.error());
  json report;
  report["trials"] = results->size();
  report["touched"] = std::ranges::count_if(*results, [](const auto& t) { return t.touched; });
  if (trials.goals) {
    report["scored"] = std::ranges::count_if(*results, [](const auto& t) { return t.scored; });
  } else {
    report["radius"] = trials.radius;
  }
  report["seconds"] = trials.seconds;
  report["blackout"] = trials.run.world.blackout;
  for (const auto& trial : *results) report["results"].push_back(trialJson(trial, trials.goals));
  report["troubles"] = troublesJson(troubles);
  if (asJson) {
    std::cout << jsonOutput(report);
  } else {
    std::cout << report[trials.goals ? "scored" : "touched"] << " of " << report["trials"]
              << (trials.goals ? " scored\n" : " touched the ball\n");
  }
  const bool isWhole = results->size() == static_cast<std::size_t>(trials.count);
  return withTroubles(isWhole ? kDone : kFailed, troubles);
}

int playWalk(const WalkTrial& trial, const ProgramTroubles& troubles, bool asJson) {
  const auto result = trial.measure();
  if (!result) return printErrors(result.error());
  const json report{{"walk",
                     {{"forward", result->walked.forward},
                      {"sideward", result->walked.sideward},
                      {"rotation", result->walked.rotation},
                      {"asked", {result->asked.forward, result->asked.sideward, result->asked.rotation}},
                      {"least_upright", result->leastUpright},
                      {"fell", result->fell}}},
                    {"seed", trial.run.world.seed},
                    {"seconds", trial.seconds},
                    {"troubles", troublesJson(troubles)}};
  if (asJson) {
    std::cout << jsonOutput(report);
  } else if (result->fell) {
    std::cout << "fell\n";
  } else {
    std::cout << fmt::format("walked {:.3f} m/s forward, {:.3f} m/s to the left, {:.1f} degrees/s\n",
                             result->walked.forward, result->walked.sideward,
                             robotlink::degrees(result->walked.rotation));
  }
  return withTroubles(kDone, troubles);
}

}  // namespace app
