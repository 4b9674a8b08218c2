// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

/// The result of a run of robotctl.
struct RobotctlOutcome {
  int status = -1;
  std::string out, errors;
};

/// The shipped scene with a soccer robot.
inline const std::string kScene = ROBOTCONTROL_SOURCE_DIR "/resources/scenes/field2002.sdf";

inline std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Runs a line of a shell in a folder.
inline RobotctlOutcome runShell(const std::filesystem::path& folder, const std::string& line) {
  const std::string command = "cd '" + folder.string() + "' && " + line + " >.out 2>.errors";
  RobotctlOutcome outcome;
  outcome.status = WEXITSTATUS(std::system(command.c_str()));
  outcome.out = textOf(folder / ".out");
  outcome.errors = textOf(folder / ".errors");
  std::filesystem::remove(folder / ".out");
  std::filesystem::remove(folder / ".errors");
  return outcome;
}

/// Runs robotctl in a folder by a shell. The path of the program is the macro ROBOTCTL.
inline RobotctlOutcome runRobotctl(const std::filesystem::path& folder, const std::string& arguments) {
  return runShell(folder, ROBOTCTL + std::string(" ") + arguments);
}
