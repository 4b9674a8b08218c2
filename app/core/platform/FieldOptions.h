// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/core/platform/PlatformForm.h"

namespace CLI {
class App;
}

namespace app {

/// The values that a command line gives for fields which have an option. Filled by the command line parser.
struct FieldOptions {
  /// Values by the names of the fields; those that were not given are missing.
  FormValues values = {};
  /// The values of fields that take several of them, in order.
  std::map<std::string, std::vector<FormValue>> lists = {};

  /// Adds the option of a field to a command, which checks the values that it gets; this object must outlive
  /// the command. Several fields may have the same option, which is added once.
  void addTo(CLI::App& command, const PlatformField& field);
  /// Whether the option of a field was given.
  bool given(const PlatformField& field) const;
};

}  // namespace app
