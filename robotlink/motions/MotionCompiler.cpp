// SPDX-License-Identifier: GPL-3.0-or-later
// compileMotions() of MotionNet.h: from motion files to a net of nodes.
#include <algorithm>
#include <map>

#include "robotlink/motions/MotionNet.h"
#include "robotlink/motions/MotionReader.h"

namespace robotlink {
namespace {

/// Compiles in two passes: the first finds motions and labels and numbers the nodes, the second creates the
/// nodes.
class Compiler {
 public:
  Compiler(std::span<const MotionFile> files, const std::vector<std::string>& joints)
      : files_(files), net_(std::make_shared<MotionNet>()) {
    net_->joints = joints;
  }

  tl::expected<std::shared_ptr<const MotionNet>, Errors> compile() {
    collect();
    if (errors_.empty()) {
      for (const MotionFile& file : files_) addNodes(file);
    }
    if (errors_.empty()) findEntry();
    if (!errors_.empty()) return tl::unexpected(std::move(errors_));
    return std::shared_ptr<const MotionNet>(std::move(net_));
  }

 private:
  void fail(const MotionFile& file, int line, const char* id, std::string text) {
    errors_.push_back({id, std::move(text), {}, {file.path, line, line > 0 ? 1 : 0}});
  }

  void collect() {
    int node = 0, lines = 0;
    if (files_.size() > kMaxMotionFiles) {
      fail(files_.front(), 0, "motion.too-many-files",
           "a robot has at most " + std::to_string(kMaxMotionFiles) + " motions");
    }
    for (const MotionFile& file : files_) {
      if (net_->find(file.name) >= 0) {
        fail(file, 1, "motion.duplicate-motion", "another file already is the motion '" + file.name + "'");
      }
      net_->motions.push_back(file.name);
      net_->begins.push_back(file.begin);
      net_->displacements.push_back({file.odometry, playTime(file)});
      lines += static_cast<int>(file.lines.size());
      collectLabels(file, node);
    }
    if (lines > kMaxMotionLines) {
      fail(files_.back(), 0, "motion.too-many-lines",
           "all motions together have at most " + std::to_string(kMaxMotionLines) + " lines");
    }
    if (labels_.size() > kMaxMotionLabels) {
      fail(files_.back(), 0, "motion.too-many-labels",
           "all motions together have at most " + std::to_string(kMaxMotionLabels) + " labels");
    }
  }

  static Duration playTime(const MotionFile& file) {
    Duration time{};
    for (const MotionLine& line : file.lines) {
      if (const auto* frame = std::get_if<KeyFrame>(&line.statement)) time += frame->duration;
    }
    return time;
  }

  void collectLabels(const MotionFile& file, int& node) {
    for (const MotionLine& line : file.lines) {
      if (const auto* label = std::get_if<MotionLabel>(&line.statement)) {
        if (!labels_.emplace(std::pair(file.name, label->name), node).second) {
          fail(file, line.number, "motion.duplicate-label",
               "the label '" + label->name + "' appears here for the second time");
        }
      } else if (!std::holds_alternative<MotionRemark>(line.statement)) {
        ++node;
      }
    }
  }

  /// For each joint of the robot the column of the file; -1 if there is none.
  std::vector<int> columns(const MotionFile& file) {
    std::vector<int> result(net_->joints.size(), -1);
    for (std::size_t i = 0; i < result.size() && !file.hasJointHeader; ++i) result[i] = static_cast<int>(i);
    for (std::size_t i = 0; i < file.joints.size() && file.hasJointHeader; ++i) {
      const auto joint = std::find(net_->joints.begin(), net_->joints.end(), file.joints[i]);
      if (joint == net_->joints.end()) {
        fail(file, file.jointHeaderLine, "motion.unknown-joint",
             "the robot has no joint '" + file.joints[i] + "'");
      } else {
        result[static_cast<std::size_t>(joint - net_->joints.begin())] = static_cast<int>(i);
      }
    }
    return result;
  }

