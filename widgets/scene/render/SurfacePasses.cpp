// SPDX-License-Identifier: GPL-3.0-or-later
// SceneRenderer: how the surfaces of bodies are drawn, their shadows, what collides, and markers.
#include <epoxy/gl.h>

#include <algorithm>

#include "widgets/scene/render/RendererState.h"

namespace widgets {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;
using Eigen::Vector4f;
using BodyList = std::vector<const SceneBody*>;

constexpr float kShadowHeight = 0.003F;  // m above the ground
constexpr float kEdgeNearer = 2e-4F;     // of the distance, so that surfaces do not hide their own edges
constexpr float kHiddenSolid = 0.22F;    // opacity of edges of solids where something hides them

Vector3f lampDirection() {
  return Vector3f(0.30F, -0.45F, 0.84F).normalized();
}

/// The projection along the lamp's light onto the ground.
Matrix4f shadowMatrix() {
  const Vector3f lamp = lampDirection();
  Matrix4f matrix = Matrix4f::Identity();
  matrix(0, 2) = -lamp.x() / lamp.z();
  matrix(1, 2) = -lamp.y() / lamp.z();
  matrix(2, 2) = 0;
  matrix(2, 3) = kShadowHeight;
  return matrix;
}

bool isLit(Surface surface) {
  return surface == Surface::kShaded || surface == Surface::kFlat;
}

bool isHighlighted(const SceneFrame& frame, const SceneBody& body) {
  return !body.model.empty() && isPartOf(body, frame.highlighted);
}

Vector4f tintOf(const QColor& color, float share) {
  Vector4f tint;
  tint << rgb(color), share;
  return tint;
}

}  // namespace

void RendererState::setDefaults(GlProgram& program, const SceneFrame& frame) {
  program.use();
  program.set("viewProjection", viewProjection);
  program.set("eye", Vector3f(frame.camera.position().cast<float>()));
  program.set("lamp", lampDirection());
  program.set("tint", Vector4f(0, 0, 0, 0));
  program.set("lit", 1.F);
  program.set("light", Vector3f(1, 1, 1));
  program.set("opacity", 1.F);
}

void RendererState::setMeshDefaults(const SceneFrame& frame) {
  setDefaults(programs.mesh, frame);
}

void RendererState::setLight(const SceneLight& light) {
  programs.mesh.set("light", Vector3f(light.red, light.green, light.blue));
}

void RendererState::drawLit(const SceneFrame& frame, const BodyList& bodies) {
  const SceneLight& light = frame.contents.light;
  const Vector4f highlighted = tintOf(frame.colors.highlight, 0.35F), plain = Vector4f::Zero();
  const auto draw = [&](Surface surface, GlProgram& program) {
    bool isSet = false;
    for (const SceneBody* body : bodies) {
      if (body->surface != surface) continue;
      if (!isSet) {
        setDefaults(program, frame);
        program.set("light", Vector3f(light.red, light.green, light.blue));
        isSet = true;
      }
      program.set("tint", isHighlighted(frame, *body) ? highlighted : plain);
      program.set("opacity", body->opacity);
      program.set("model", modelMatrix(*body));
      uploaded(body->shape).opaque.draw();
    }
  };
  draw(Surface::kShaded, programs.mesh);
  draw(Surface::kFlat, programs.flat);
}

