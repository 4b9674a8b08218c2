// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/CameraRenderer.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robotlink/base/Random.h"
#include "simcore/rendering/BodyTree.h"
#include "simcore/rendering/DrawableMesh.h"
#include "simcore/rendering/FrameMemory.h"
#include "simcore/rendering/LampTints.h"
#include "simcore/rendering/LensShading.h"
#include "simcore/rendering/ShadowCaster.h"

namespace simcore {
namespace {

using robotlink::PixelFormat;
using namespace rendering;

const Kernels& kernelsFor(CameraRenderer::Arithmetic arithmetic) {
#if defined(__x86_64__)
  if (arithmetic == CameraRenderer::Arithmetic::kFastest && __builtin_cpu_supports("avx2"))
    return kAvx2Kernels;
#else
  static_cast<void>(arithmetic);
#endif
  return kPortableKernels;
}

/// The fractions of red, green and blue that remain with a light's warmth.
struct LightColor {
  double red, green, blue;

  explicit LightColor(double warmth)
      : red(1 - std::max(-warmth, 0.0)), green(1 - std::abs(warmth) / 2), blue(1 - std::max(warmth, 0.0)) {}
  /// The color of the light as seen by a camera whose white balance makes another light white; the channels
  /// are scaled so that none exceeds 1.
  explicit LightColor(const LightAdjustment& lighting) : LightColor(lighting.warmth) {
    if (lighting.whiteBalance == 0) return;
    const LightColor white(lighting.whiteBalance);
    red /= white.red;
    green /= white.green;
    blue /= white.blue;
    const double largest = std::max({red, green, blue, 1.0});
    red /= largest;
    green /= largest;
    blue /= largest;
  }
};

/// A color under a light, in the channels of an image, chroma without its offset; with the coefficients of
/// robotlink::toYCbCr.
struct Channels {
  float value[3];

