// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "segmentation": regions of the field's colors in the camera's image.
#include <optional>

#include "PerceptionParameters.pb.h"
#include "colortool/correction/ImageCorrector.h"
#include "foxglove/Image.pb.h"
#include "modules/perception/FieldLandmarks.h"
#include "modules/perception/PerceptPackages.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

using colortool::RegionFinder;
using robotlink::ImageDrawingKey;
using robotlink::ImageKey;
using robotlink::PlotKey;

const ImageKey kClassesKey{"segmentation/classes", "The image in the colors of its pixels' classes"};
const ImageDrawingKey kRegionsKey{
    "segmentation/regions", "The boxes of all regions, in the colors of their classes (drawn in the image)"};
const PlotKey kCountKey{"segmentation/count", "How many regions were found"};

/// The common part of both solutions: the color table and the outputs. The table is the one that was sent to
/// the robot's program; without one it is computed from the field's colors, and recomputed when the lighting
/// parameters change.
class Segmentation : public robotlink::Solution {
 public:
  explicit Segmentation(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        field_(context.robot().field),
        classes_(fieldClasses(*field_)),
        image_(context.input(robotlink::kCameraImage)),
        given_(context.input(robotlink::kColorTable)),
        regions_(context.output(robotlink::kColorRegions)) {}

  void execute() override {
    tableIsNew_ = tableIsNew_ || given_.isNew();
    if (!image_ || !image_.isNew()) return;
    updateTable();
    table_.classify(correctedImage(), classImage_);
    const std::vector<colortool::Region>& found = find(classImage_.view());
    draw(found);

    auto package = std::make_shared<robotcontrol::ColorRegions>();
    *package->mutable_timestamp() = image_->timestamp();
    package->set_width(image_->width());
    package->set_height(image_->height());
    assign(*package, found, classes_);
    regions_.send(std::move(package));
  }

 protected:
  virtual const robotcontrol::Lighting& lighting() const = 0;
  virtual const std::vector<colortool::Region>& find(const robotlink::ImageView& classes) = 0;

 private:
  void updateTable() {
    if (given_ && !given_->cells().empty()) {
      if (!tableIsNew_) return;
      table_ = colorTable(*given_, classes_);
      corrector_.reset();
      if (given_->has_correction()) corrector_.emplace(colorCorrection(given_->correction()));
      tableLighting_.reset();
      tableIsNew_ = false;
      return;
    }
    const colortool::LightingRange wanted = lightingRange(lighting());
    if (tableLighting_ == wanted) return;
    table_ = fieldColorTable(*field_, classes_, wanted);
    corrector_.reset();
    tableLighting_ = wanted;
  }

  /// Valid until the next image.
  robotlink::ImageView correctedImage() {
    const robotlink::ImageView seen = robotlink::imageView(*image_);
    if (!corrector_) return seen;
    corrector_->correct(seen, correctedImage_);
    return correctedImage_.view();
  }

  void draw(const std::vector<colortool::Region>& found) {
    if (debug_.on(kClassesKey)) debug_.image(kClassesKey, shownImage(classImage_.view(), classes_).view());
    if (debug_.on(kCountKey)) debug_.plot(kCountKey, static_cast<double>(found.size()));
    if (!debug_.on(kRegionsKey)) return;
    auto drawing = debug_.imageDrawing(kRegionsKey);
    for (const colortool::Region& region : found)
      drawing.rectangle({region.left, region.top}, {region.right, region.bottom},
                        {classes_.shownColor(region.colorClass)});
  }

  robotlink::DebugContext& debug_;
  std::shared_ptr<const robotlink::FieldDescription> field_;
  colortool::ColorClasses classes_;
  colortool::ColorTable table_;
  // The lighting for which the table was computed; empty if the table was sent.
  std::optional<colortool::LightingRange> tableLighting_;
  // The table that was sent has not been evaluated yet.
  bool tableIsNew_ = true;
  // The corrector required by the table that was sent.
  std::optional<colortool::ImageCorrector> corrector_;
  robotlink::Image correctedImage_;
  robotlink::Image classImage_;
  robotlink::Input<foxglove::RawImage> image_;
  robotlink::Input<robotcontrol::ColorTable> given_;
  robotlink::Output<robotcontrol::ColorRegions> regions_;
};

class WholeImageSegmentation final : public Segmentation {
 public:
  explicit WholeImageSegmentation(robotlink::SolutionContext& context)
      : Segmentation(context),
        parameters_(context.parameters<robotcontrol::WholeImageSegmentationParameters>()) {}

 private:
  const robotcontrol::Lighting& lighting() const override { return parameters_.lighting(); }
  const std::vector<colortool::Region>& find(const robotlink::ImageView& classes) override {
    finder_.setOptions({parameters_.minimum_area(), parameters_.maximum_per_class()});
    return finder_.findInRows(classes);
  }

  const robotcontrol::WholeImageSegmentationParameters& parameters_;
  RegionFinder finder_{{}};
};

const robotlink::SolutionRegistration kWholeImage =
    robotlink::SolutionBuilder<WholeImageSegmentation>(
        "segmentation", "whole-image",
        "Assigns every pixel a color class by the color table and joins touching runs of equal class into "
        "regions.")
        .source(
            "J. Bruce, T. Balch, M. Veloso: Fast and inexpensive color image segmentation for interactive "
            "robots, 2000.")
        .needs(robotlink::kCameraImage)
        .uses(robotlink::kColorTable)
        .yields(robotlink::kColorRegions)
        .keys({&kClassesKey, &kRegionsKey, &kCountKey})
        .parameters<robotcontrol::WholeImageSegmentationParameters>();

class ScanLineSegmentation final : public Segmentation {
 public:
  explicit ScanLineSegmentation(robotlink::SolutionContext& context)
      : Segmentation(context),
        parameters_(context.parameters<robotcontrol::ScanLineSegmentationParameters>()) {}

 private:
  const robotcontrol::Lighting& lighting() const override { return parameters_.lighting(); }
  const std::vector<colortool::Region>& find(const robotlink::ImageView& classes) override {
    finder_.setOptions({parameters_.minimum_area(), parameters_.maximum_per_class()});
    return finder_.findInColumns(classes, parameters_.spacing());
  }

  const robotcontrol::ScanLineSegmentationParameters& parameters_;
  RegionFinder finder_{{}};
};

const robotlink::SolutionRegistration kScanLines =
    robotlink::SolutionBuilder<ScanLineSegmentation>(
        "segmentation", "scan-lines",
        "Reads vertical scan lines by the color table and groups runs of equal class on neighboring lines "
        "into regions.")
        .source("A method of this project.")
        .needs(robotlink::kCameraImage)
        .uses(robotlink::kColorTable)
        .yields(robotlink::kColorRegions)
        .keys({&kClassesKey, &kRegionsKey, &kCountKey})
        .parameters<robotcontrol::ScanLineSegmentationParameters>();

}  // namespace
}  // namespace modules
