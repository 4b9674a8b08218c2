// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/SimulatedCameraOptions.h"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>

#include "tests/TestFolder.h"

namespace app {
namespace {

using testing::HasSubstr;

/// What a command line says about cameras.
class CameraOptionsTest : public testing::Test {
 protected:
  CameraOptionsTest() {
    command_.add_flag("--no-noise");
    options_.addTo(command_);
  }
  /// Why a command line is refused; empty: it is not.
  std::string parse(const std::string& line) {
    try {
      command_.parse(line);
    } catch (const CLI::ParseError& error) {
      return error.what();
    }
    return {};
  }
  RunOptions run(const std::string& line) {
    EXPECT_EQ(parse(line), "") << line;
    RunOptions run;
    options_.applyTo(run);
    return run;
  }

  CLI::App command_;
  CameraOptions options_;
};

TEST_F(CameraOptionsTest, withoutAnyTheCamerasAreTheirOwn) {
  const RunOptions made = run("");
  EXPECT_EQ(made.world.lighting, simcore::LightAdjustment());
  EXPECT_FALSE(made.world.imageNoise.has_value());
  EXPECT_FALSE(made.world.vignetting.has_value());
  EXPECT_FALSE(made.classImages);
  const auto writer = options_.labeledImages();
  ASSERT_TRUE(writer);
  EXPECT_EQ(*writer, nullptr);
}

TEST_F(CameraOptionsTest, lightAndLensAreThoseOfTheLine) {
  const RunOptions made =
      run("--light 0.5 --warmth -0.25 --vignetting 0.4 0.1 --image-noise 0 --class-images");
  EXPECT_EQ(made.world.lighting.brightness, 0.5);
  EXPECT_EQ(made.world.lighting.warmth, -0.25);
  EXPECT_EQ(made.world.vignetting, (simcore::LensVignetting{0.4, 0.1}));
  EXPECT_EQ(made.world.imageNoise, 0) << "none, rather than the cameras' own";
  EXPECT_TRUE(made.classImages);
}

TEST_F(CameraOptionsTest, aLensThatOnlyLosesLightKeepsItsColors) {
  EXPECT_EQ(run("--vignetting 0.4").world.vignetting, (simcore::LensVignetting{0.4, 0}));
}

TEST_F(CameraOptionsTest, whatIsOutOfRangeIsRefusedWithTheRange) {
  EXPECT_THAT(parse("--light 11"), HasSubstr("the number must be between 0 and 10, not 11"));
  EXPECT_THAT(parse("--warmth 1.5"), HasSubstr("between -1 and 1"));
  EXPECT_THAT(parse("--image-noise -1"), HasSubstr("between 0 and 100"));
  EXPECT_THAT(parse("--vignetting 2"), HasSubstr("between 0 and 1"));
  EXPECT_NE(parse("--light bright"), "");
}

TEST_F(CameraOptionsTest, noiseOfACertainStrengthIsNotNoNoise) {
  EXPECT_THAT(parse("--no-noise --image-noise 3"), HasSubstr("--no-noise"));
}

TEST_F(CameraOptionsTest, labeledImagesNeedAFolderThatCanBeMade) {
  EXPECT_THAT(parse("--images-every 2"), HasSubstr("--labelled-images"));
  const TestFolder folder;
  options_.labeledFolder = folder / "labeled";
  const auto writer = options_.labeledImages();
  ASSERT_TRUE(writer);
  EXPECT_NE(*writer, nullptr);
  EXPECT_EQ(folder.contents(), "labeled");
  options_.labeledFolder = folder.write("taken", "no folder");
  EXPECT_FALSE(options_.labeledImages());
}

}  // namespace
}  // namespace app
