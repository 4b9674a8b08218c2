// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture of the color space costs, 600 x 500 pixels: a noisy image of more colors than a real one
// has, a table of five classes, and samples. The same pixels and surfaces are also drawn by the renderer of
// the scene, with OpenGL.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "foxglove/Image.pb.h"
#include "robotlink/packages/Conversions.h"
#include "widgets/color/space/ColorSpaceRenderer.h"
#include "widgets/color/space/ColorSurface.h"
#include "widgets/scene/render/MeshBuilder.h"
#include "widgets/scene/render/SceneRenderer.h"

namespace {

using colortool::ColorTable;
using robotlink::YCbCr;
using widgets::ColorSpaceCut;

/// What a robot sees: ball, goals, field, lines and wall.
constexpr std::array<YCbCr, 6> kColors = {
    {{140, 60, 200}, {170, 40, 140}, {90, 150, 110}, {90, 110, 90}, {220, 128, 128}, {60, 128, 128}}};

widgets::ColorFramePtr noisyFrame(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> brightness(0, 22), chroma(0, 9);
  const auto value = [](double center, double off) {
    return static_cast<std::uint8_t>(std::clamp(center + off, 0.0, 255.0));
  };
  robotlink::Image image(640, 480, robotlink::PixelFormat::kYuyv);
  for (std::size_t i = 0; i < image.data.size(); i += 4) {
    const YCbCr color = kColors[i / 4 % kColors.size()];
    image.data[i] = value(color.y, brightness(random));
    image.data[i + 1] = value(color.cb, chroma(random));
    image.data[i + 2] = value(color.y, brightness(random));
    image.data[i + 3] = value(color.cr, chroma(random));
  }
  auto message = std::make_shared<foxglove::RawImage>();
  robotlink::assign(*message, image.view(), {}, "camera");
  return std::make_shared<widgets::ColorFrame>(message, "red1/camera/image", "", robotlink::Instant{});
}

std::shared_ptr<const ColorTable> tableOfColors(double reach) {
  auto table = std::make_shared<ColorTable>();
  for (int y = 0; y < ColorTable::kCells; ++y) {
    for (int cb = 0; cb < ColorTable::kCells; ++cb) {
      for (int cr = 0; cr < ColorTable::kCells; ++cr) {
        double nearest = reach;
        for (std::size_t i = 0; i + 1 < kColors.size(); ++i) {
          const double distance =
              std::hypot(0.4 * (4 * y - kColors[i].y), 4 * cb - kColors[i].cb, 4 * cr - kColors[i].cr);
          if (distance >= nearest) continue;
          nearest = distance;
          table->setCell(y, cb, cr, static_cast<std::uint8_t>(i + 1));
        }
      }
    }
  }
  return table;
}

colortool::Samples samplesOf(const widgets::ColorFrame& frame) {
  colortool::Samples samples;
  samples.classes = colortool::ColorClasses({{"orange", {255, 105, 0}},
                                             {"yellow", {250, 215, 0}},
                                             {"blue", {15, 30, 130}},
                                             {"green", {0, 130, 50}},
                                             {"white", {235, 235, 235}}});
  for (int i = 0; i < 60; ++i) {
    const colortool::ImagePoint at[] = {{10.0 + 10 * i, 8.0 * i + 4}};
    colortool::addStroke(samples, frame.place(), frame.colors(),
                         colortool::brushArea(frame.width(), frame.height(), at, 3),
                         {static_cast<std::uint8_t>(i % 6), false, 1, "brush"});
  }
  return samples;
}

struct Desk {
  widgets::ColorSpaceRenderer renderer;
  widgets::ColorSpaceContents contents;
  widgets::ColorSpaceRequest request;
  std::size_t colors = 0;

