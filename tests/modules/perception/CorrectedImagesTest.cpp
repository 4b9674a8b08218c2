// SPDX-License-Identifier: GPL-3.0-or-later
// Images with dark corners, in which the same color is another one there: a table segments them right if a
// correction comes with it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "colortool/image/ColorCorrection.h"
#include "colortool/table/ColorTable.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "tests/modules/perception/LoggedRobot.h"

using namespace modules;

namespace {

using colortool::ColorTable;
using robotlink::YCbCr;

constexpr int kWidth = 208, kHeight = 160, kSide = 24;
constexpr YCbCr kOrangeColor{150, 90, 190}, kWall{90, 90, 190};  // the wall is orange in the shade
constexpr double kDarkening = -0.5, kTint = 20;

/// The places of orange squares of kSide pixels: the image's corners and its middle.
constexpr std::pair<int, int> kSquares[] = {{0, 0}, {184, 0}, {0, 136}, {184, 136}, {92, 68}};

/// What a camera with a poor lens sees.
LoggedView view() {
  robotlink::Image image(kWidth, kHeight, robotlink::PixelFormat::kYuyv);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      YCbCr color = kWall;
      for (const auto& [left, top] : kSquares) {
        if (x >= left && x < left + kSide && y >= top && y < top + kSide) color = kOrangeColor;
      }
      const double r2 = colortool::squaredImageRadius(x, y, kWidth, kHeight);
      std::uint8_t* pixel = image.row(y) + 2 * x;
      pixel[0] = static_cast<std::uint8_t>(std::lround(color.y * (1 + kDarkening * r2)));
      pixel[1] = static_cast<std::uint8_t>(std::lround((x % 2 == 0 ? color.cb : color.cr) + kTint * r2));
    }
  }
  auto package = std::make_shared<foxglove::RawImage>();
  package->set_width(kWidth);
  package->set_height(kHeight);
  package->set_encoding("yuyv");
  package->set_step(static_cast<std::uint32_t>(image.step()));
  package->set_data(image.data.data(), image.data.size());
  return {package, std::make_shared<robotcontrol::CameraPose>(), {}};
}

/// Orange is what is as bright as it is, nearly.
robotcontrol::ColorTable orangeTable() {
  ColorTable table;
  for (int y = 135 / 4; y <= 165 / 4; ++y) {
    for (int cb = 80 / 4; cb <= 100 / 4; ++cb) {
      for (int cr = 180 / 4; cr <= 200 / 4; ++cr) table.setCell(y, cb, cr, 1);
    }
  }
  robotcontrol::ColorTable package;
  package.add_class_names("orange");
  package.set_cells(table.cells().data(), table.cells().size());
  return package;
}

robotcontrol::ColorTable correctedTable() {
  robotcontrol::ColorTable table = orangeTable();
  table.mutable_correction()->set_luma_r2(kDarkening);
  table.mutable_correction()->set_blue_r2(kTint);
  table.mutable_correction()->set_red_r2(kTint);
  return table;
}

class CorrectedImages : public testing::TestWithParam<const char*> {
 protected:
  /// How many squares are found whole, by a table.
  int squaresFound(const robotcontrol::ColorTable& table) {
    EXPECT_EQ(robot_.setColorTable(table), "");
    robot_.look(view());
    int found = 0;
    for (const auto& region : robot_.regions().regions()) {
      EXPECT_EQ(robot_.regions().class_names(static_cast<int>(region.color_class())), "orange");
      found += region.area() >= 0.95 * kSide * kSide && region.area() <= 1.05 * kSide * kSide ? 1 : 0;
    }
    return found;
  }

  LoggedRobot robot_{GetParam(), "region"};
};

}  // namespace

TEST_P(CorrectedImages, areSegmentedRightWithTheCorrectionAndWrongWithout) {
  EXPECT_EQ(squaresFound(orangeTable()), 1) << "the one in the middle";
  EXPECT_EQ(squaresFound(correctedTable()), 5);
  EXPECT_EQ(robot_.regions().regions_size(), 5);
  EXPECT_EQ(squaresFound(orangeTable()), 1) << "the correction goes with its table";
  EXPECT_TRUE(robot_.failures().empty());
}

TEST_P(CorrectedImages, camerasAreMadeLikeOthers) {
  robotcontrol::ColorTable table = correctedTable();
  table.mutable_correction()->mutable_y()->set_gain(1);
  table.mutable_correction()->mutable_y()->set_offset(60);
  EXPECT_EQ(squaresFound(table), 0) << "now the wall is as bright as orange was";
  EXPECT_EQ(robot_.regions().regions_size(), 1);
}

TEST_P(CorrectedImages, aCorrectionWithoutNumbersIsRefused) {
  robotcontrol::ColorTable table = correctedTable();
  table.mutable_correction()->set_luma_r4(std::numeric_limits<double>::infinity());
  EXPECT_EQ(robot_.setColorTable(table), "the color table's correction has values that are not numbers");
}

INSTANTIATE_TEST_SUITE_P(All, CorrectedImages, testing::Values("whole-image", "scan-lines"));
