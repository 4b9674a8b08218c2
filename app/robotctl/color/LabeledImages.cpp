// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/color/LabeledImages.h"

#include <fmt/format.h>

#include "app/platforms/simulated/world/TrueClasses.h"
#include "app/robotctl/color/ColorSubcommands.h"
#include "colortool/table/NamedColorTable.h"
#include "foxglove/Image.pb.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/packages/Conversions.h"

namespace app {

using robotlink::Result;

namespace {

Result<void> writePng(const std::filesystem::path& file, const robotlink::ImageView& image) {
  const auto png = logplayer::encodePng(image);
  if (!png) return tl::unexpected(png.error());
  return robotlink::writeFileAtomically(file, {reinterpret_cast<const char*>(png->data()), png->size()});
}

}  // namespace

Result<LabeledImages> LabeledImages::create(const std::filesystem::path& folder, robotlink::Duration period) {
  LabeledImages made;
  made.images_ = folder / "images";
  made.labels_ = folder / "labels";
  made.period_ = period;
  for (const auto& part : {made.images_, made.labels_}) {
    std::error_code error;
    std::filesystem::create_directories(part, error);
    if (error) {
      return robotlink::failure("image.folder",
                                "cannot make this folder for labeled images: " + error.message(),
                                {part.string(), 0, 0});
    }
  }
  const std::string names = colortool::colorClassesText(TrueClasses::classes());
  if (auto done = robotlink::writeFileAtomically(made.labels_ / kLabelClassesFile, names); !done)
    return tl::unexpected(done.error());
  return made;
}

void LabeledImages::add(const std::string& robot, const foxglove::RawImage& image,
                        const foxglove::RawImage& classes) {
  const robotlink::Instant now = robotlink::instant(image.timestamp());
  robotlink::Instant& due = due_[robot];
  if (!outcome_ || now < due) return;
  // Keeps to multiples of the period, whatever the times of the images.
  due = period_ > robotlink::Duration::zero() ? now - (now - due) % period_ + period_ : now;
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count();
  outcome_ = write(fmt::format("{}-{:06}.png", robot, ms), image, classes);
  if (outcome_) ++written_;
}

Result<void> LabeledImages::write(const std::string& name, const foxglove::RawImage& image,
                                  const foxglove::RawImage& classes) const {
  const robotlink::Image colors = robotlink::toRgbImage(robotlink::imageView(image));
  if (auto done = writePng(images_ / name, colors.view()); !done) return done;
  return writePng(labels_ / name, robotlink::imageView(classes));
}

}  // namespace app
