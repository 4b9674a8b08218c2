// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace app::test {

/// Lines of a layout: a process that drives along the path of the one with the trouble.
inline constexpr char kTroubleDriver[] =
    "  - name: driver\n    blocking: [drive/state]\n    tasks:\n      - self-localisation: wheel-odometry\n"
    "      - driving: follow-path\n      - obstacle-avoidance: vector-field\n";

/// A layout whose process "worker" does the task of TroubleProgram.cpp, beside other processes.
inline std::string troubleLayout(const std::string& solution, const std::string& others = {}) {
  return "version: 1\nname: trouble\nprocesses:\n"
         "  - name: worker\n    period_ms: 8\n    tasks:\n      - trouble: " +
         solution + "\n" + others + "  - {name: debug, debug: true, period_ms: 16}\n";
}

}  // namespace app::test
