// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <map>
#include <memory>
#include <string>

#include "robotlink/base/Error.h"
#include "widgets/scene/render/SceneFrame.h"

namespace widgets {

struct RendererState;

/// Draws pictures of a scene with OpenGL into images, without a window. Shapes stay on the graphics card as
/// long as consecutive frames contain them. All functions must be called in the thread that created it, where
/// its context stays current.
class SceneRenderer {
 public:
  /// Fails if there is no EGL or no OpenGL 3.3.
  static robotlink::Result<SceneRenderer> create();
  ~SceneRenderer();
  SceneRenderer(SceneRenderer&&) noexcept;
  SceneRenderer& operator=(SceneRenderer&&) = delete;

  /// Draws a picture in Format_RGB32; null if its size is empty or too large.
  QImage render(const SceneFrame& frame);
  /// Name of the renderer: "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& device() const;

 private:
  explicit SceneRenderer(std::unique_ptr<RendererState> state);
  /// Context, programs, targets and shapes.
  std::unique_ptr<RendererState> state_;
};

}  // namespace widgets