  Channels(Rgb color, const LightColor& light, PixelFormat format, double share = 1) {
    const double r = color.r * light.red * share, g = color.g * light.green * share,
                 b = color.b * light.blue * share;
    value[0] = static_cast<float>(r);
    value[1] = static_cast<float>(g);
    value[2] = static_cast<float>(b);
    if (format != PixelFormat::kYuyv) return;
    value[0] = static_cast<float>(0.299 * r + 0.587 * g + 0.114 * b);
    value[1] = static_cast<float>(-0.168736 * r - 0.331264 * g + 0.5 * b);
    value[2] = static_cast<float>(0.5 * r - 0.418688 * g - 0.081312 * b);
  }
};

int sum(const std::vector<RenderInstance>& instances, const std::vector<DrawableMesh>& meshes) {
  int triangles = 0;
  for (const RenderInstance& instance : instances) {
    triangles += meshes[static_cast<std::size_t>(instance.mesh)].streams().triangleGroups * 8;
  }
  return triangles;
}

template <typename Count>
int largest(const std::vector<DrawableMesh>& meshes, Count count) {
  int result = 0;
  for (const DrawableMesh& mesh : meshes) result = std::max(result, count(mesh.streams()) * 8);
  return result;
}

/// A mesh of the same triangles whose vertices have the triangle's normal.
Mesh withFlatNormals(const Mesh& mesh) {
  Mesh result;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    // DrawableMesh would drop it.
    if (std::ranges::any_of(triangle, [&](std::uint32_t i) { return i >= mesh.vertices.size(); })) continue;
    for (const std::uint32_t vertex : triangle) result.vertices.push_back(mesh.vertices[vertex]);
    const Eigen::Vector3f* const corner = &result.vertices[first];
    const Eigen::Vector3f normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
    result.normals.insert(result.normals.end(), 3, normal);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

std::vector<DrawableMesh> drawable(const std::vector<Mesh>& meshes, bool flat) {
  std::vector<DrawableMesh> result;
  result.reserve(meshes.size());
  for (const Mesh& mesh : meshes) {
    if (flat) {
      result.emplace_back(withFlatNormals(mesh));
    } else {
      result.emplace_back(mesh);
    }
  }
  return result;
}

/// The four side planes of a camera's field of view.
struct Frustum {
  double sinX, cosX, sinY, cosY;

  explicit Frustum(const CameraModel& camera)
      : sinX(std::sin(camera.horizontalAngle / 2)),
        cosX(std::cos(camera.horizontalAngle / 2)),
        sinY(std::sin(camera.verticalAngle / 2)),
        cosY(std::cos(camera.verticalAngle / 2)) {}
  bool mayShow(const Eigen::Vector3d& center, double radius) const {
    return center.x() * sinX - std::abs(center.y()) * cosX >= -radius &&
           center.x() * sinY - std::abs(center.z()) * cosY >= -radius;
  }
};

/// Sets the properties of a spot.
void aimSpot(const Lamp& lamp, const Pose3& worldInCamera, ShadeLamp& result) {
  if (lamp.kind != Lamp::Kind::kSpot) return;
  const Eigen::Vector3f direction = (worldInCamera.linear() * lamp.direction.cast<double>()).cast<float>();
  std::copy_n(direction.data(), 3, result.spotDirection);
  constexpr float kSharpest = 1e-4F;
  const float outer = std::cos(lamp.outerAngle / 2);
  result.spotFactor = 1 / std::max(kSharpest, std::cos(lamp.innerAngle / 2) - outer);
  result.spotOffset = -outer * result.spotFactor;
}

/// The data that renderers of a scene share: the scene as it is drawn, all poses, and the shadows. While
/// place() is not called, any number of threads may read it.
class RenderStage {
 public:
  RenderStage(std::shared_ptr<const RenderScene> ofScene, const CameraRenderer::Options& options)
      : scene(std::move(ofScene)),
        kernels(kernelsFor(options.arithmetic)),
        meshes(drawable(scene->meshes, options.flat)),
        meshInWorld(scene->instances.size()),
        centerInWorld(scene->instances.size()),
        bodyInWorld_(static_cast<std::size_t>(std::max(1, bodyCount(*scene))), Pose3::Identity()) {
    if (options.shadows && !scene->lamps.empty()) shadows.emplace(*scene, meshes, kernels);
  }

  void setPoses(std::span<const Pose3> bodyInWorld) {
    const std::size_t count = std::min(bodyInWorld.size(), bodyInWorld_.size());
    if (count > 1) std::copy_n(bodyInWorld.begin() + 1, count - 1, bodyInWorld_.begin() + 1);
    moved_ = true;
  }
  /// Computes what follows from the poses, if they have changed.
  void place() {
    if (!moved_) return;
    for (std::size_t i = 0; i < scene->instances.size(); ++i) {
      const RenderInstance& instance = scene->instances[i];
      meshInWorld[i] = bodyInWorld_[static_cast<std::size_t>(instance.body)] * instance.meshInBody;
      centerInWorld[i] = meshInWorld[i] * meshes[static_cast<std::size_t>(instance.mesh)].bound().center;
    }
    if (shadows) shadows->setPoses(bodyInWorld_);
    moved_ = false;
  }

  const std::shared_ptr<const RenderScene> scene;
  const Kernels& kernels;
  const std::vector<DrawableMesh> meshes;
  std::optional<ShadowCaster> shadows;
  // Keyed by instance; the centers are those of the bounding spheres.
  std::vector<Pose3> meshInWorld;
  std::vector<Eigen::Vector3d> centerInWorld;

 private:
  std::vector<Pose3> bodyInWorld_;
  bool moved_ = true;
};

}  // namespace

class CameraRenderer::Implementation {
 public:
  explicit Implementation(std::shared_ptr<RenderStage> stage)
      : stage_(std::move(stage)),
        memory_(largest(stage_->meshes, [](const MeshStreams& mesh) { return mesh.vertexGroups; }),
                largest(stage_->meshes, [](const MeshStreams& mesh) { return mesh.triangleGroups; }),
                sum(stage_->scene->instances, stage_->meshes), stage_->scene->lamps.size()),
        lamps_(stage_->scene->lamps.size()),
        tints_(stage_->scene->lamps) {}

  const std::shared_ptr<RenderStage>& stage() const { return stage_; }

  void render(const Pose3& cameraInWorld, const CameraModel& camera, PixelFormat format,
              const ImageNoise& noise, robotlink::Image& image);
  void setLighting(const LightAdjustment& lighting) { lighting_ = lighting; }
  void renderDepth(const Pose3& cameraInWorld, const CameraModel& camera, std::span<float> depth);
  void labelValues(std::span<const float> labels, float background, std::span<float> image) const;
  void addNoise(const ImageNoise& noise, robotlink::Image& image) const;
  void label(std::span<const std::uint8_t> labels, std::uint8_t background, robotlink::Image& image);

