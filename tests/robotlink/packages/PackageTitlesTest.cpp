// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/PackageTitles.h"

#include <gtest/gtest.h>

#include "robotlink/packages/Packages.h"

namespace robotlink {
namespace {

TEST(PackageTitles, knownPackagesHaveTitlesAndOthersTheirNames) {
  EXPECT_EQ(packageTitle(kJointStates.name), "joint angles (" + std::string(kJointStates.name) + ")");
  EXPECT_EQ(packageTitle("mine/own"), "mine/own");
  EXPECT_EQ(packageTitle(""), "");
}

TEST(PackageTitles, whatIsMissingIsNamed) {
  EXPECT_EQ(notProvided(kLaser.name),
            "neither the robot nor another task provides laser scans (" + std::string(kLaser.name) + ")");
  EXPECT_EQ(notProvided("mine/own"), "neither the robot nor another task provides mine/own");
}

}  // namespace
}  // namespace robotlink
