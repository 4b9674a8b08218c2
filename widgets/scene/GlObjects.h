// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QSize>
#include <cstdint>
#include <map>
#include <string>

#include "robotlink/base/Error.h"
#include "widgets/scene/SceneMesh.h"

namespace widgets {

// Objects of OpenGL that delete themselves. All of them belong to the thread in which their context is
// current, and must go before it does. Names of OpenGL are plain unsigned numbers, so that its header stays
// out of this one.

/// A vertex and a fragment shader.
class GlProgram {
 public:
  static robotlink::Result<GlProgram> build(const char* vertexShader, const char* fragmentShader);
  ~GlProgram();
  GlProgram(GlProgram&& other) noexcept;
  GlProgram& operator=(GlProgram&&) = delete;

  void use() const;
  void set(const char* uniform, const Eigen::Matrix4f& value);
  void set(const char* uniform, const Eigen::Vector4f& value);
  void set(const char* uniform, const Eigen::Vector3f& value);
  void set(const char* uniform, float value);

 private:
  explicit GlProgram(unsigned program) : program_(program) {}
  int location(const char* uniform);

  unsigned program_;
  std::map<std::string, int> locations_;
};

/// A mesh in the memory of the graphics card.
class GlMesh {
 public:
  explicit GlMesh(const SceneMesh& mesh);
  ~GlMesh();
  GlMesh(const GlMesh&) = delete;
  GlMesh& operator=(const GlMesh&) = delete;
  void draw() const;

 private:
  unsigned array_ = 0, vertices_ = 0, indices_ = 0;
  int count_ = 0;
};

/// Lines, each an instance of a rectangle.
class GlLines {
 public:
  explicit GlLines(const SceneLines& lines);
  ~GlLines();
  GlLines(const GlLines&) = delete;
  GlLines& operator=(const GlLines&) = delete;
  void draw() const;

 private:
  unsigned array_ = 0, segments_ = 0;
  int count_ = 0;
};

/// Pixels with depth and stencil to be drawn into, with one sample each or several, and plain pixels to be
/// read from.
class GlTarget {
 public:
  GlTarget(QSize size, int samples);
  ~GlTarget();
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  QSize size() const { return size_; }
  bool complete() const { return complete_; }
  void bind() const;
  /// BGRA, top row first if the picture was drawn upside down; `to` has 4 bytes a pixel and no gaps.
  void read(std::uint8_t* to) const;

 private:
  QSize size_;
  bool complete_ = false;
  unsigned frames_[2] = {0, 0};
  unsigned buffers_[3] = {0, 0, 0};
};

}  // namespace widgets
