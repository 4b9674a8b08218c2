// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/SceneRenderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

#include "widgets/scene/render/EdgeSmoothing.h"
#include "widgets/scene/render/EglContext.h"
#include "widgets/scene/render/GlObjects.h"
#include "widgets/scene/render/SceneGrid.h"
#include "widgets/scene/render/SceneShaders.h"

namespace widgets {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;
using Eigen::Vector4f;

constexpr int kLargest = 8192;           // largest width and height in pixels
constexpr float kShadowHeight = 0.003F;  // m above the ground

Vector3f lampDirection() {
  return Vector3f(0.30F, -0.45F, 0.84F).normalized();
}

Vector3f rgb(const QColor& color) {
  return {static_cast<float>(color.redF()), static_cast<float>(color.greenF()),
          static_cast<float>(color.blueF())};
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

struct GpuShape {
  explicit GpuShape(std::shared_ptr<const SceneShape> from)
      : shape(std::move(from)), opaque(shape->opaque), translucent(shape->translucent), lines(shape->lines) {}
  std::shared_ptr<const SceneShape> shape;
  GlMesh opaque, translucent;
  GlLines lines;
  bool used = true;
};

}  // namespace

struct SceneRenderer::State {
  State(EglContext egl, GlProgram skyProgram, GlProgram meshProgram, GlProgram shadowProgram,
        GlProgram lineProgram)
      : context(std::move(egl)),
        sky(std::move(skyProgram)),
        mesh(std::move(meshProgram)),
        shadow(std::move(shadowProgram)),
        line(std::move(lineProgram)) {
    glGenVertexArrays(1, &nothing);
  }

  /// Sets `target` for the frame's size and number of samples. False: the driver supports none.
  bool chooseTarget(const SceneFrame& frame);
  GpuShape& uploaded(const std::shared_ptr<const SceneShape>& shape);
  void forgetUnused();
  void prepare(const SceneFrame& frame);
  void drawSky(const SceneFrame& frame);
  void drawGrid(const SceneFrame& frame);
  void drawOpaque(const SceneFrame& frame);
  void drawShadows(const SceneFrame& frame);
  void drawDrawings(const SceneFrame& frame);
  void drawTranslucent(const SceneFrame& frame);
  void drawLines(const SceneFrame& frame);
  /// What is solid in drawings of earlier frames: the ground and what is drawn now show through.
  void drawFaded(const SceneFrame& frame);
  void drawGhosts(const SceneFrame& frame);
  void setMeshDefaults(const SceneFrame& frame);
  void setLight(const SceneLight& light);

  // Members are destroyed from the last to the first: the context goes last.
  EglContext context;
  GlProgram sky, mesh, shadow, line;
  unsigned nothing = 0;  // a vertex array without attributes
  std::unique_ptr<GlTarget> plainTarget, smoothTarget;
  GlTarget* target = nullptr;  // the target of this frame
  std::map<const SceneShape*, GpuShape> shapes;
  std::unique_ptr<GlLines> grid;
  QColor gridColor;
  Matrix4f viewProjection;
};

robotlink::Result<SceneRenderer> SceneRenderer::create() {
  auto context = EglContext::create();
  if (!context) return tl::unexpected(context.error());
  auto sky = GlProgram::build(shaders::kSkyVertex, shaders::kSkyFragment);
  if (!sky) return tl::unexpected(sky.error());
  auto mesh = GlProgram::build(shaders::kMeshVertex, shaders::kPlainFragment);
  if (!mesh) return tl::unexpected(mesh.error());
  auto shadow = GlProgram::build(shaders::kShadowVertex, shaders::kShadowFragment);
  if (!shadow) return tl::unexpected(shadow.error());
  auto line = GlProgram::build(shaders::kLineVertex, shaders::kPlainFragment);
  if (!line) return tl::unexpected(line.error());
  return SceneRenderer(std::make_unique<State>(std::move(*context), std::move(*sky), std::move(*mesh),
                                               std::move(*shadow), std::move(*line)));
}

SceneRenderer::SceneRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
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
  if (frame.grid) state_->drawGrid(frame);
  state_->drawOpaque(frame);
  if (!frame.wireFrame) state_->drawShadows(frame);
  state_->drawDrawings(frame);
  state_->drawGhosts(frame);
  state_->forgetUnused();
  QImage picture(frame.pixels, QImage::Format_RGB32);
  state_->target->read(picture.bits());
  if (state_->target == state_->plainTarget.get()) picture = smoothEdges(picture);
  picture.setDevicePixelRatio(frame.pixelRatio);
  return picture;
}

