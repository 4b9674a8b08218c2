// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/PixelArea.h"

#include <gtest/gtest.h>

#include <random>

using namespace colortool;

namespace {

/// Rows of an area: '#' for a pixel of it.
std::vector<std::string> picture(const PixelArea& area, int width, int height) {
  std::vector<std::string> rows(static_cast<std::size_t>(height),
                                std::string(static_cast<std::size_t>(width), '.'));
  for (const PixelRun& run : area) {
    for (int x = run.begin; x < run.end; ++x)
      rows.at(static_cast<std::size_t>(run.y)).at(static_cast<std::size_t>(x)) = '#';
  }
  return rows;
}

PixelArea areaOf(const std::vector<std::string>& rows) {
  PixelArea area;
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < rows[y].size(); ++x) {
      if (rows[y][x] != '#') continue;
      const std::size_t begin = x;
      while (x < rows[y].size() && rows[y][x] == '#') ++x;
      area.push_back({static_cast<int>(y), static_cast<int>(begin), static_cast<int>(x)});
    }
  }
  return area;
}

ColorImage imageOf(const std::vector<std::string>& rows) {
  ColorImage image(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  auto pixel = image.pixels.begin();
  for (const std::string& row : rows) {
    for (const char letter : row)
      *pixel++ = letter == 'o' ? robotlink::YCbCr{120, 90, 200} : robotlink::YCbCr{80, 110, 100};
  }
  return image;
}

using Rows = std::vector<std::string>;

TEST(PixelArea, aCarefulBrushLeavesOutWhatIsBesideALine) {
  ColorImage image(40, 30);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x)
      image.pixels[static_cast<std::size_t>(y * 40 + x)] =
          y == 10 || y == 11 ? robotlink::YCbCr{200, 120, 128} : robotlink::YCbCr{80, 116, 116};
  }
  const ImagePoint way[] = {{5, 10}, {30, 10.4}};
  const PixelArea careful = carefulBrushArea(image, way, 4, 24), plain = brushArea(40, 30, way, 4);
  EXPECT_GT(pixelCount(plain), 200U);
  for (const PixelRun& run : careful) EXPECT_TRUE(run.y == 10 || run.y == 11) << run.y;
  EXPECT_GT(pixelCount(careful), 50U);
  EXPECT_TRUE(isValid(careful, 40, 30));
  const ImagePoint field[] = {{5, 22}, {30, 22}};
  EXPECT_EQ(carefulBrushArea(image, field, 4, 24), brushArea(40, 30, field, 4))
      << "where all is alike it is a brush";
}

}  // namespace

TEST(PixelArea, aBrushOfRadius3Touches29Pixels) {
  const ImagePoint at[] = {{10, 10}};
  EXPECT_EQ(pixelCount(brushArea(40, 40, at, 3)), 29U);
}

TEST(PixelArea, aBrushTouchesAllAlongItsWay) {
  const ImagePoint way[] = {{1, 1}, {5, 1}, {5, 3}};
  EXPECT_EQ(picture(brushArea(8, 5, way, 0.5), 8, 5),
            (Rows{"........", ".#####..", ".....#..", ".....#..", "........"}));
}

