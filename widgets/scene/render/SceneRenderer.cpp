// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/SceneRenderer.h"

#include <epoxy/gl.h>

#include <cmath>

#include "widgets/scene/render/EdgeSmoothing.h"
#include "widgets/scene/render/RendererState.h"
#include "widgets/scene/render/SceneGrid.h"
#include "widgets/scene/render/SceneShaders.h"

namespace widgets {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;
using Eigen::Vector4f;

constexpr int kLargest = 8192;  // largest width and height in pixels

}  // namespace

Vector3f rgb(const QColor& color) {
  return {static_cast<float>(color.redF()), static_cast<float>(color.greenF()),
          static_cast<float>(color.blueF())};
}

Matrix4f modelMatrix(const SceneBody& body) {
  return body.inField.matrix().cast<float>();
}

robotlink::Result<ScenePrograms> ScenePrograms::build() {
  auto sky = GlProgram::build(shaders::kSkyVertex, shaders::kSkyFragment);
  if (!sky) return tl::unexpected(sky.error());
  auto mesh = GlProgram::build(shaders::kMeshVertex, shaders::kPlainFragment);
  if (!mesh) return tl::unexpected(mesh.error());
  auto flat = GlProgram::build(shaders::kFlatVertex, shaders::kFlatFragment);
  if (!flat) return tl::unexpected(flat.error());
  auto edge = GlProgram::build(shaders::kEdgeVertex, shaders::kPlainFragment);
  if (!edge) return tl::unexpected(edge.error());
  auto shadow = GlProgram::build(shaders::kShadowVertex, shaders::kShadowFragment);
  if (!shadow) return tl::unexpected(shadow.error());
  auto line = GlProgram::build(shaders::kLineVertex, shaders::kPlainFragment);
  if (!line) return tl::unexpected(line.error());
  return ScenePrograms{std::move(*sky),  std::move(*mesh),   std::move(*flat),
                       std::move(*edge), std::move(*shadow), std::move(*line)};
}

RendererState::RendererState(EglContext egl, ScenePrograms built)
    : context(std::move(egl)), programs(std::move(built)) {
  glGenVertexArrays(1, &nothing);
}

robotlink::Result<SceneRenderer> SceneRenderer::create() {
  auto context = EglContext::create();
  if (!context) return tl::unexpected(context.error());
  auto programs = ScenePrograms::build();
  if (!programs) return tl::unexpected(programs.error());
  return SceneRenderer(std::make_unique<RendererState>(std::move(*context), *std::move(programs)));
}

SceneRenderer::SceneRenderer(std::unique_ptr<RendererState> state) : state_(std::move(state)) {}
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer::~SceneRenderer() = default;

const std::string& SceneRenderer::device() const {
  return state_->context.renderer();
}
QImage SceneRenderer::render(const SceneFrame& frame) {
  if (frame.pixels.isEmpty() || frame.pixels.width() > kLargest || frame.pixels.height() > kLargest)
    return {};
  if (!state_->chooseTarget(frame)) return {};
  state_->prepare(frame);
  state_->drawSky(frame);
  state_->drawOpaque(frame);
  if (frame.grid) state_->drawGrid(frame);
  if (frame.contents.shadows) state_->drawShadows(frame);
  state_->drawDrawings(frame);
  state_->drawSeenThrough(frame);
  state_->drawSolids(frame);
  state_->drawOutlines(frame);
  state_->drawGhosts(frame);
  state_->drawMarkers(frame);
  state_->forgetUnused();
  QImage picture(frame.pixels, QImage::Format_RGB32);
  state_->target->read(picture.bits());
  if (state_->target == state_->plainTarget.get()) picture = smoothEdges(picture);
  picture.setDevicePixelRatio(frame.pixelRatio);
  return picture;
}

bool RendererState::chooseTarget(const SceneFrame& frame) {
  constexpr int kSamples = 4;
  auto& chosen = frame.smooth || !context.software() ? smoothTarget : plainTarget;
  if (!chosen || chosen->size() != frame.pixels) {
    chosen.reset();
    chosen = std::make_unique<GlTarget>(frame.pixels, &chosen == &smoothTarget ? kSamples : 0);
  }
  target = chosen.get();
  return target->complete();
}

GpuShape& RendererState::uploaded(const std::shared_ptr<const SceneShape>& shape) {
  GpuShape& gpu = shapes.try_emplace(shape.get(), shape).first->second;
  gpu.used = true;
  return gpu;
}

