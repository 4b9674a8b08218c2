// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// For the sources of the renderer only.
#include <Eigen/Core>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "widgets/scene/render/EglContext.h"
#include "widgets/scene/render/GlObjects.h"
#include "widgets/scene/render/SceneFrame.h"

namespace widgets {

/// A shape on the graphics card.
struct GpuShape {
  explicit GpuShape(std::shared_ptr<const SceneShape> from)
      : shape(std::move(from)), opaque(shape->opaque), translucent(shape->translucent), lines(shape->lines) {}
  std::shared_ptr<const SceneShape> shape;
  GlMesh opaque, translucent;
  GlLines lines;
  bool used = true;
};

/// The programs of the graphics card.
struct ScenePrograms {
  GlProgram sky, mesh, flat, edge, shadow, line;
  /// Fails with the driver's message.
  static robotlink::Result<ScenePrograms> build();
};

/// Red, green and blue from 0 to 1.
Eigen::Vector3f rgb(const QColor& color);
/// The pose of a body as programs take it.
Eigen::Matrix4f modelMatrix(const SceneBody& body);

/// The state that a SceneRenderer keeps from frame to frame, and the passes in which it draws one.
struct RendererState {
  using Bodies = std::vector<SceneBody>;
  RendererState(EglContext egl, ScenePrograms built);

  // SceneRenderer.cpp:
  /// Sets `target` for the frame's size and number of samples. False: the driver supports none.
  bool chooseTarget(const SceneFrame& frame);
  GpuShape& uploaded(const std::shared_ptr<const SceneShape>& shape);
  void forgetUnused();
  void prepare(const SceneFrame& frame);
  void drawSky(const SceneFrame& frame);
  void drawGrid(const SceneFrame& frame);
  void drawDrawings(const SceneFrame& frame);
  void drawTranslucent(const SceneFrame& frame);
  void drawLines(const SceneFrame& frame);
  /// Draws the solid parts of drawings of earlier frames: the ground and what is drawn now show through.
  void drawFaded(const SceneFrame& frame);
  void drawGhosts(const SceneFrame& frame);

  // SurfacePasses.cpp:
  /// What is solid in bodies that are not seen through.
  void drawOpaque(const SceneFrame& frame);
  void drawShadows(const SceneFrame& frame);
  /// Draws the solid parts of bodies that are seen through, the farthest first.
  void drawSeenThrough(const SceneFrame& frame);
  void drawSolids(const SceneFrame& frame);
  /// The edges of what is highlighted and cannot be moved.
  void drawOutlines(const SceneFrame& frame);
  /// Forgets the depth of everything drawn before.
  void drawMarkers(const SceneFrame& frame);
  /// Draws the surfaces of bodies that are lit.
  void drawLit(const SceneFrame& frame, const std::vector<const SceneBody*>& bodies);
  /// Draws the edges of bodies that are shown by them.
  void drawEdges(const SceneFrame& frame, const std::vector<const SceneBody*>& bodies);
  /// Draws the depths of what hides its own edges and those of others.
  void drawDepths(const std::vector<const SceneBody*>& bodies);

  void setMeshDefaults(const SceneFrame& frame);
  /// The same for a program that takes what that for meshes does.
  void setDefaults(GlProgram& program, const SceneFrame& frame);
  void setLight(const SceneLight& light);

  // Members are destroyed from the last to the first: the context goes last.
  EglContext context;
  ScenePrograms programs;
  unsigned nothing = 0;  // a vertex array without attributes
  std::unique_ptr<GlTarget> plainTarget, smoothTarget;
  GlTarget* target = nullptr;  // the target of this frame
  std::map<const SceneShape*, GpuShape> shapes;
  std::unique_ptr<GlLines> grid;
  QColor gridColor;
  Eigen::Matrix4f viewProjection;
};

}  // namespace widgets