 private:
  /// An instance that may be visible in the last image, with the number of its first triangle's record.
  struct Drawn {
    std::size_t instance;
    std::int32_t firstRecord;
  };
  void drawInstances(const Pose3& cameraInWorld, const CameraModel& camera, PixelFormat format,
                     VisibilityBuffer& buffer);
  void placeLamps(const Pose3& worldInCamera);
  void lightStrip(Strip& strip, const VisibilityBuffer& buffer);
  /// The same where not all lamps are white: the colors of the strip are those in the lamps' light.
  void lightInColors(Strip& strip, const VisibilityBuffer& buffer, bool isLuma);

  const std::shared_ptr<RenderStage> stage_;
  FrameMemory memory_;
  /// In the order of LampTints.
  std::vector<ShadeLamp> lamps_;
  LampTints tints_;
  LightAdjustment lighting_;
  // State of the last image, for label().
  std::vector<Drawn> drawn_;
  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> recordLabels_;
};

void CameraRenderer::Implementation::drawInstances(const Pose3& cameraInWorld, const CameraModel& camera,
                                                   PixelFormat format, VisibilityBuffer& buffer) {
  const Pose3 worldInCamera = cameraInWorld.inverse(Eigen::Isometry);
  const Frustum frustum(camera);
  const LightColor light(lighting_);
  drawn_.clear();
  for (std::size_t i = 0; i < stage_->scene->instances.size(); ++i) {
    const RenderInstance& instance = stage_->scene->instances[i];
    const DrawableMesh& mesh = stage_->meshes[static_cast<std::size_t>(instance.mesh)];
    const Eigen::Vector3d center = worldInCamera * stage_->centerInWorld[i];
    if (!frustum.mayShow(center, mesh.bound().radius)) continue;
    const Eigen::Matrix<double, 3, 4> meshInCamera =
        (worldInCamera * stage_->meshInWorld[i]).matrix().topRows<3>();
    const Eigen::Vector3d cameraInMesh = stage_->meshInWorld[i].linear().transpose() *
                                         (cameraInWorld.translation() - stage_->meshInWorld[i].translation());
    DrawJob job;
    job.mesh = &mesh.streams();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        job.meshInCamera[row][column] = static_cast<float>(meshInCamera(row, column));
      }
      job.cameraInMesh[row] = static_cast<float>(cameraInMesh[row]);
    }
    std::copy_n(Channels(instance.color, light, format).value, 3, job.color);
    job.self = mesh.convex() ? static_cast<std::int32_t>(i) : -1;
    job.inFront = center.x() - mesh.bound().radius > 1e-3;
    drawn_.push_back({i, buffer.recordCount});
    stage_->kernels.draw(job, buffer);
  }
}

void CameraRenderer::Implementation::placeLamps(const Pose3& worldInCamera) {
  for (std::size_t i = 0; i < lamps_.size(); ++i) {
    const std::size_t number = tints_.order()[i];
    const Lamp& lamp = stage_->scene->lamps[number];
    const Eigen::Vector3f inCamera = (worldInCamera * placeOf(lamp).cast<double>()).cast<float>();
    std::copy_n(inCamera.data(), 3, lamps_[i].inCamera);
    aimSpot(lamp, worldInCamera, lamps_[i]);
    lamps_[i].intensity = static_cast<float>(peakOf(lamp) * lighting_.brightness);
    lamps_[i].attenuation = lamp.attenuation;
    if (stage_->shadows) {
      lamps_[i].cells = stage_->shadows->grid(number).cells();
      lamps_[i].nearest = stage_->shadows->grid(number).nearest();
    }
    lamps_[i].unsure = &memory_.unsure()[number];
  }
}

void CameraRenderer::Implementation::lightStrip(Strip& strip, const VisibilityBuffer& buffer) {
  for (UnsurePixels& pixels : memory_.unsure()) pixels.count = 0;
  stage_->kernels.shade(strip, buffer);
  for (std::size_t lamp = 0; lamp < lamps_.size(); ++lamp) {
    UnsurePixels& pixels = memory_.unsure()[lamp];
    if (pixels.count == 0) continue;
    stage_->shadows->addUnshadowed(lamp, pixels, buffer.stride, strip.light);
  }
}

