// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "tests/app/far/FarDesk.h"

namespace app::test {

/// A robot on the field of 2002 on another machine, and the desk of somebody who has just connected it.
struct FarHall {
  static constexpr std::uint64_t kSeed = 7;

  FarHall(FarLine& line, const std::filesystem::path& home)
      : robot(line, home / "robot",
              {"sim", defaultSimulation().scene.string(), "--seed", std::to_string(kSeed)}) {
    qputenv("XDG_STATE_HOME", QByteArray::fromStdString((home / "state").string()));
    desk = std::make_unique<FarDesk>(home / "desk");
    wrong = desk->meet(robot);
  }
  ~FarHall() { qunsetenv("XDG_STATE_HOME"); }
  FarHall(const FarHall&) = delete;
  FarHall& operator=(const FarHall&) = delete;

  FarRobot robot;
  std::unique_ptr<FarDesk> desk;
  /// Why it is not connected; empty: it is.
  QString wrong;
};

}  // namespace app::test