TEST(PixelArea, whatLiesOutsideIsLeftOut) {
  const ImagePoint way[] = {{-100, 1}, {1, 1}};
  EXPECT_EQ(picture(brushArea(4, 3, way, 0.2), 4, 3), (Rows{"....", "##..", "...."}));
  EXPECT_EQ(picture(rectangleArea(4, 3, {9, 9}, {2, -5}), 4, 3), (Rows{"..##", "..##", "..##"}));
  EXPECT_TRUE(rectangleArea(4, 3, {9, 9}, {12, 10}).empty());
  const ImagePoint corners[] = {{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
  EXPECT_EQ(pixelCount(polygonArea(4, 3, corners)), 12U);
  EXPECT_TRUE(brushArea(4, 3, {}, 3).empty());
}

TEST(PixelArea, aLassoTakesWhatIsInside) {
  const ImagePoint corners[] = {{0.5, 0.5}, {4.5, 0.5}, {4.5, 3.5}, {2.5, 1.5}, {0.5, 3.5}};
  // A pixel whose center lies on a side belongs to what is right of it.
  EXPECT_EQ(picture(polygonArea(6, 5, corners), 6, 5),
            (Rows{"......", ".####.", ".#.##.", "....#.", "......"}));
}

TEST(PixelArea, theWandStopsAtOtherColors) {
  const ColorImage image = imageOf({"......", ".ooo..", ".oo.o.", "....oo"});
  EXPECT_EQ(picture(wandArea(image, 1, 1), 6, 4), (Rows{"......", ".###..", ".##...", "......"}));
  WandOptions few;
  few.mostPixels = 3;
  EXPECT_EQ(pixelCount(wandArea(image, 0, 0, few)), 3U);
  EXPECT_TRUE(wandArea(image, -1, 0).empty());
}

TEST(PixelArea, theWandFollowsShadingButNotAnEdge) {
  ColorImage image(60, 1);
  for (int x = 0; x < 60; ++x)
    image.pixels[static_cast<std::size_t>(x)] = {static_cast<std::uint8_t>(x < 30 ? 100 + x : 190 + x), 100,
                                                 150};
  const PixelArea area = wandArea(image, 10, 0);
  ASSERT_EQ(area.size(), 1U);
  EXPECT_EQ(area[0].begin, 0);
  EXPECT_EQ(area[0].end, 30);
}

TEST(PixelArea, aSpotIsWhatIsConnectedAndOfOneClass) {
  robotlink::Image classes(5, 3, robotlink::PixelFormat::kMono8);
  classes.data = {1, 1, 0, 1, 1,  //
                  0, 1, 0, 1, 0,  //
                  2, 1, 2, 0, 0};
  EXPECT_EQ(picture(spotArea(classes.view(), 0, 0), 5, 3), (Rows{"##...", ".#...", ".#..."}));
  EXPECT_EQ(picture(spotArea(classes.view(), 3, 1), 5, 3), (Rows{"...##", "...#.", "....."}));
  EXPECT_TRUE(spotArea(classes.view(), 5, 0).empty());
}

TEST(PixelArea, anOutlineIsAllSidesThatAreNotShared) {
  const auto edges = outline(areaOf({"##", ".#"}));
  const auto has = [&](PixelEdge edge) { return std::ranges::find(edges, edge) != edges.end(); };
  EXPECT_EQ(edges.size(), 6U);
  EXPECT_TRUE(has({2, 0, 2, 2})) << "the right side of both rows";
  EXPECT_TRUE(has({0, 0, 2, 0})) << "above";
  EXPECT_TRUE(has({0, 1, 1, 1})) << "below the left one";
  EXPECT_TRUE(has({1, 2, 2, 2})) << "below the lower one";
  EXPECT_FALSE(has({1, 1, 2, 1})) << "between both";
  EXPECT_TRUE(has({1, 1, 1, 2}));
}

TEST(PixelArea, areasAreUnitedAndTakenAway) {
  const PixelArea a = areaOf({"##..##", "......", "######"}), b = areaOf({".###..", "#.....", "..##.."});
  EXPECT_EQ(united(a, b), areaOf({"######", "#.....", "######"}));
  EXPECT_EQ(without(a, b), areaOf({"#...##", "......", "##..##"}));
  EXPECT_TRUE(without(a, a).empty());
  EXPECT_EQ(united(a, {}), a);
}

TEST(PixelArea, unitingRandomAreasIsAsPixelByPixel) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    Rows a(6, std::string(17, '.')), b = a, both = a, rest = a;
    for (std::size_t y = 0; y < a.size(); ++y) {
      for (std::size_t x = 0; x < a[y].size(); ++x) {
        if (random() % 2 == 0) a[y][x] = '#';
        if (random() % 2 == 0) b[y][x] = '#';
        if (a[y][x] == '#' || b[y][x] == '#') both[y][x] = '#';
        if (a[y][x] == '#' && b[y][x] != '#') rest[y][x] = '#';
      }
    }
    EXPECT_EQ(united(areaOf(a), areaOf(b)), areaOf(both));
    EXPECT_EQ(without(areaOf(a), areaOf(b)), areaOf(rest));
    EXPECT_TRUE(isValid(areaOf(both), 17, 6));
  }
}

TEST(PixelArea, whatCannotBeAnAreaIsFound) {
  EXPECT_TRUE(isValid({{0, 1, 3}, {0, 4, 5}, {2, 0, 1}}, 5, 3));
  EXPECT_FALSE(isValid({{0, 1, 3}, {0, 3, 5}}, 5, 3)) << "touching";
  EXPECT_FALSE(isValid({{1, 1, 3}, {0, 1, 3}}, 5, 3)) << "upwards";
  EXPECT_FALSE(isValid({{0, 3, 3}}, 5, 3)) << "empty";
  EXPECT_FALSE(isValid({{0, 3, 6}}, 5, 3));
  EXPECT_FALSE(isValid({{3, 0, 1}}, 5, 3));
  EXPECT_TRUE(contains({{0, 1, 3}}, 2, 0));
  EXPECT_FALSE(contains({{0, 1, 3}}, 3, 0));
}
