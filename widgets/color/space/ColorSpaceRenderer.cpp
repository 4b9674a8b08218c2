// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorSpaceRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "colortool/training/StrokeCells.h"

namespace widgets {

using colortool::CellSet;
using colortool::ColorClasses;
using colortool::ColorTable;
using Eigen::Vector3f;

namespace {

constexpr double kDimmed = 0.78;       // share of the background in what is not selected
constexpr double kHighlighted = 0.55;  // share of the highlight in a selected surface
constexpr std::array<std::uint8_t, 256> kSameClasses = [] {
  std::array<std::uint8_t, 256> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::uint8_t>(i);
  return numbers;
}();
constexpr QRgb kBackgroundClass = qRgb(128, 128, 128);
/// Offsets of depth: samples are drawn over pixels of their color, the rim of a point behind it. The rim of
/// selected pixels is so far behind that it surrounds groups instead of single ones.
constexpr float kInFront = 0.012F, kBehind = 0.002F, kFarBehind = 0.06F;

QRgb mix(QRgb a, QRgb b, double share) {
  const auto one = [share](int from, int to) {
    return from + static_cast<int>(std::lround(share * (to - from)));
  };
  return qRgb(one(qRed(a), qRed(b)), one(qGreen(a), qGreen(b)), one(qBlue(a), qBlue(b)));
}

QRgb qRgbOf(robotlink::Rgb color) {
  return qRgb(color.r, color.g, color.b);
}

QRgb classColor(const ColorClasses& classes, std::uint8_t colorClass) {
  if (colorClass == ColorClasses::kNone || colorClass >= classes.size()) return kBackgroundClass;
  return qRgbOf(classes.shownColor(colorClass));
}

/// Shades a color, slightly mixed with gray so that even black surfaces show their shape; `light` from 0 to
/// 1.
QRgb shaded(QRgb color, float light) {
  const QRgb lifted = mix(color, qRgb(130, 130, 130), 0.14);
  const double strength = 0.58 + 0.42 * static_cast<double>(light);
  return qRgb(static_cast<int>(qRed(lifted) * strength), static_cast<int>(qGreen(lifted) * strength),
              static_cast<int>(qBlue(lifted) * strength));
}

std::vector<bool> shownClasses(const ColorSpaceLook& look, const ColorClasses& classes) {
  std::vector<bool> shown(256, true);
  for (int i = 0; i < classes.size(); ++i) shown[static_cast<std::size_t>(i)] = look.shows(classes.name(i));
  return shown;
}

/// The table whose surfaces are shown; empty if there is nothing to show.
ColorTable surfaceTable(const ColorSpaceContents& contents, SurfacesOf surfaces) {
  if (surfaces == SurfacesOf::kTable) return contents.table == nullptr ? ColorTable() : *contents.table;
  if (contents.reference == nullptr) return {};
  if (surfaces == SurfacesOf::kReference || contents.table == nullptr) return *contents.reference;
  const auto now = contents.table->cells(), before = contents.reference->cells();
  std::vector<std::uint8_t> cells(now.begin(), now.end());
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::uint8_t changed = now[cell] == ColorClasses::kNone ? before[cell] : now[cell];
    cells[cell] = now[cell] == before[cell] ? ColorClasses::kNone : changed;
  }
  return ColorTable::translated(cells, kSameClasses);
}

CellSet cellsOf(const ColorTable& table, const std::vector<bool>& shown) {
  CellSet cells;
  const auto classes = table.cells();
  for (std::size_t cell = 0; cell < classes.size(); ++cell) {
    if (classes[cell] != ColorClasses::kNone && shown[classes[cell]]) cells.set(cell);
  }
  return cells;
}

CellSet both(const CellSet& a, const CellSet& b) {
  CellSet cells;
  for (std::size_t row = 0; row < CellSet::kRows; ++row) cells.row(row) = a.row(row) & b.row(row);
  return cells;
}

}  // namespace

bool ColorSpaceLook::shows(const std::string& className) const {
  return std::ranges::find(hidden, className) == hidden.end();
}

/// State of drawing one picture.
struct ColorSpaceRenderer::Drawing {
  const ColorSpaceRequest& request;
  const ColorSpaceContents& contents;
  ColorSpaceProjection projection;
  float scale = 1;  ///< raster pixels per logical pixel
  std::vector<bool> shownClasses = {};
  QRgb background = 0, highlight = 0;
  CellSet shown = {};
  CellSet selectionSeen = {};  ///< selected cells that are visible already

