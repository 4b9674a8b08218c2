// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The shaders of SceneRenderer in GLSL 3.30. Matrices are stored as in Eigen (column-major). `projection`
// turns the picture upside down, so that the row that is read first is the upper one.
namespace widgets::shaders {

/// The sky: a triangle over the whole picture.
inline constexpr char kSkyVertex[] = R"(#version 330 core
out float height;
void main() {
  vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  height = 0.5 - 0.5 * at.y;
  gl_Position = vec4(at, 0.0, 1.0);
})";
/// A gradient from `top` to `bottom`.
inline constexpr char kSkyFragment[] = R"(#version 330 core
in float height;
uniform vec3 top;
uniform vec3 bottom;
out vec4 color;
void main() { color = vec4(mix(bottom, top, smoothstep(0.0, 1.0, height)), 1.0); })";

/// Meshes: soft light from the whole sky, a lamp, a weak specular reflection. Horizontal faces keep exactly
/// their own color. Light is computed at the vertices, since in software pixels are expensive.
inline constexpr char kMeshVertex[] = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
uniform mat4 model;
uniform mat4 viewProjection;
uniform vec3 eye;
uniform vec3 lamp;
uniform vec4 tint;
uniform float lit;
uniform vec3 light;
uniform float opacity;
out vec4 surface;
void main() {
  vec4 world = model * vec4(position, 1.0);
  vec3 toEye = normalize(eye - world.xyz);
  vec3 n = mat3(model) * normal;
  if (dot(n, toEye) < 0.0) n = -n;
  float ambient = mix(0.38, 0.48, 0.5 + 0.5 * n.z);
  float fill = 0.16 * max(dot(n, vec3(-0.53, 0.79, 0.30)), 0.0);  // from behind the lamp, so that no side is lost
  float diffuse = 0.56 * max(dot(n, lamp), 0.0) + fill;
  float shine = n.z > 0.999 ? 0.0 : 0.12 * pow(max(dot(n, normalize(lamp + toEye)), 0.0), 40.0);
  vec3 shaded = mix(color.rgb, min((color.rgb * (ambient + diffuse) + shine) * light, 1.0), lit);
  surface = vec4(mix(shaded, tint.rgb, tint.a), color.a * opacity);
  gl_Position = viewProjection * world;
})";
/// Meshes whose triangles have one color each: light as above, but without the reflection, for the triangle's
/// own normal.
inline constexpr char kFlatVertex[] = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 2) in vec4 color;
uniform mat4 model;
uniform mat4 viewProjection;
out vec3 place;
flat out vec4 faceColor;
void main() {
  vec4 world = model * vec4(position, 1.0);
  place = world.xyz;
  faceColor = color;
  gl_Position = viewProjection * world;
})";
inline constexpr char kFlatFragment[] = R"(#version 330 core
in vec3 place;
flat in vec4 faceColor;
uniform vec3 eye;
uniform vec3 lamp;
uniform vec4 tint;
uniform vec3 light;
uniform float opacity;
out vec4 color;
void main() {
  vec3 n = normalize(cross(dFdx(place), dFdy(place)));
  if (dot(n, eye - place) < 0.0) n = -n;
  float ambient = mix(0.38, 0.48, 0.5 + 0.5 * n.z);
  float diffuse = 0.56 * max(dot(n, lamp), 0.0) + 0.16 * max(dot(n, vec3(-0.53, 0.79, 0.30)), 0.0);
  vec3 shaded = min(faceColor.rgb * (ambient + diffuse) * light, 1.0);
  color = vec4(mix(shaded, tint.rgb, tint.a), faceColor.a * opacity);
})";

/// Edges of meshes, without light; `nearer` moves them toward the eye, by a share of the distance.
inline constexpr char kEdgeVertex[] = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 2) in vec4 color;
uniform mat4 model;
uniform mat4 viewProjection;
uniform vec4 tint;
uniform float opacity;
uniform float nearer;
out vec4 surface;
void main() {
  vec4 at = viewProjection * model * vec4(position, 1.0);
  surface = vec4(mix(color.rgb, tint.rgb, tint.a), color.a * opacity);
  gl_Position = vec4(at.xy, at.z - nearer * at.w, at.w);
})";
/// Meshes and lines: the interpolated color.
inline constexpr char kPlainFragment[] = R"(#version 330 core
in vec4 surface;
out vec4 color;
void main() { color = surface; })";

/// Shadows: meshes that `model` flattens onto the ground along the lamp's light.
inline constexpr char kShadowVertex[] = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 model;
uniform mat4 viewProjection;
void main() { gl_Position = viewProjection * model * vec4(position, 1.0); })";
/// A translucent black.
inline constexpr char kShadowFragment[] = R"(#version 330 core
out vec4 color;
void main() { color = vec4(0.0, 0.0, 0.0, 0.30); })";

/// Lines: rectangles along the segments that face the camera; one instance per segment, four vertices each.
inline constexpr char kLineVertex[] = R"(#version 330 core
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 color;
layout(location = 3) in float width;
uniform mat4 model;
uniform mat4 viewProjection;
uniform vec3 viewport;      // pixels; z: pixels of the device for one of the user's
uniform float pixelsPerMetre;  // at a distance of 1 m
uniform float opacity;
out vec4 surface;
void main() {
  vec4 a = viewProjection * model * vec4(from, 1.0);
  vec4 b = viewProjection * model * vec4(to, 1.0);
  const float near = 0.02;
  if (a.w < near && b.w < near) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); surface = vec4(0.0); return; }
  if (a.w < near) a = mix(a, b, (near - a.w) / (b.w - a.w));
  if (b.w < near) b = mix(b, a, (near - b.w) / (a.w - b.w));
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport.xy;
  along = length(along) > 1e-4 ? normalize(along) : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  bool start = gl_VertexID < 2;
  vec4 at = start ? a : b;
  float pixels = width > 0.0 ? width * viewport.z : max(1.0, -width * pixelsPerMetre / at.w);
  vec2 corner = across * ((gl_VertexID & 1) == 0 ? -1.0 : 1.0) + along * (start ? -0.5 : 0.5);
  surface = vec4(color.rgb, color.a * opacity);
  gl_Position = vec4(at.xy + corner * pixels / viewport.xy * at.w, at.z - 2e-4 * at.w, at.w);
})";

}  // namespace widgets::shaders
