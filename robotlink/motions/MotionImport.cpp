// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionImport.h"

#include <algorithm>
#include <functional>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/motions/ImportedMotion.h"
#include "robotlink/motions/MotionLibrary.h"

namespace robotlink {
namespace {

constexpr char kPos[] = ".pos", kCmpack[] = ".mot";

}  // namespace

std::string motionNameOf(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  const auto isLetter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  std::ranges::replace_if(name, std::not_fn(isLetter), '_');
  return name.empty() ? "imported" : name;
}

MotionFile beginImport(const std::string& path, std::vector<std::string> joints,
                       MotionFile::TimeUnit timeUnit) {
  MotionFile motion;
  motion.path = path;
  motion.name = motionNameOf(path);
  motion.joints = std::move(joints);
  motion.hasJointHeader = true;
  motion.timeUnit = timeUnit;
  // The name alone: a text does not say where files are on this machine.
  std::string from = std::filesystem::path(path).filename().string();
  std::ranges::replace(from, '\n', ' ');
  motion.lines.push_back({MotionRemark{}, "// Imported from " + from, 0});
  motion.lines.push_back({MotionLabel{"start"}, {}, 0});
  return motion;
}

void finishImport(MotionFile& motion) {
  motion.lines.push_back({MotionTransition{"allMotions", MotionNet::kEntryName, "start"}, {}, 0});
}

bool isForeignMotion(const std::filesystem::path& file) {
  const std::string suffix = fileSuffix(file);
  return suffix == kPos || suffix == kCmpack;
}

tl::expected<MotionFile, Errors> importMotion(const std::filesystem::path& file) {
  const auto bytes = readFile(file, MotionLibrary::kMaxTextBytes);
  if (!bytes) return tl::unexpected(Errors{bytes.error()});
  return fileSuffix(file) == kPos ? readPosMotion(*bytes, file.string())
                                  : readCmpackMotion(*bytes, file.string());
}

}  // namespace robotlink
