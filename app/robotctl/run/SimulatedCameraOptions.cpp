// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/SimulatedCameraOptions.h"

#include <CLI/CLI.hpp>

#include "app/core/platform/NumberRange.h"

namespace app {

void CameraOptions::addTo(CLI::App& command) {
  command.add_option("--light", lighting.brightness, "Brightness of all light, relative to the scene's")
      ->check(numberFrom(0, simcore::LightAdjustment::kMaxBrightness))
      ->capture_default_str();
  command.add_option("--warmth", lighting.warmth, "Color of all light: above 0 reddish, below 0 bluish")
      ->check(numberFrom(-1, 1))
      ->capture_default_str();
  command
      .add_option("--vignetting", vignetting,
                  "Fraction of light missing in the corners of images, and additional fraction of red and "
                  "green missing there (0), instead of the cameras' own")
      ->expected(1, 2)
      ->check(numberFrom(0, 1));
  command
      .add_option("--image-noise", imageNoise,
                  "Standard deviation of the images' noise, gray values, instead of the cameras' own")
      ->check(numberFrom(0, 100))
      ->excludes(command.get_option("--no-noise"));
  command.add_flag("--class-images", classImages,
                   "Publishes the true classes of all images, as oracle/classes, for recordings");
  auto* folder =
      command.add_option("--labelled-images", labeledFolder,
                         "Writes images into DIR/images and their true classes into DIR/labels, for "
                         "robotctl color evaluate");
  command
      .add_option("--images-every", labeledEvery,
                  "At most one of these images per robot in this many seconds")
      ->check(numberFrom(0, 1e6))
      ->capture_default_str()
      ->needs(folder);
}

void CameraOptions::applyTo(RunOptions& run) const {
  run.classImages = classImages;
  run.world.lighting = lighting;
  run.world.imageNoise = imageNoise;
  if (!vignetting.empty())
    run.world.vignetting = simcore::LensVignetting{vignetting[0], vignetting.size() > 1 ? vignetting[1] : 0};
}

robotlink::Result<std::unique_ptr<LabeledImages>> CameraOptions::labeledImages() const {
  if (labeledFolder.empty()) return nullptr;
  auto made = LabeledImages::create(labeledFolder, robotlink::fromSeconds(labeledEvery));
  if (!made) return tl::unexpected(made.error());
  return std::make_unique<LabeledImages>(std::move(*made));
}

}  // namespace app