  bool selected(std::size_t cell) const {
    return contents.selection != nullptr && contents.selection->contains(cell);
  }
  /// Returns the color of something that belongs to a cell, dimmed if other cells are selected.
  QRgb dimmed(QRgb color, std::size_t cell) const {
    const bool plain = contents.selection == nullptr || selected(cell);
    return plain ? color : mix(color, background, kDimmed);
  }
  std::uint8_t classOf(std::size_t cell) const {
    return contents.table == nullptr ? ColorClasses::kNone : contents.table->cells()[cell];
  }
  int pixels(float ofWidget) const {
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(ofWidget * scale))));
  }
};

ColorSpacePicture ColorSpaceRenderer::render(std::shared_ptr<const ColorSpaceRequest> request) {
  const int reduction = request->smooth ? 2 : 1;
  const QSize size = request->pixels().expandedTo(QSize(1, 1)) * reduction;
  if (lattice_ == nullptr || lattice_->space() != request->look.space)
    lattice_ = std::make_shared<ColorLattice>(request->look.space);

  Drawing drawing{*request, *request->contents, ColorSpaceProjection(request->camera, size)};
  drawing.scale = static_cast<float>(request->ratio * reduction);
  drawing.shownClasses = shownClasses(request->look, request->contents->samples.classes);
  drawing.background = request->colors.background.rgb();
  drawing.highlight = request->colors.highlight.rgb();

  updateCloud(*request->contents);
  updateSamples(request->contents->samples);
  updateSurfaces(*request, drawing.projection.toViewer());
  solid_.reset(size);
  surfaces_.reset(size);
  if (request->look.table) drawSurfaces(drawing);
  if (request->look.pixels) drawPoints(drawing);
  if (request->look.samples) drawSamples(drawing);
  drawSelection(drawing);

  ColorSpaceLayers layers = compose(solid_, surfaces_, request->look.opacity, reduction);
  ColorSpacePicture picture;
  picture.image = std::move(layers.image);
  picture.cells = std::move(layers.cells);
  picture.lattice = lattice_;
  picture.cloud = cloud_;
  picture.shown = std::make_shared<CellSet>(drawing.shown);
  picture.request = std::move(request);
  return picture;
}

void ColorSpaceRenderer::updateCloud(const ColorSpaceContents& contents) {
  const bool sameImage = contents.frame == frame_ && contents.corrected == corrected_;
  if (sameImage && cloudLattice_ == lattice_) return;
  if (!sameImage) {
    frame_ = contents.frame;
    corrected_ = contents.corrected;
    cloud_ = frame_ == nullptr ? nullptr : clouds_.cloudOf(contents.pixels());
  }
  cloudLattice_ = lattice_;
  cloudPlaces_.clear();
  if (cloud_ == nullptr) return;
  for (const CloudPoint& point : cloud_->points)
    cloudPlaces_.push_back(colortool::placeIn(lattice_->space(), colortool::valueOf(point.color)));
}

void ColorSpaceRenderer::updateSamples(const colortool::Samples& samples) {
  if (samples == samples_) return;
  samples_ = samples;
  sampleCells_.clear();
  for (const colortool::StrokePtr& stroke : samples.strokes) {
    for (const colortool::StrokeCell& cell : colortool::strokeCells(samples, *stroke))
      sampleCells_.push_back({static_cast<std::uint32_t>(cell.cell), stroke->colorClass, stroke->mustNotBe});
  }
  std::ranges::sort(sampleCells_);
  sampleCells_.erase(std::unique(sampleCells_.begin(), sampleCells_.end()), sampleCells_.end());
}

void ColorSpaceRenderer::updateSurfaces(const ColorSpaceRequest& request, const Vector3f& toViewer) {
  const ColorSpaceLook& look = request.look;
  const ColorSpaceContents& contents = *request.contents;
  SurfaceKey key{look.table ? contents.table : nullptr,
                 look.table ? contents.reference : nullptr,
                 look.surfaces,
                 lattice_,
                 look.cut,
                 Vector3f::Zero(),
                 shownClasses(look, contents.samples.classes)};
  if (look.cut.along == ColorSpaceCut::Along::kView) key.toViewer = toViewer;
  if (key == surfaceKey_) return;
  const bool sameCut = key.lattice == surfaceKey_.lattice && key.cut == surfaceKey_.cut &&
                       key.toViewer == surfaceKey_.toViewer;
  if (!sameCut) left_ = cellsLeftBy(look.cut, *lattice_, toViewer);
  surfaceKey_ = std::move(key);
  faces_.clear();
  inside_ = {};
  if (!look.table) return;
  const ColorTable table = surfaceTable(contents, look.surfaces);
  inside_ = both(cellsOf(table, surfaceKey_.shownClasses), both(left_, lattice_->real()));
  faces_ = surfacesOf(table.cells(), inside_, *lattice_);
}