void CameraRenderer::Implementation::lightInColors(Strip& strip, const VisibilityBuffer& buffer,
                                                   bool isLuma) {
  tints_.begin(strip, buffer);
  for (const LampTints::Group& group : tints_.groups()) {
    strip.lamps = &lamps_[group.first];
    strip.lampCount = static_cast<int>(group.count);
    lightStrip(strip, buffer);
    tints_.add(group, strip, buffer);
  }
  tints_.finish(strip, buffer, isLuma);
}

void CameraRenderer::Implementation::addNoise(const ImageNoise& noise, robotlink::Image& image) const {
  if (noise.sigma <= 0) return;
  const std::uint64_t bits = robotlink::hashBits(noise.seed, noise.stream, noise.frame);
  const NoiseKey key{static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)};
  // Rounding to whole gray values adds a variance of 1/12 (except for the smallest sigmas); the sum of four
  // uniform bytes has a variance of (256^2 - 1) / 3.
  const double variance = std::max(noise.sigma * noise.sigma - 1.0 / 12, 0.0);
  const double scale = std::sqrt(variance * 3 / 65535);
  stage_->kernels.addNoise(image.data.data(), static_cast<int>(image.data.size()), key,
                           static_cast<float>(scale));
}

void CameraRenderer::Implementation::render(const Pose3& cameraInWorld, const CameraModel& camera,
                                            PixelFormat format, const ImageNoise& noise,
                                            robotlink::Image& image) {
  image.format = format == PixelFormat::kYuyv ? PixelFormat::kYuyv : PixelFormat::kRgb8;
  image.width = std::max(0, format == PixelFormat::kYuyv ? camera.width & ~1 : camera.width);
  image.height = std::max(0, camera.height);
  image.data.resize(static_cast<std::size_t>(image.step()) * static_cast<std::size_t>(image.height));
  width_ = image.width;
  height_ = image.height;
  if (image.data.empty()) return;

  stage_->place();
  const Channels background(stage_->scene->background, LightColor(lighting_), image.format,
                            std::min(lighting_.brightness, 1.0));
  VisibilityBuffer& buffer = memory_.begin(camera, background.value);
  drawInstances(cameraInWorld, camera, image.format, buffer);
  placeLamps(cameraInWorld.inverse(Eigen::Isometry));

  Strip strip = memory_.strip();
  strip.ambient = static_cast<float>(stage_->scene->ambient * lighting_.brightness);
  strip.gridSize = LampGrid::kSize;
  strip.lampCount = static_cast<int>(lamps_.size());
  strip.lamps = lamps_.data();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      strip.cameraToWorld[row][column] = static_cast<float>(cameraInWorld.linear()(row, column));
    }
  }
  const LensShading lens(camera, image.format);
  const auto write =
      image.format == PixelFormat::kYuyv ? stage_->kernels.writeYuyv : stage_->kernels.writeRgb;
  for (int y = 0; y < camera.height; y += strip.rows) {
    strip.firstRow = y;
    strip.rows = std::min(memory_.rowsPerStrip(), camera.height - y);
    if (tints_.groups().empty()) {
      lightStrip(strip, buffer);
    } else {
      lightInColors(strip, buffer, image.format == PixelFormat::kYuyv);
    }
    if (lens.any()) lens.apply(strip, buffer.stride);
    for (int i = 0; i < strip.rows; ++i) {
      const int at = i * buffer.stride;
      const float* const color[3] = {strip.color[0] + at, strip.color[1] + at, strip.color[2] + at};
      write(strip.light + at, color, image.width, image.row(y + i));
    }
  }
  addNoise(noise, image);
}

