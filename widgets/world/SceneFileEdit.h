// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace widgets {

/// A change of one element of a scene's file, as WorldProperty names it.
struct SceneFileEdit {
  std::string file;
  std::vector<std::string> element;
  /// The element's text from now on.
  std::string value;
};

}  // namespace widgets