void RendererState::drawDepths(const BodyList& bodies) {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  programs.shadow.use();
  programs.shadow.set("viewProjection", viewProjection);
  for (const SceneBody* body : bodies) {
    if (body->surface != Surface::kHiddenLines) continue;
    programs.shadow.set("model", modelMatrix(*body));
    uploaded(body->shape).opaque.draw();
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void RendererState::drawEdges(const SceneFrame& frame, const BodyList& bodies) {
  // White lines would be invisible on a light sky.
  const Vector4f plain = tintOf(frame.colors.ink, 0.35F), highlighted = tintOf(frame.colors.highlight, 0.6F);
  bool isSet = false;
  for (const SceneBody* body : bodies) {
    if (isLit(body->surface)) continue;
    if (!isSet) {
      setDefaults(programs.edge, frame);
      programs.edge.set("nearer", kEdgeNearer);
      isSet = true;
    }
    programs.edge.set("tint", isHighlighted(frame, *body) ? highlighted : plain);
    programs.edge.set("opacity", body->opacity);
    programs.edge.set("model", modelMatrix(*body));
    uploaded(body->shape).opaque.drawEdges(body->shape->opaque);
  }
}

void RendererState::drawOpaque(const SceneFrame& frame) {
  BodyList bodies;
  bodies.reserve(frame.contents.bodies.size());
  bool hidesEdges = false;
  for (const SceneBody& body : frame.contents.bodies) {
    if (body.opacity < 1) continue;
    bodies.push_back(&body);
    hidesEdges = hidesEdges || body.surface == Surface::kHiddenLines;
  }
  drawLit(frame, bodies);
  if (hidesEdges) drawDepths(bodies);
  drawEdges(frame, bodies);
}

void RendererState::drawShadows(const SceneFrame& frame) {
  programs.shadow.use();
  programs.shadow.set("viewProjection", Matrix4f(viewProjection * shadowMatrix()));
  // The stencil makes each pixel be darkened only once.
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  glDepthMask(GL_FALSE);
  for (const SceneBody& body : frame.contents.bodies) {
    if (body.model.empty() || body.opacity < 1 || !isLit(body.surface)) continue;
    programs.shadow.set("model", modelMatrix(body));
    uploaded(body.shape).opaque.draw();
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_STENCIL_TEST);
}

void RendererState::drawSeenThrough(const SceneFrame& frame) {
  BodyList bodies;
  for (const SceneBody& body : frame.contents.bodies)
    if (body.opacity < 1) bodies.push_back(&body);
  if (bodies.empty()) return;
  const robotlink::Vector3 eye = frame.camera.position();
  std::ranges::stable_sort(bodies, std::ranges::greater(), [&](const SceneBody* body) {
    return (body->inField.translation() - eye).squaredNorm();
  });
  // Each body shows the surface toward the eye; what is in it shows through, whichever is drawn first. The
  // picture is upside down here, so that the order of corners is reversed.
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  glFrontFace(GL_CW);
  for (const SceneBody* body : bodies) drawLit(frame, {body});
  glDisable(GL_CULL_FACE);
  drawEdges(frame, bodies);
  glDepthMask(GL_TRUE);
}

void RendererState::drawSolids(const SceneFrame& frame) {
  if (frame.contents.solids.empty()) return;
  setDefaults(programs.edge, frame);
  programs.edge.set("nearer", kEdgeNearer);
  glDepthMask(GL_FALSE);
  const auto draw = [&](float share) {
    for (const SceneBody& solid : frame.contents.solids) {
      programs.edge.set("opacity", share * solid.opacity);
      programs.edge.set("model", modelMatrix(solid));
      GpuShape& gpu = uploaded(solid.shape);
      gpu.opaque.drawEdges(solid.shape->opaque);
    }
  };
  glDisable(GL_DEPTH_TEST);
  draw(kHiddenSolid);
  glEnable(GL_DEPTH_TEST);
  draw(1);
  glDepthMask(GL_TRUE);
}

void RendererState::drawOutlines(const SceneFrame& frame) {
  BodyList bodies;
  for (const SceneBody& body : frame.contents.bodies)
    if (body.model.empty() && isPartOf(body, frame.highlighted)) bodies.push_back(&body);
  if (bodies.empty()) return;
  setDefaults(programs.edge, frame);
  programs.edge.set("nearer", kEdgeNearer);
  programs.edge.set("tint", tintOf(frame.colors.outline, 1));
  glDepthMask(GL_FALSE);
  for (const SceneBody* body : bodies) {
    programs.edge.set("model", modelMatrix(*body));
    uploaded(body->shape).opaque.drawEdges(body->shape->opaque);
  }
  glDepthMask(GL_TRUE);
}

void RendererState::drawMarkers(const SceneFrame& frame) {
  if (frame.contents.markers.empty()) return;
  glClear(GL_DEPTH_BUFFER_BIT);
  setMeshDefaults(frame);
  for (const SceneBody& marker : frame.contents.markers) {
    programs.mesh.set("model", modelMatrix(marker));
    uploaded(marker.shape).opaque.draw();
  }
  glDepthMask(GL_FALSE);
  for (const SceneBody& marker : frame.contents.markers) {
    if (marker.shape->translucent.empty()) continue;
    programs.mesh.set("model", modelMatrix(marker));
    uploaded(marker.shape).translucent.draw();
  }
  programs.line.use();
  programs.line.set("opacity", 1.F);
  for (const SceneBody& marker : frame.contents.markers) {
    if (marker.shape->lines.segments.empty()) continue;
    programs.line.set("model", modelMatrix(marker));
    uploaded(marker.shape).lines.draw();
  }
  glDepthMask(GL_TRUE);
}

}  // namespace widgets
