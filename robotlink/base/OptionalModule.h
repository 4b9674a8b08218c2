// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotlink {

/// A shared library of this project for rarely used functions that depend on many other libraries: it is
/// loaded on first use instead of at every start. It is in lib/robotcontrol beside the folder
/// of the programs, in build folders as well as in installations. Never unloaded.
class OptionalModule {
 public:
  /// Loads "robotcontrol_video.so", say.
  explicit OptionalModule(const std::string& file);

  /// The function of this name, of the type that the module's header states; null if the module or the
  /// function is missing, and then problem() says why.
  template <typename Function>
  Function function(const char* name) {
    return reinterpret_cast<Function>(symbol(name));
  }
  /// Empty while nothing was missing.
  const std::string& problem() const { return problem_; }

 private:
  void* symbol(const char* name);

  void* library_ = nullptr;
  std::string problem_;
};

}  // namespace robotlink