void ColorSpaceRenderer::drawPoints(Drawing& drawing) {
  if (cloud_ == nullptr) return;
  // Points grow with the number of pixels and, more slowly, with the zoom.
  const auto zoom = static_cast<float>(std::sqrt(drawing.request.camera.zoom));
  for (std::size_t i = 0; i < cloudPlaces_.size(); ++i) {
    const CloudPoint& point = cloud_->points[i];
    const std::size_t cell = ColorTable::cellOf(point.color);
    if (!left_.contains(cell) || !drawing.shownClasses[drawing.classOf(cell)]) continue;
    drawing.shown.set(cell);
    const Vector3f at = drawing.projection(cloudPlaces_[i]);
    const float size = zoom * (1.6F + 0.55F * std::log2(static_cast<float>(point.pixels)));
    const int diameter = drawing.pixels(std::min(size, 14.F));
    const auto id = static_cast<std::uint32_t>(cell);
    if (drawing.selected(cell)) {
      drawing.selectionSeen.set(cell);
      solid_.disc(at + Vector3f(0, 0, kFarBehind), diameter + 2 * drawing.pixels(1.5F), drawing.highlight,
                  id);
    }
    solid_.disc(at, diameter, drawing.dimmed(qRgbOf(robotlink::toRgb(point.color)), cell), id);
  }
}

void ColorSpaceRenderer::drawSamples(Drawing& drawing) {
  const ColorClasses& classes = samples_.classes;
  const int diameter = drawing.pixels(6.5F), rim = drawing.pixels(1.2F);
  for (const SampleCell& sample : sampleCells_) {
    if (!left_.contains(sample.cell) || !drawing.shownClasses[sample.colorClass]) continue;
    drawing.shown.set(sample.cell);
    const bool selected = drawing.selected(sample.cell);
    if (selected) drawing.selectionSeen.set(sample.cell);
    const QRgb color = classColor(classes, sample.colorClass);
    const QRgb contrast = qGray(color) > 110 ? qRgb(20, 20, 20) : qRgb(240, 240, 240);
    const Vector3f at = drawing.projection(lattice_->center(sample.cell)) - Vector3f(0, 0, kInFront);
    const auto draw = [&](int pixels, float behind, QRgb shade) {
      solid_.disc(at + Vector3f(0, 0, behind), pixels, drawing.dimmed(shade, sample.cell), sample.cell);
    };
    if (selected) draw(diameter + 4 * rim, 2 * kBehind, drawing.highlight);
    draw(diameter + 2 * rim, kBehind, contrast);
    draw(diameter, 0, color);
    // A stroke that says "must not be" is a ring in the color of its class.
    if (sample.mustNotBe) draw(std::max(1, diameter - 2 * rim - 1), -kBehind, contrast);
  }
}

void ColorSpaceRenderer::drawSurfaces(Drawing& drawing) {
  const ColorClasses& classes = samples_.classes;
  const Vector3f lamp = drawing.projection.rotation().transpose() * Vector3f(-0.35F, 0.5F, 0.79F);
  for (const SurfaceFace& face : faces_) {
    std::array<Vector3f, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = drawing.projection(lattice_->corner(face.corners[i]));
    const float light = std::max(0.F, face.normal.dot(lamp));
    QRgb color = shaded(classColor(classes, face.colorClass), light);
    if (drawing.selected(face.cell)) {
      color = mix(color, drawing.highlight, kHighlighted);
    } else {
      color = drawing.dimmed(color, face.cell);
    }
    surfaces_.quad(corners, color, face.cell);
  }
  // Cells inside of a surface can be selected as well.
  for (std::size_t row = 0; row < CellSet::kRows; ++row) drawing.shown.row(row) |= inside_.row(row);
}

void ColorSpaceRenderer::drawSelection(Drawing& drawing) {
  if (drawing.contents.selection == nullptr) return;
  // Selected cells that nothing else shows.
  const int diameter = drawing.pixels(2);
  for (std::size_t row = 0; row < CellSet::kRows; ++row) {
    CellSet::Row bits = drawing.contents.selection->row(row) & left_.row(row) &
                        ~drawing.selectionSeen.row(row) & ~drawing.shown.row(row);
    for (; bits != 0; bits &= bits - 1) {
      const std::size_t cell = row * 64 + static_cast<std::size_t>(__builtin_ctzll(bits));
      solid_.disc(drawing.projection(lattice_->center(cell)), diameter, drawing.highlight,
                  static_cast<std::uint32_t>(cell));
    }
  }
}

}  // namespace widgets
