// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"

namespace widgets {

/// An OpenGL 3.3 core context without window and display: EGL on Mesa's surfaceless platform, or else on the
/// first device that EGL lists. Uses a GPU if there is one, else Mesa's software renderer. There is no
/// default frame buffer; draw into a frame buffer object.
///
/// The context belongs to the thread in which it is created, where it stays current and must be destroyed.
/// EGL itself is never terminated, since that would unload drivers that others use.
class EglContext {
 public:
  /// Creates a context and makes it current. Fails, with EGL's error, if there is no EGL or no such context.
  static robotlink::Result<EglContext> create();
  ~EglContext();
  EglContext(EglContext&& other) noexcept;
  EglContext& operator=(EglContext&&) = delete;

  /// The name of the renderer: "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& renderer() const { return renderer_; }
  /// Whether the processor draws, not a GPU.
  bool software() const;

 private:
  EglContext(void* display, void* context, std::string renderer);

  /// EGLDisplay and EGLContext; the latter is null after a move.
  void* display_;
  void* context_;
  std::string renderer_;
};

}  // namespace widgets