  Desk() {
    contents.frame = noisyFrame(1);
    contents.table = tableOfColors(32);
    contents.samples = samplesOf(*contents.frame);
    request.colors = {QColor(40, 40, 40), QColor(255, 0, 200)};
    request.widget = {600, 500};
    draw();
  }
  void draw() {
    request.contents = std::make_shared<widgets::ColorSpaceContents>(contents);
    const auto picture = renderer.render(std::make_shared<widgets::ColorSpaceRequest>(request));
    colors = picture.cloud->points.size();
  }
};

void turning(benchmark::State& state) {
  Desk desk;
  desk.request.look.space = static_cast<colortool::ColorSpace>(state.range(0));
  desk.draw();
  for (auto unused : state) {
    static_cast<void>(unused);
    desk.request.camera.turn({3, 1});
    desk.draw();
  }
  state.counters["colors"] = static_cast<double>(desk.colors);
}
BENCHMARK(turning)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

void turningACutAcrossTheView(benchmark::State& state) {
  Desk desk;
  desk.request.look.cut.along = ColorSpaceCut::Along::kView;
  for (auto unused : state) {
    static_cast<void>(unused);
    desk.request.camera.turn({3, 1});
    desk.draw();
  }
}
BENCHMARK(turningACutAcrossTheView)->Unit(benchmark::kMillisecond);

void withSmoothEdges(benchmark::State& state) {
  Desk desk;
  desk.request.smooth = true;
  for (auto unused : state) {
    static_cast<void>(unused);
    desk.draw();
  }
}
BENCHMARK(withSmoothEdges)->Unit(benchmark::kMillisecond);

void anotherImage(benchmark::State& state) {
  Desk desk;
  const std::array frames = {noisyFrame(2), noisyFrame(3)};
  std::size_t i = 0;
  for (auto unused : state) {
    static_cast<void>(unused);
    desk.contents.frame = frames[i++ % frames.size()];
    desk.draw();
  }
}
BENCHMARK(anotherImage)->Unit(benchmark::kMillisecond);

void anotherTable(benchmark::State& state) {
  Desk desk;
  const std::array tables = {tableOfColors(28), tableOfColors(34)};
  std::size_t i = 0;
  for (auto unused : state) {
    static_cast<void>(unused);
    desk.contents.table = tables[i++ % tables.size()];
    desk.draw();
  }
}
BENCHMARK(anotherTable)->Unit(benchmark::kMillisecond);

void anotherSpace(benchmark::State& state) {
  Desk desk;
  for (auto unused : state) {
    static_cast<void>(unused);
    auto& space = desk.request.look.space;
    space = space == colortool::ColorSpace::kHsi ? colortool::ColorSpace::kTsl : colortool::ColorSpace::kHsi;
    desk.draw();
  }
}
BENCHMARK(anotherSpace)->Unit(benchmark::kMillisecond);

/// The color space as a shape of the scene, in its cheapest form: a square for each color of the image, and
/// the translucent faces of the table's surfaces. What the scene's renderer lacks is left out in its favor:
/// squares neither hide each other nor are hidden in the right order by surfaces, nothing is marked as
/// selected, and nothing says which cell a pixel shows.
std::shared_ptr<const widgets::SceneShape> sceneOf(const Desk& desk, const ColorTable& table) {
  const auto place = [](const Eigen::Vector3f& at) { return std::array<float, 3>{at.x(), at.y(), at.z()}; };
  auto shape = std::make_shared<widgets::SceneShape>();
  const widgets::ColorLattice lattice(colortool::ColorSpace::kYCbCr);
  widgets::CloudMaker clouds;
  const auto cloud = clouds.cloudOf(desk.contents.pixels());
  for (const widgets::CloudPoint& point : cloud->points) {
    const auto at = place(colortool::placeIn(lattice.space(), colortool::valueOf(point.color)));
    const robotlink::Rgb color = robotlink::toRgb(point.color);
    const float size = std::round(1.6F + 0.55F * std::log2(static_cast<float>(point.pixels)));
    shape->lines.segments.push_back({at, at, {color.r, color.g, color.b, 255}, std::min(size, 14.F)});
  }
  for (const auto& face : widgets::surfacesOf(table.cells(), lattice.real(), lattice)) {
    const robotlink::Rgb color = desk.contents.samples.classes.shownColor(face.colorClass);
    const auto first = static_cast<std::uint32_t>(shape->translucent.vertices.size());
    for (const std::uint32_t corner : face.corners)
      shape->translucent.vertices.push_back(
          {place(lattice.corner(corner)), place(face.normal), {color.r, color.g, color.b, 115}});
    for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) shape->translucent.indices.push_back(first + i);
  }
  return shape;
}

/// Draws the shape of a color space with OpenGL, offscreen, as the scene is drawn.
class SceneDesk {
 public:
  explicit SceneDesk(benchmark::State& state) : renderer_(widgets::SceneRenderer::create()) {
    if (!renderer_) {
      state.SkipWithError(renderer_.error().describe().c_str());
      return;
    }
    state.SetLabel(renderer_->device());
    frame_.pixels = {600, 500};
    frame_.grid = false;
    frame_.camera.distance = 2.6;  // the cube fills the picture
  }
  explicit operator bool() const { return renderer_.has_value(); }
  void show(std::shared_ptr<const widgets::SceneShape> shape) {
    frame_.contents.drawings = {{std::move(shape), robotlink::Pose3::Identity(), {}}};
  }
  void smooth() { frame_.smooth = true; }
  void turn() {
    frame_.camera.orbit({3, 1});
    benchmark::DoNotOptimize(renderer_->render(frame_));
  }

 private:
  robotlink::Result<widgets::SceneRenderer> renderer_;
  widgets::SceneFrame frame_;
};

void turningWithOpenGl(benchmark::State& state) {
  const Desk desk;
  SceneDesk scene(state);
  if (!scene) return;
  scene.show(sceneOf(desk, *desk.contents.table));
  if (state.range(0) != 0) scene.smooth();
  scene.turn();
  for (auto unused : state) {
    static_cast<void>(unused);
    scene.turn();
  }
}
BENCHMARK(turningWithOpenGl)->ArgName("smooth")->Arg(0)->Arg(1)->UseRealTime()->Unit(benchmark::kMillisecond);

void anotherTableWithOpenGl(benchmark::State& state) {
  const Desk desk;
  SceneDesk scene(state);
  if (!scene) return;
  const std::array tables = {tableOfColors(28), tableOfColors(34)};
  std::size_t i = 0;
  for (auto unused : state) {
    static_cast<void>(unused);
    scene.show(sceneOf(desk, *tables[i++ % tables.size()]));
    scene.turn();
  }
}
BENCHMARK(anotherTableWithOpenGl)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