bool SceneRenderer::State::chooseTarget(const SceneFrame& frame) {
  constexpr int kSamples = 4;
  auto& chosen = frame.smooth || !context.software() ? smoothTarget : plainTarget;
  if (!chosen || chosen->size() != frame.pixels) {
    chosen.reset();
    chosen = std::make_unique<GlTarget>(frame.pixels, &chosen == &smoothTarget ? kSamples : 0);
  }
  target = chosen.get();
  return target->complete();
}

GpuShape& SceneRenderer::State::uploaded(const std::shared_ptr<const SceneShape>& shape) {
  GpuShape& gpu = shapes.try_emplace(shape.get(), shape).first->second;
  gpu.used = true;
  return gpu;
}

void SceneRenderer::State::forgetUnused() {
  std::erase_if(shapes, [](const auto& entry) { return !entry.second.used; });
  for (auto& [key, shape] : shapes) shape.used = false;
}

void SceneRenderer::State::prepare(const SceneFrame& frame) {
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
  line.use();
  line.set("viewProjection", viewProjection);
  line.set("viewport", Vector3f(static_cast<float>(size.width()), static_cast<float>(size.height()),
                                static_cast<float>(frame.pixelRatio)));
  line.set("pixelsPerMetre",
           static_cast<float>(size.height() / 2 / std::tan(SceneCamera::kVerticalAngle / 2)));
  line.set("opacity", 1.F);
}

void SceneRenderer::State::drawSky(const SceneFrame& frame) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  sky.use();
  sky.set("top", rgb(frame.colors.skyTop));
  sky.set("bottom", rgb(frame.colors.skyBottom));
  glBindVertexArray(nothing);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
}

void SceneRenderer::State::drawGrid(const SceneFrame& frame) {
  if (!grid || gridColor != frame.colors.grid) {
    gridColor = frame.colors.grid;
    grid = std::make_unique<GlLines>(gridLines(gridColor));
  }
  line.use();
  line.set("model", Matrix4f(Matrix4f::Identity()));
  glDepthMask(GL_FALSE);
  grid->draw();
  glDepthMask(GL_TRUE);
}

void SceneRenderer::State::setMeshDefaults(const SceneFrame& frame) {
  mesh.use();
  mesh.set("viewProjection", viewProjection);
  mesh.set("eye", Vector3f(frame.camera.position().cast<float>()));
  mesh.set("lamp", lampDirection());
  mesh.set("tint", Vector4f(0, 0, 0, 0));
  mesh.set("lit", 1.F);
  mesh.set("light", Vector3f(1, 1, 1));
  mesh.set("opacity", 1.F);
}

void SceneRenderer::State::setLight(const SceneLight& light) {
  mesh.set("light", Vector3f(light.red, light.green, light.blue));
}

