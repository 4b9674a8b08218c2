// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/app/far/FarProgram.h"

namespace app::test {

/// A program on a robot's computer that lets others watch and steer it, and what it has printed for them.
class FarRobot {
 public:
  /// `arguments`: those of robotctl, without --listen.
  FarRobot(FarLine& line, const std::filesystem::path& home, std::vector<std::string> arguments)
      : program_(line.computer(), home, withListening(line, std::move(arguments))),
        token_(program_.printed("to control: ")),
        fingerprint_(program_.printed("is shown this fingerprint: ")),
        url_(program_.printed(" at wss:")) {
    if (!url_.empty()) url_ = line.reached("wss:" + url_);
  }

  /// "wss://10.77.1.2:40123"; empty if the program did not begin.
  const std::string& url() const { return url_; }
  const std::string& token() const { return token_; }
  const std::string& fingerprint() const { return fingerprint_; }
  /// What it has printed so far.
  std::string notes() { return program_.program().errors(); }

 private:
  static std::vector<std::string> withListening(const FarLine& line, std::vector<std::string> arguments) {
    const auto more = line.listenOptions();
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  FarProgram program_;
  std::string token_, fingerprint_, url_;
};

}  // namespace app::test
