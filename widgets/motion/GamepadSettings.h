// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "robotlink/base/Error.h"
#include "widgets/motion/GamepadBindings.h"

namespace widgets {

/// The user's gamepad settings, which are saved in a text file. GUI thread.
class GamepadSettings {
 public:
  /// Reads the file; an empty path: nothing is remembered.
  explicit GamepadSettings(std::filesystem::path file = {});

  /// The reason why the file could not be used, which was then put aside; unset otherwise.
  const std::optional<robotlink::Error>& problem() const { return problem_; }
  const GamepadBindings& bindings() const { return bindings_; }
  /// Uses other bindings from now on. Fails if the file cannot be written; they are used nevertheless.
  robotlink::Result<void> set(GamepadBindings bindings);

 private:
  void load();

  const std::filesystem::path file_;
  GamepadBindings bindings_;
  std::optional<robotlink::Error> problem_;
};

}  // namespace widgets
