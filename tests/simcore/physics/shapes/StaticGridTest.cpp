// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/shapes/StaticGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "robotlink/base/Random.h"
#include "simcore/physics/OdeWorld.h"

namespace simcore {
namespace {

class StaticGridTest : public testing::Test {
 protected:
  StaticGridTest() { prepareOdeForThread(); }
  ~StaticGridTest() override {
    for (const dGeomID geom : geoms_) dGeomDestroy(geom);
  }
  dGeomID addBox(double x, double y, double heading, double length, double width) {
    const dGeomID geom = dCreateBox(nullptr, length, width, 1);
    dMatrix3 rotation;
    dRFromAxisAndAngle(rotation, 0, 0, 1, heading);
    dGeomSetRotation(geom, rotation);
    dGeomSetPosition(geom, x, y, 0.5);
    return keep(geom);
  }
  dGeomID keep(dGeomID geom) {
    geoms_.push_back(geom);
    grid_.add(geom);
    return geom;
  }
  std::vector<dGeomID> near(double x0, double x1, double y0, double y1) const {
    std::vector<dGeomID> found;
    grid_.near({x0, x1, y0, y1, 0, 1}, found);
    return found;
  }

  std::vector<dGeomID> geoms_;
  StaticGrid grid_;
};

TEST_F(StaticGridTest, everythingThatCouldTouchIsFoundOnce) {
  robotlink::Random random(1);
  for (int i = 0; i < 300; ++i) {
    addBox(random.uniform(-20, 20), random.uniform(-10, 30), random.uniform(0, 3.1), random.uniform(0.05, 6),
           0.1);
  }
  grid_.build();
  int touched = 0;
  for (int i = 0; i < 300; ++i) {
    const double x = random.uniform(-22, 22), y = random.uniform(-12, 32);
    const dGeomID probe = dCreateBox(nullptr, 0.6, 0.5, 1);
    dGeomSetPosition(probe, x, y, 0.5);
    const auto found = near(x - 0.3, x + 0.3, y - 0.25, y + 0.25);
    EXPECT_EQ(std::set<dGeomID>(found.begin(), found.end()).size(), found.size());
    for (const dGeomID geom : geoms_) {
      dContactGeom contact;
      if (dCollide(probe, geom, 1, &contact, sizeof contact) == 0) continue;
      ++touched;
      EXPECT_NE(std::ranges::find(found, geom), found.end());
    }
    dGeomDestroy(probe);
  }
  EXPECT_GT(touched, 30);
}

TEST_F(StaticGridTest, aLongWallThatStandsAskewIsNotEverywhere) {
  addBox(0, 0, robotlink::kPi / 4, 40, 0.1);
  grid_.build();
  EXPECT_EQ(near(4.8, 5.2, 4.8, 5.2).size(), 1U);
  EXPECT_TRUE(near(-5.2, -4.8, 4.8, 5.2).empty());
}

TEST_F(StaticGridTest, clearanceIsTheWayToTheNearest) {
  addBox(3, 0, 0, 2, 2);
  grid_.build();
  EXPECT_NEAR(grid_.clearance(0, 0, 5), 2, 1e-9);
  EXPECT_NEAR(grid_.clearance(1, 2, 5), std::sqrt(2), 1e-9);
  EXPECT_EQ(grid_.clearance(0, 0, 1.5), 1.5);
  EXPECT_EQ(grid_.clearance(3, 0.5, 5), 0);
  EXPECT_EQ(grid_.clearance(-100, 0, 5), 5);
}

TEST_F(StaticGridTest, planesAreKeptAside) {
  keep(dCreatePlane(nullptr, 0, 0, 1, 0));
  grid_.build();
  EXPECT_EQ(grid_.size(), 0U);
  EXPECT_EQ(grid_.unbounded().size(), 1U);
  EXPECT_TRUE(near(-1, 1, -1, 1).empty());
  EXPECT_EQ(grid_.clearance(0, 0, 2), 2);
}

TEST_F(StaticGridTest, aHugeWorldGetsLargerCells) {
  addBox(-5000, -5000, 0, 1, 1);
  const dGeomID far = addBox(5000, 5000, 0, 1, 1);
  grid_.build();
  EXPECT_EQ(near(4999, 5001, 4999, 5001), std::vector<dGeomID>{far});
}

TEST_F(StaticGridTest, manyLongWallsTakeBoundedMemoryAndAreStillFound) {
  robotlink::Random random(2);
  std::vector<std::array<double, 3>> middles;
  for (int i = 0; i < 12'000; ++i) {
    const double x = random.uniform(-7000, 7000), y = random.uniform(-7000, 7000),
                 turn = random.uniform(0, 3.1);
    addBox(x, y, turn, 14'000, 0.01);
    middles.push_back({x, y, turn});
  }
  grid_.build();
  EXPECT_LE(grid_.entries(), StaticGrid::kMaxEntries);
  for (std::size_t i = 0; i < 100; ++i) {
    const double x = middles[i][0] + 3000 * std::cos(middles[i][2]),
                 y = middles[i][1] + 3000 * std::sin(middles[i][2]);
    const auto found = near(x - 0.3, x + 0.3, y - 0.3, y + 0.3);
    EXPECT_NE(std::ranges::find(found, geoms_[i]), found.end());
    EXPECT_LT(found.size(), 100U) << "only what is there";
  }
}

}  // namespace
}  // namespace simcore
