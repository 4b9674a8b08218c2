// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"

namespace widgets {

/// An OpenGL 3.3 core context that needs no window and no display: EGL on Mesa's surfaceless platform, or
/// else on the first device that EGL lists. A GPU where there is one, Mesa's software otherwise. One draws
/// into a frame buffer object.
///
/// Belongs to the thread in which it was made current; made and destroyed there. EGL itself is never
/// terminated: that would unload drivers which others use.
class EglContext {
 public:
  /// Made current. Fails, with what EGL said, where there is no EGL or no such context.
  static robotlink::Result<EglContext> create();
  ~EglContext();
  EglContext(EglContext&& other) noexcept;
  EglContext& operator=(EglContext&&) = delete;

  /// "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& renderer() const { return renderer_; }
  /// No GPU: the processor draws.
  bool software() const;

 private:
  EglContext(void* display, void* context, std::string renderer);

  void* display_;
  void* context_;
  std::string renderer_;
};

}  // namespace widgets
