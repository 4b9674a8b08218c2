// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/GlObjects.h"

#include <epoxy/gl.h>

#include <cstddef>
#include <utility>

#include "widgets/scene/render/MeshEdges.h"

namespace widgets {
namespace {

const void* offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr): OpenGL takes it so
}

robotlink::Result<GLuint> compiled(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint ok = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return shader;
  char log[1024] = "";
  glGetShaderInfoLog(shader, sizeof(log), nullptr, log);
  glDeleteShader(shader);
  return robotlink::failure("scene.shader", std::string("the graphics driver refuses a shader: ") + log);
}

void attribute(GLuint index, GLint size, GLenum type, bool normalized, std::size_t stride, std::size_t at) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, size, type, normalized ? GL_TRUE : GL_FALSE, static_cast<GLsizei>(stride),
                        offset(at));
}

template <typename T>
void upload(GLenum target, GLuint buffer, const std::vector<T>& data) {
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
}

}  // namespace

robotlink::Result<GlProgram> GlProgram::build(const char* vertexShader, const char* fragmentShader) {
  const auto vertex = compiled(GL_VERTEX_SHADER, vertexShader);
  if (!vertex) return tl::unexpected(vertex.error());
  const auto fragment = compiled(GL_FRAGMENT_SHADER, fragmentShader);
  if (!fragment) {
    glDeleteShader(*vertex);
    return tl::unexpected(fragment.error());
  }
  GlProgram program(glCreateProgram());
  for (const GLuint shader : {*vertex, *fragment}) {
    glAttachShader(program.program_, shader);
    glDeleteShader(shader);
  }
  glLinkProgram(program.program_);
  GLint ok = GL_FALSE;
  glGetProgramiv(program.program_, GL_LINK_STATUS, &ok);
  if (ok != GL_TRUE) return robotlink::failure("scene.shader", "the graphics driver does not link a shader");
  return program;
}

GlProgram::GlProgram(GlProgram&& other) noexcept
    : program_(std::exchange(other.program_, 0)), locations_(std::move(other.locations_)) {}

GlProgram::~GlProgram() {
  glDeleteProgram(program_);
}

void GlProgram::use() const {
  glUseProgram(program_);
}

int GlProgram::location(const char* uniform) {
  const auto [found, isNew] = locations_.try_emplace(uniform, -1);
  if (isNew) found->second = glGetUniformLocation(program_, uniform);
  return found->second;
}

void GlProgram::set(const char* uniform, const Eigen::Matrix4f& value) {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, value.data());
}
void GlProgram::set(const char* uniform, const Eigen::Vector4f& value) {
  glUniform4fv(location(uniform), 1, value.data());
}
void GlProgram::set(const char* uniform, const Eigen::Vector3f& value) {
  glUniform3fv(location(uniform), 1, value.data());
}
void GlProgram::set(const char* uniform, float value) {
  glUniform1f(location(uniform), value);
}

GlMesh::GlMesh(const SceneMesh& mesh) : count_(static_cast<int>(mesh.indices.size())) {
  using Vertex = SceneMesh::Vertex;
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(1, &vertices_);
  glGenBuffers(1, &indices_);
  upload(GL_ARRAY_BUFFER, vertices_, mesh.vertices);
  upload(GL_ELEMENT_ARRAY_BUFFER, indices_, mesh.indices);
  attribute(0, 3, GL_FLOAT, false, sizeof(Vertex), offsetof(Vertex, position));
  attribute(1, 3, GL_FLOAT, false, sizeof(Vertex), offsetof(Vertex, normal));
  attribute(2, 4, GL_UNSIGNED_BYTE, true, sizeof(Vertex), offsetof(Vertex, color));
}

GlMesh::~GlMesh() {
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &vertices_);
  glDeleteBuffers(1, &indices_);
  if (edges_ != 0) glDeleteBuffers(1, &edges_);
}

void GlMesh::draw() const {
  glBindVertexArray(array_);
  glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

void GlMesh::drawEdges(const SceneMesh& mesh) {
  glBindVertexArray(array_);
  if (edges_ == 0) {
    const std::vector<std::uint32_t> edges = meshEdges(mesh);
    edgeCount_ = static_cast<int>(edges.size());
    glGenBuffers(1, &edges_);
    upload(GL_ELEMENT_ARRAY_BUFFER, edges_, edges);
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, edges_);
  glDrawElements(GL_LINES, edgeCount_, GL_UNSIGNED_INT, nullptr);
  // The array remembers its last buffer of indices.
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
}

GlLines::GlLines(const SceneLines& lines) : count_(static_cast<int>(lines.segments.size())) {
  using Segment = SceneLines::Segment;
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(1, &segments_);
  upload(GL_ARRAY_BUFFER, segments_, lines.segments);
  attribute(0, 3, GL_FLOAT, false, sizeof(Segment), offsetof(Segment, from));
  attribute(1, 3, GL_FLOAT, false, sizeof(Segment), offsetof(Segment, to));
  attribute(2, 4, GL_UNSIGNED_BYTE, true, sizeof(Segment), offsetof(Segment, color));
  attribute(3, 1, GL_FLOAT, false, sizeof(Segment), offsetof(Segment, width));
  for (GLuint i = 0; i < 4; ++i) glVertexAttribDivisor(i, 1);
}

GlLines::~GlLines() {
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(1, &segments_);
}

void GlLines::draw() const {
  glBindVertexArray(array_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

GlTarget::GlTarget(QSize size, int samples) : size_(size) {
  glGenFramebuffers(2, frames_);
  glGenRenderbuffers(3, buffers_);
  const auto storage = [&](GLuint buffer, int samplesHere, GLenum format) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samplesHere, format, size.width(), size.height());
  };
  storage(buffers_[0], samples, GL_RGBA8);
  storage(buffers_[1], samples, GL_DEPTH24_STENCIL8);
  storage(buffers_[2], 0, GL_RGBA8);
  glBindFramebuffer(GL_FRAMEBUFFER, frames_[1]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers_[2]);
  const bool readable = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glBindFramebuffer(GL_FRAMEBUFFER, frames_[0]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers_[0]);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, buffers_[1]);
  complete_ = readable && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

GlTarget::~GlTarget() {
  glDeleteFramebuffers(2, frames_);
  glDeleteRenderbuffers(3, buffers_);
}

void GlTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frames_[0]);
  glViewport(0, 0, size_.width(), size_.height());
}

void GlTarget::read(std::uint8_t* to) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frames_[0]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frames_[1]);
  glBlitFramebuffer(0, 0, size_.width(), size_.height(), 0, 0, size_.width(), size_.height(),
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frames_[1]);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, size_.width(), size_.height(), GL_BGRA, GL_UNSIGNED_BYTE, to);
}

}  // namespace widgets
