// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace simcore {

/// A world as its SDFormat 1.9 file describes it, checked and ready for any number of simulations. Immutable.
class Scene {
 public:
  struct Robot {
    std::string name;         ///< "red1"
    std::string description;  ///< which resources/robots/<description>.yaml it is: "ers210"
  };

  /// Reads a world file. `model://NAME` is looked for below the folder of the file and below
  /// resources/scenes/models. Every error carries file and line.
  static tl::expected<std::shared_ptr<const Scene>, robotlink::Errors> load(
      const std::filesystem::path& file);

  ~Scene();
  const std::filesystem::path& file() const;
  const std::vector<Robot>& robots() const;

  struct Implementation;
  const Implementation& implementation() const { return *implementation_; }

 private:
  Scene();
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace simcore
