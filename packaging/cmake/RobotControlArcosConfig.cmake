# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(RobotControlArcos) gives the target RobotControl::arcos: programs for Pioneers, real or simulated.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(tl-expected)
find_dependency(Threads)
include(${CMAKE_CURRENT_LIST_DIR}/RobotControlArcosTargets.cmake)
