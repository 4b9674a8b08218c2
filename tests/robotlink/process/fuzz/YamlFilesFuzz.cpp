// SPDX-License-Identifier: GPL-3.0-or-later
// Process layouts, descriptions of robots and descriptions of fields: all that is written in YAML.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/process/Layout.h"
#include "tests/fuzz/FuzzTarget.h"

namespace yaml_files_fuzz {

using namespace robotlink;

namespace {

/// Every refusal says why, and where.
void checkErrors(const Errors& errors) {
  require(!errors.empty(), "a refusal has errors");
  for (const Error& error : errors) require(!error.describe().empty(), "an error says something");
}

void checkRobot(const RobotDescription& robot) {
  for (const auto& joint : robot.joints) {
    require(std::isfinite(joint.minimum) && std::isfinite(joint.maximum), "limits are finite");
    require(joint.minimum < joint.maximum, "the lower limit is below the upper one");
    require(joint.stance >= joint.minimum && joint.stance <= joint.maximum,
            "the stance is within the limits");
  }
  require(!robot.laser || robot.laser->readings >= 2, "a laser has readings");
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (const auto layout = parseLayout(text, "layout.yaml"))
    checkLayout(*layout, {}, {});
  else
    checkErrors(layout.error());
  if (const auto robot = parseRobotDescription(text, "robot.yaml"))
    checkRobot(*robot);
  else
    checkErrors(robot.error());
  if (const auto field = FieldDescription::parse(text, "field.yaml"); !field) checkErrors(field.error());
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"layouts", "robots", "fields"}) {
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(ROBOTCONTROL_SOURCE_DIR) / "resources" / folder))
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> seeds;
  for (const auto& path : files) {
    std::ifstream file(path, std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return seeds;
}

const FuzzRegistration kTarget({"yaml_files", &fuzzSeeds, &runInput});

}  // namespace yaml_files_fuzz