void RendererState::forgetUnused() {
  std::erase_if(shapes, [](const auto& entry) { return !entry.second.used; });
  for (auto& [key, shape] : shapes) shape.used = false;
}

void RendererState::prepare(const SceneFrame& frame) {
  target->bind();
  Matrix4f flip = Matrix4f::Identity();
  flip(1, 1) = -1;
  const QSizeF size(frame.pixels);
  viewProjection = flip * (frame.camera.projection(size) * frame.camera.view()).cast<float>();
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  programs.line.use();
  programs.line.set("viewProjection", viewProjection);
  programs.line.set("viewport", Vector3f(static_cast<float>(size.width()), static_cast<float>(size.height()),
                                         static_cast<float>(frame.pixelRatio)));
  programs.line.set("pixelsPerMetre",
                    static_cast<float>(size.height() / 2 / std::tan(frame.camera.verticalAngle / 2)));
  programs.line.set("opacity", 1.F);
}

void RendererState::drawSky(const SceneFrame& frame) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  programs.sky.use();
  programs.sky.set("top", rgb(frame.colors.skyTop));
  programs.sky.set("bottom", rgb(frame.colors.skyBottom));
  glBindVertexArray(nothing);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
}

void RendererState::drawGrid(const SceneFrame& frame) {
  if (!grid || gridColor != frame.colors.grid) {
    gridColor = frame.colors.grid;
    grid = std::make_unique<GlLines>(gridLines(gridColor));
  }
  programs.line.use();
  programs.line.set("model", Matrix4f(Matrix4f::Identity()));
  glDepthMask(GL_FALSE);
  grid->draw();
  glDepthMask(GL_TRUE);
}

void RendererState::drawDrawings(const SceneFrame& frame) {
  setMeshDefaults(frame);
  for (const SceneBody& drawing : frame.contents.drawings) {
    if (drawing.opacity < 1) continue;
    programs.mesh.set("model", modelMatrix(drawing));
    uploaded(drawing.shape).opaque.draw();
  }
  glDepthMask(GL_FALSE);
  drawTranslucent(frame);
  drawLines(frame);
  glDepthMask(GL_TRUE);
  drawFaded(frame);
}

void RendererState::drawTranslucent(const SceneFrame& frame) {
  for (const auto* bodies : {&frame.contents.bodies, &frame.contents.drawings}) {
    setLight(bodies == &frame.contents.bodies ? frame.contents.light : SceneLight());
    for (const SceneBody& body : *bodies) {
      if (body.shape->translucent.empty()) continue;
      programs.mesh.set("model", modelMatrix(body));
      programs.mesh.set("opacity", body.opacity);
      uploaded(body.shape).translucent.draw();
    }
  }
}

void RendererState::drawLines(const SceneFrame& frame) {
  programs.line.use();
  for (const auto* bodies : {&frame.contents.bodies, &frame.contents.drawings}) {
    for (const SceneBody& body : *bodies) {
      if (body.shape->lines.segments.empty()) continue;
      programs.line.set("model", modelMatrix(body));
      programs.line.set("opacity", body.opacity);
      uploaded(body.shape).lines.draw();
    }
  }
}

void RendererState::drawFaded(const SceneFrame& frame) {
  setMeshDefaults(frame);
  for (const SceneBody& drawing : frame.contents.drawings) {
    if (drawing.opacity >= 1 || drawing.shape->opaque.empty()) continue;
    programs.mesh.set("model", modelMatrix(drawing));
    programs.mesh.set("opacity", drawing.opacity);
    const GlMesh& solid = uploaded(drawing.shape).opaque;
    // The depth alone first, so that of each pixel only the nearest surface is mixed in.
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    solid.draw();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    solid.draw();
  }
}

void RendererState::drawGhosts(const SceneFrame& frame) {
  if (frame.contents.ghosts.empty()) return;
  setMeshDefaults(frame);
  programs.mesh.set("opacity", 0.55F);
  Vector4f tint;
  tint << rgb(frame.contents.refused ? frame.colors.refused : frame.colors.ghost), 0.6F;
  programs.mesh.set("tint", tint);
  for (const SceneBody& ghost : frame.contents.ghosts) {
    programs.mesh.set("model", modelMatrix(ghost));
    uploaded(ghost.shape).opaque.draw();
  }
}

}  // namespace widgets
