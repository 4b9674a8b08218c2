// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/OptionalModule.h"

#include <dlfcn.h>

#include <filesystem>

namespace robotlink {
namespace {

std::string lastLoadError() {
  const char* reason = ::dlerror();
  return reason != nullptr ? reason : "it has no such function";
}

}  // namespace

OptionalModule::OptionalModule(const std::string& file) {
  std::error_code error;  // without /proc the relative path is looked for
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto path = (program.parent_path() / "../lib/robotcontrol" / file).lexically_normal();
  library_ = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library_ == nullptr) problem_ = lastLoadError();
}

void* OptionalModule::symbol(const char* name) {
  if (library_ == nullptr) return nullptr;
  void* found = ::dlsym(library_, name);
  if (found == nullptr) problem_ = lastLoadError();
  return found;
}

}  // namespace robotlink