void CameraRenderer::Implementation::label(std::span<const std::uint8_t> labels, std::uint8_t background,
                                           robotlink::Image& image) {
  image.format = PixelFormat::kMono8;
  image.width = width_;
  image.height = height_;
  image.data.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  if (image.data.empty()) return;
  const VisibilityBuffer& buffer = memory_.last();
  // Record 0 is the background; those of an instance extend to the first one of the next instance.
  recordLabels_.assign(static_cast<std::size_t>(buffer.recordCount), background);
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    if (drawn_[i].instance >= labels.size()) continue;
    const auto end = i + 1 < drawn_.size() ? drawn_[i + 1].firstRecord : buffer.recordCount;
    std::fill(recordLabels_.begin() + drawn_[i].firstRecord, recordLabels_.begin() + end,
              labels[drawn_[i].instance]);
  }
  for (int y = 0; y < height_; ++y) {
    const std::int32_t* const triangles = buffer.triangle + static_cast<std::ptrdiff_t>(y) * buffer.stride;
    std::uint8_t* const row = image.row(y);
    for (int x = 0; x < width_; ++x) row[x] = recordLabels_[static_cast<std::size_t>(triangles[x])];
  }
}

void CameraRenderer::Implementation::renderDepth(const Pose3& cameraInWorld, const CameraModel& camera,
                                                 std::span<float> depth) {
  width_ = camera.width;
  height_ = camera.height;
  stage_->place();
  const float black[3] = {};
  VisibilityBuffer& buffer = memory_.begin(camera, black);
  drawInstances(cameraInWorld, camera, PixelFormat::kRgb8, buffer);
  auto out = depth.begin();
  for (int y = 0; y < camera.height; ++y) {
    const float* const row = buffer.inverseDepth + static_cast<std::ptrdiff_t>(y) * buffer.stride;
    // Pixels that show nothing have an inverse depth of 0.
    for (int x = 0; x < camera.width; ++x) *out++ = 1 / row[x];
  }
}

void CameraRenderer::Implementation::labelValues(std::span<const float> labels, float background,
                                                 std::span<float> image) const {
  const VisibilityBuffer& buffer = memory_.last();
  std::vector<float> ofRecords(static_cast<std::size_t>(buffer.recordCount), background);
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    const std::int32_t end = i + 1 < drawn_.size() ? drawn_[i + 1].firstRecord : buffer.recordCount;
    const std::size_t instance = drawn_[i].instance;
    std::fill(ofRecords.begin() + drawn_[i].firstRecord, ofRecords.begin() + end,
              instance < labels.size() ? labels[instance] : background);
  }
  auto out = image.begin();
  for (int y = 0; y < height_; ++y) {
    const std::int32_t* const row = buffer.triangle + static_cast<std::ptrdiff_t>(y) * buffer.stride;
    for (int x = 0; x < width_; ++x) *out++ = ofRecords[static_cast<std::size_t>(row[x])];
  }
}

CameraRenderer::CameraRenderer(std::shared_ptr<const RenderScene> scene, Options options)
    : implementation_(
          std::make_unique<Implementation>(std::make_shared<RenderStage>(std::move(scene), options))) {}
CameraRenderer::CameraRenderer(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
CameraRenderer::~CameraRenderer() = default;

std::unique_ptr<CameraRenderer> CameraRenderer::another() const {
  return std::unique_ptr<CameraRenderer>(
      new CameraRenderer(std::make_unique<Implementation>(implementation_->stage())));
}

void CameraRenderer::setPoses(std::span<const Pose3> bodyInWorld) {
  implementation_->stage()->setPoses(bodyInWorld);
}

void CameraRenderer::place() {
  implementation_->stage()->place();
}

void CameraRenderer::render(const Pose3& cameraInWorld, const CameraModel& camera, PixelFormat format,
                            const ImageNoise& noise, robotlink::Image& image) {
  implementation_->render(cameraInWorld, camera, format, noise, image);
}

void CameraRenderer::setLighting(const LightAdjustment& lighting) {
  implementation_->setLighting(lighting);
}

void CameraRenderer::renderDepth(const Pose3& cameraInWorld, const CameraModel& camera,
                                 std::span<float> depth) {
  implementation_->renderDepth(cameraInWorld, camera, depth);
}

void CameraRenderer::labelValues(std::span<const float> labels, float background, std::span<float> image) {
  implementation_->labelValues(labels, background, image);
}

void CameraRenderer::addNoise(const ImageNoise& noise, robotlink::Image& image) const {
  implementation_->addNoise(noise, image);
}

void CameraRenderer::label(std::span<const std::uint8_t> labels, std::uint8_t background,
                           robotlink::Image& image) {
  implementation_->label(labels, background, image);
}

}  // namespace simcore
