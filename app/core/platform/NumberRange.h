// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace app {

/// A validator for options with a number: "--speed FLOAT:0 to 100". CLI::Range writes such numbers with six
/// places.
inline CLI::Validator numberFrom(double min, double max) {
  return {[min, max](const std::string& text) {
            double number = 0;
            if (!CLI::detail::lexical_cast(text, number) || (number >= min && number <= max))
              return std::string();  // what is no number is refused when it is converted
            return fmt::format("the number must be between {:.15g} and {:.15g}, not {}", min, max, text);
          },
          fmt::format("{:.15g} to {:.15g}", min, max)};
}

/// Validators for options with a number from 0 on, or above 0. CLI11's own ones accept what is no number.
inline CLI::Validator numberAbove(bool orZero) {
  return {[orZero](const std::string& text) {
            double number = 0;
            const bool fits = !CLI::detail::lexical_cast(text, number) ||
                              (std::isfinite(number) && (number > 0 || (orZero && number == 0)));
            return fits ? std::string()
                        : fmt::format("the number must be {} 0, not {}", orZero ? "at least" : "above", text);
          },
          orZero ? "NONNEGATIVE" : "POSITIVE"};
}
inline CLI::Validator positiveNumber() {
  return numberAbove(false);
}
inline CLI::Validator nonNegativeNumber() {
  return numberAbove(true);
}

}  // namespace app
