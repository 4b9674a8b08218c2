// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <map>
#include <memory>
#include <string>

#include "robotlink/base/Error.h"
#include "widgets/scene/SceneFrame.h"

namespace widgets {

/// Draws pictures of a scene with OpenGL into images, without a window. Shapes stay on the graphics card as
/// long as each frame shows them. Everything happens in the thread that made it, where its context stays
/// current.
class SceneRenderer {
 public:
  /// Fails where there is no EGL or no OpenGL 3.3.
  static robotlink::Result<SceneRenderer> create();
  ~SceneRenderer();
  SceneRenderer(SceneRenderer&&) noexcept;
  SceneRenderer& operator=(SceneRenderer&&) = delete;

  /// Format_RGB32. A null image if the size is empty or too large.
  QImage render(const SceneFrame& frame);
  /// "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& device() const;

 private:
  struct State;
  explicit SceneRenderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace widgets
