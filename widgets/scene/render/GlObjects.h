// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QSize>
#include <cstdint>
#include <map>
#include <string>

#include "robotlink/base/Error.h"
#include "widgets/scene/render/SceneMesh.h"

// OpenGL objects that delete themselves. All of them belong to the thread in which their context is current,
// and must be destroyed before it. OpenGL's names are plain unsigned integers here, so that its header is
// needed in sources only.
namespace widgets {

/// A linked program of a vertex and a fragment shader.
class GlProgram {
 public:
  /// Compiles and links; fails with the driver's message.
  static robotlink::Result<GlProgram> build(const char* vertexShader, const char* fragmentShader);
  ~GlProgram();
  GlProgram(GlProgram&& other) noexcept;
  GlProgram& operator=(GlProgram&&) = delete;

  /// Makes it the current program.
  void use() const;
  /// Sets a uniform of the current program; unknown names are ignored.
  void set(const char* uniform, const Eigen::Matrix4f& value);
  void set(const char* uniform, const Eigen::Vector4f& value);
  void set(const char* uniform, const Eigen::Vector3f& value);
  void set(const char* uniform, float value);

 private:
  explicit GlProgram(unsigned program) : program_(program) {}
  /// Location of a uniform, cached; -1: there is none.
  int location(const char* uniform);

  /// 0 after a move.
  unsigned program_;
  std::map<std::string, int> locations_;
};

/// A triangle mesh in the memory of the graphics card. Attributes: 0 position, 1 normal, 2 color.
class GlMesh {
 public:
  explicit GlMesh(const SceneMesh& mesh);
  ~GlMesh();
  GlMesh(const GlMesh&) = delete;
  GlMesh& operator=(const GlMesh&) = delete;
  /// Draws all triangles with the current program.
  void draw() const;
  /// Draws its edges (meshEdges()) with the current program, one pixel wide; `mesh` is that of which it was
  /// made. The edges are found in the first call.
  void drawEdges(const SceneMesh& mesh);

 private:
  unsigned array_ = 0, vertices_ = 0, indices_ = 0;
  int count_ = 0;
  /// Indices of edges, two each; 0 until they are drawn.
  unsigned edges_ = 0;
  int edgeCount_ = 0;
};

/// Line segments, drawn as instances of a rectangle. Attributes per instance: 0 from, 1 to, 2 color, 3 width.
class GlLines {
 public:
  explicit GlLines(const SceneLines& lines);
  ~GlLines();
  GlLines(const GlLines&) = delete;
  GlLines& operator=(const GlLines&) = delete;
  /// Draws all segments with the current program.
  void draw() const;

 private:
  unsigned array_ = 0, segments_ = 0;
  int count_ = 0;
};

/// A frame buffer with color, depth and stencil and one or several samples per pixel, and a second one with a
/// single sample, from which pixels are read.
class GlTarget {
 public:
  GlTarget(QSize size, int samples);
  ~GlTarget();
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  QSize size() const { return size_; }
  /// False if the driver does not support this size or number of samples.
  bool complete() const { return complete_; }
  /// Makes it the target of drawing and sets the viewport.
  void bind() const;
  /// Reads the pixels as BGRA, 4 bytes each without gaps between rows, bottom row of OpenGL first; with a
  /// projection that turns the picture upside down that is its top row.
  void read(std::uint8_t* to) const;

 private:
  QSize size_;
  bool complete_ = false;
  /// Frame buffers: for drawing, for reading.
  unsigned frames_[2] = {0, 0};
  /// Color and depth-stencil for drawing, color for reading.
  unsigned buffers_[3] = {0, 0, 0};
};

}  // namespace widgets