void SceneRenderer::State::drawOpaque(const SceneFrame& frame) {
  setMeshDefaults(frame);
  setLight(frame.contents.light);
  glPolygonMode(GL_FRONT_AND_BACK, frame.wireFrame ? GL_LINE : GL_FILL);
  if (frame.wireFrame) mesh.set("lit", 0.F);
  Vector4f plain(0, 0, 0, 0), highlighted;
  // White lines would be invisible on a light sky.
  if (frame.wireFrame) plain << rgb(frame.colors.ink), 0.35F;
  highlighted << rgb(frame.colors.highlight), 0.35F;
  for (const SceneBody& body : frame.contents.bodies) {
    const bool shines = !body.model.empty() && body.model == frame.highlighted;
    mesh.set("tint", shines ? highlighted : plain);
    mesh.set("model", Matrix4f(body.inField.matrix().cast<float>()));
    uploaded(body.shape).opaque.draw();
  }
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void SceneRenderer::State::drawShadows(const SceneFrame& frame) {
  shadow.use();
  shadow.set("viewProjection", Matrix4f(viewProjection * shadowMatrix()));
  // The stencil makes each pixel be darkened only once.
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_EQUAL, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  glDepthMask(GL_FALSE);
  for (const SceneBody& body : frame.contents.bodies) {
    if (body.model.empty()) continue;
    shadow.set("model", Matrix4f(body.inField.matrix().cast<float>()));
    uploaded(body.shape).opaque.draw();
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_STENCIL_TEST);
}

void SceneRenderer::State::drawDrawings(const SceneFrame& frame) {
  setMeshDefaults(frame);
  for (const SceneBody& drawing : frame.contents.drawings) {
    if (drawing.opacity < 1) continue;
    mesh.set("model", Matrix4f(drawing.inField.matrix().cast<float>()));
    uploaded(drawing.shape).opaque.draw();
  }
  glDepthMask(GL_FALSE);
  drawTranslucent(frame);
  drawLines(frame);
  glDepthMask(GL_TRUE);
  drawFaded(frame);
}

void SceneRenderer::State::drawTranslucent(const SceneFrame& frame) {
  for (const auto* bodies : {&frame.contents.bodies, &frame.contents.drawings}) {
    setLight(bodies == &frame.contents.bodies ? frame.contents.light : SceneLight());
    for (const SceneBody& body : *bodies) {
      if (body.shape->translucent.empty()) continue;
      mesh.set("model", Matrix4f(body.inField.matrix().cast<float>()));
      mesh.set("opacity", body.opacity);
      uploaded(body.shape).translucent.draw();
    }
  }
}

void SceneRenderer::State::drawLines(const SceneFrame& frame) {
  line.use();
  for (const auto* bodies : {&frame.contents.bodies, &frame.contents.drawings}) {
    for (const SceneBody& body : *bodies) {
      if (body.shape->lines.segments.empty()) continue;
      line.set("model", Matrix4f(body.inField.matrix().cast<float>()));
      line.set("opacity", body.opacity);
      uploaded(body.shape).lines.draw();
    }
  }
}

void SceneRenderer::State::drawFaded(const SceneFrame& frame) {
  setMeshDefaults(frame);
  for (const SceneBody& drawing : frame.contents.drawings) {
    if (drawing.opacity >= 1 || drawing.shape->opaque.empty()) continue;
    mesh.set("model", Matrix4f(drawing.inField.matrix().cast<float>()));
    mesh.set("opacity", drawing.opacity);
    const GlMesh& solid = uploaded(drawing.shape).opaque;
    // The depth alone first, so that of each pixel only the nearest surface is mixed in.
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    solid.draw();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    solid.draw();
  }
}

void SceneRenderer::State::drawGhosts(const SceneFrame& frame) {
  if (frame.contents.ghosts.empty()) return;
  setMeshDefaults(frame);
  mesh.set("opacity", 0.55F);
  Vector4f tint;
  tint << rgb(frame.contents.refused ? frame.colors.refused : frame.colors.ghost), 0.6F;
  mesh.set("tint", tint);
  for (const SceneBody& ghost : frame.contents.ghosts) {
    mesh.set("model", Matrix4f(ghost.inField.matrix().cast<float>()));
    uploaded(ghost.shape).opaque.draw();
  }
}

}  // namespace widgets
