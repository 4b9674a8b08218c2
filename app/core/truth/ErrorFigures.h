// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace robotlink {
class TruthErrors;
}

namespace app {

/// The errors for other programs, exact numbers under stable names:
/// {"red1": {"models/ball": {"position": {"unit": "m", "count": 100, "mean": 0.1, "median": 0.08, "p95": 0.3,
/// "max": 0.9}, "missed": 0.02, "there": 500, "false": 0.01, "reported": 490, "latency": {...}}}}. "missed"
/// is a share of what was there, and "false" one of what was reported; they are left out where there was
/// none, and stand in a quantity that counts other things than its package. Of shares of time there is only
/// the mean. Where the solution was switched, each has an entry of its own: "models/ball (kalman)".
nlohmann::json errorFigures(const robotlink::TruthErrors& errors);
/// The result of errorFigures() as a table for users, a line for each quantity; empty if there is none.
std::string errorsText(const nlohmann::json& figures);

}  // namespace app
