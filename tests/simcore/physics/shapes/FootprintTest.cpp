// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/shapes/Footprint.h"

#include <gtest/gtest.h>

#include <random>

namespace simcore {
namespace {

using robotlink::Vector2;

Footprint box(double x, double y, double angle, double halfLength, double halfWidth) {
  return {{x, y}, {std::cos(angle), std::sin(angle)}, halfLength, halfWidth};
}

bool contains(const Footprint& area, const Vector2& point) {
  const Vector2 way = point - area.center;
  return std::abs(area.along.dot(way)) <= area.halfLength &&
         std::abs(area.along.x() * way.y() - area.along.y() * way.x()) <= area.halfWidth;
}

TEST(Footprint, rectanglesMeetWhereTheyOverlap) {
  struct Case {
    const char* what;
    Footprint a, b;
    bool meet;
  };
  constexpr double kEighth = robotlink::kPi / 4;
  const Case cases[] = {
      {"side by side", box(0, 0, 0, 1, 1), box(2.1, 0, 0, 1, 1), false},
      {"with a common edge", box(0, 0, 0, 1, 1), box(2, 0, 0, 1, 1), true},
      {"one in the other", box(0, 0, 0, 5, 5), box(1, 1, 0.3, 0.1, 0.1), true},
      {"a cross without a corner in the other", box(0, 0, 0, 3, 0.1), box(0, 0, 2 * kEighth, 3, 0.1), true},
      {"a corner that looks at an edge", box(0, 0, 0, 1, 1), box(2.5, 0, kEighth, 1, 1), false},
      {"a corner that reaches an edge", box(0, 0, 0, 1, 1), box(2.4, 0, kEighth, 1, 1), true},
      {"corners that pass by each other", box(0, 0, 0, 1, 1), box(1.8, 1.8, kEighth, 1, 1), false},
      {"parallel and turned", box(0, 0, kEighth, 3, 0.1), box(0.3, -0.3, kEighth, 3, 0.1), false},
  };
  for (const Case& one : cases) {
    EXPECT_EQ(meet(one.a, one.b), one.meet) << one.what;
    EXPECT_EQ(meet(one.b, one.a), one.meet) << one.what << ", the other way round";
  }
}

/// Points of one that lie in the other show that they meet; far from it none may.
TEST(Footprint, randomRectanglesMeetIfPointsSaySo) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-2, 2), angle(-3, 3), size(0.1, 1);
  int met = 0;
  for (int i = 0; i < 400; ++i) {
    const Footprint a = box(place(random), place(random), angle(random), size(random), size(random));
    const Footprint b = box(place(random), place(random), angle(random), size(random), size(random));
    bool isCommon = false;
    for (int u = -20; u <= 20 && !isCommon; ++u)
      for (int v = -20; v <= 20 && !isCommon; ++v) {
        const Vector2 across(-a.along.y(), a.along.x());
        isCommon =
            contains(b, a.center + a.along * (a.halfLength * u / 20.0) + across * (a.halfWidth * v / 20.0));
      }
    if (isCommon) {
      ++met;
      EXPECT_TRUE(meet(a, b)) << i;
    } else {
      // The grid may miss a small overlap; without a tenth at all sides there is none.
      Footprint smaller = b;
      smaller.halfLength -= 0.1;
      smaller.halfWidth -= 0.1;
      const bool isLeft = smaller.halfLength > 0 && smaller.halfWidth > 0;
      EXPECT_FALSE(isLeft && meet(a, smaller)) << i;
    }
  }
  EXPECT_GT(met, 50);
}

}  // namespace
}  // namespace simcore
