// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/Eventually.h"
#include "tests/app/StartedProgram.h"
#include "tests/app/far/FarLine.h"

namespace app::test {

/// robotctl on another machine, with a home of its own there. The path of the program is the macro ROBOTCTL.
class FarProgram {
 public:
  FarProgram(const FarLine::Machine& machine, const std::filesystem::path& home,
             const std::vector<std::string>& arguments) {
    const std::filesystem::path work = home / "work";
    std::filesystem::create_directories(work);
    program_ = std::make_unique<StartedProgram>(
        ROBOTCTL, work, arguments,
        StartedProgram::Options{
            .network = machine.network,
            .environment = {{"HOME", home.string()}, {"XDG_STATE_HOME", (home / "state").string()}}});
  }

  /// What stands behind a text in the first line that it prints with it, as errors or notes; waits for it.
  /// Empty: no such line came.
  std::string printed(const std::string& text) const {
    std::string found;
    eventually([&] {
      const std::string all = program_->errors();
      const std::size_t at = all.find(text);
      const std::size_t end = at == std::string::npos ? at : all.find('\n', at);
      if (end == std::string::npos) return false;
      found = all.substr(at + text.size(), end - at - text.size());
      return true;
    });
    return found;
  }
  StartedProgram& program() { return *program_; }

 private:
  std::unique_ptr<StartedProgram> program_;
};

}  // namespace app::test