  void addNodes(const MotionFile& file) {
    const std::vector<int> map = columns(file);
    bool reachable = false, ended = true;
    for (const MotionLine& line : file.lines) {
      if (std::holds_alternative<MotionRemark>(line.statement)) continue;
      if (std::holds_alternative<MotionLabel>(line.statement)) {
        reachable = true;
        continue;
      }
      if (!reachable) {
        fail(file, line.number, "motion.unreachable", "this line is never played; put a label before it");
      }
      addNode(file, line, map);
      ended = endsPath(file, line);
      if (ended) reachable = false;
    }
    if (!ended || file.lines.empty()) {
      fail(file, file.lines.empty() ? 0 : file.lines.back().number, "motion.no-end",
           "the motion '" + file.name + "' must end in 'transition allMotions MOTION LABEL'");
    }
  }

  static bool endsPath(const MotionFile& file, const MotionLine& line) {
    const auto* transition = std::get_if<MotionTransition>(&line.statement);
    return transition && (transition->request == "allMotions" ||
                          (transition->request == file.name && transition->motion == file.name &&
                           file.name == MotionNet::kEntryName));
  }

  void addNode(const MotionFile& file, const MotionLine& line, const std::vector<int>& map) {
    MotionNet::Node node;
    node.motion = net_->find(file.name);
    node.line = line.number;
    if (const auto* transition = std::get_if<MotionTransition>(&line.statement)) {
      node.step = resolved(file, line.number, *transition);
    } else if (const auto* frame = std::get_if<KeyFrame>(&line.statement)) {
      node.step =
          KeyFrame{mapped(file, line.number, frame->joints, map), frame->interpolation, frame->duration};
    } else if (const auto* hardness = std::get_if<MotionHardness>(&line.statement)) {
      node.step = MotionHardness{mapped(file, line.number, hardness->shares, map), hardness->duration};
    }
    net_->nodes.push_back(std::move(node));
  }

  template <typename T>
  std::vector<T> mapped(const MotionFile& file, int line, const std::vector<T>& values,
                        const std::vector<int>& map) {
    std::vector<T> result(map.size());
    if (!file.hasJointHeader && values.size() != map.size()) {
      fail(file, line, "motion.wrong-count",
           "the robot has " + std::to_string(map.size()) + " joints, the line " +
               std::to_string(values.size()));
      return result;
    }
    for (std::size_t i = 0; i < map.size(); ++i) {
      if (map[i] >= 0 && map[i] < static_cast<int>(values.size()))
        result[i] = values[static_cast<std::size_t>(map[i])];
    }
    return result;
  }

  MotionNet::Transition resolved(const MotionFile& file, int line, const MotionTransition& text) {
    MotionNet::Transition result;
    if (text.request != "allMotions") {
      result.request = net_->find(text.request);
      if (result.request < 0) {
        fail(file, line, "motion.unknown-motion", "there is no motion '" + text.request + "' to request");
      }
    }
    const auto label = labels_.find({text.motion, text.label});
    if (net_->find(text.motion) < 0) {
      fail(file, line, "motion.unknown-motion", "there is no motion '" + text.motion + "' to go to");
    } else if (label == labels_.end()) {
      fail(file, line, "motion.unknown-label",
           "the motion '" + text.motion + "' has no label '" + text.label + "'");
    } else {
      result.target = label->second;
    }
    return result;
  }

  void findEntry() {
    const auto entry = labels_.find({MotionNet::kEntryName, "start"});
    if (entry == labels_.end()) {
      errors_.push_back({"motion.no-entry",
                         "there is no motion 'extern' with a label 'start'; it lists all motions",
                         {},
                         {files_.empty() ? "" : files_.front().path, 0, 0}});
      return;
    }
    net_->entry = entry->second;
  }

  std::span<const MotionFile> files_;
  std::shared_ptr<MotionNet> net_;
  std::map<std::pair<std::string, std::string>, int> labels_;
  Errors errors_;
};

}  // namespace

tl::expected<std::shared_ptr<const MotionNet>, Errors> compileMotions(
    std::span<const MotionFile> files, const std::vector<std::string>& joints) {
  return Compiler(files, joints).compile();
}

}  // namespace robotlink
