// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/pictures/VideoLibrary.h"

#include <dlfcn.h>

#include <filesystem>

namespace logplayer {
namespace {

/// Beside the programs, in a build folder and where they are installed.
std::filesystem::path moduleFile() {
  std::error_code error;  // without /proc the relative path is looked for
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  return (program.parent_path() / "../lib/robotcontrol/robotcontrol_video.so").lexically_normal();
}

}  // namespace

const VideoLibrary& videoLibrary() {
  static const VideoLibrary kLoaded = [] {
    VideoLibrary loaded;
    void* library = ::dlopen(moduleFile().c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library != nullptr) {
      loaded.open = reinterpret_cast<OpenVideo>(::dlsym(library, kOpenVideo));
      loaded.create = reinterpret_cast<CreateVideo>(::dlsym(library, kCreateVideo));
    }
    if (loaded.open == nullptr || loaded.create == nullptr) {
      const char* reason = ::dlerror();
      loaded = {nullptr, nullptr, reason != nullptr ? reason : "it has no function for it"};
    }
    return loaded;
  }();
  return kLoaded;
}

}  // namespace logplayer
