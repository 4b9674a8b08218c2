// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds in which models move: a floor and shipped or written models, commanded by their ports.
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "simcore/Simulation.h"
#include "tests/simcore/DriveScenes.h"

namespace simcore {

using Motion = std::vector<double>;

/// An <include> of a model, with further elements in it.
std::string including(const std::string& model, const std::string& pose = "0 0 0 0 0 0",
                      const std::string& more = "");
/// A robot on two driven wheels, 0.3 m apart, and a caster.
std::string trolley();
/// A box of 0.2 m that weighs 0.4 kg.
std::string parcelAt(const std::string& name, double x, double y);
/// A simulation of a floor with `contents`. Beside the shipped models there is `torque_car`.
std::unique_ptr<Simulation> yardWith(const std::string& contents, std::uint64_t seed = 1,
                                     SimulationOptions options = {.seed = 1, .noise = false});
std::string replacedOnce(std::string text, const std::string& from, const std::string& to);
/// The errors of a world with a shipped model in which `from` is replaced.
std::string errorsOfModel(const std::string& model, const std::string& from, const std::string& to);

void commandPort(Simulation& simulation, const std::string& port, const Motion& values);
void runFor(Simulation& simulation, double seconds);
double portReading(const Simulation& simulation, const std::string& path);
robotlink::Pose2 groundPlace(const Simulation& simulation, const std::string& model);

}  // namespace simcore
