// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/SentMotions.h"

#include <algorithm>
#include <memory>

#include "robotlink/base/Resources.h"
#include "robotlink/motions/MotionReader.h"
#include "robotlink/packages/Conversions.h"

namespace robotlink {
namespace {

constexpr std::size_t kMaxErrorsTold = 5;

/// The errors of one text, as many as can be read at once.
std::string shortened(Errors errors) {
  const std::size_t more = errors.size() - std::min(errors.size(), kMaxErrorsTold);
  errors.resize(errors.size() - more);
  return describe(errors) + (more > 0 ? "\nand " + std::to_string(more) + " more" : "");
}

}  // namespace

const tl::expected<MotionLibrary, Errors>& SentMotions::library() const {
  if (!library_) library_ = MotionLibrary::load(resource("motions"));
  return *library_;
}

std::string SentMotions::whyNot(const robotcontrol::MotionText& motion) const {
  if (!library()) return shortened(library().error());
  if (!motion.text().empty()) {
    const auto read = readMotion(motion.text(), motion.name() + ".mof", joints_);
    if (!read) return shortened(read.error());
    if (read->name != motion.name())
      return "the text of the motion '" + motion.name() + "' is that of '" + read->name + "'";
  }
  MotionLibrary next = *library();
  next.replace(motion.name(), motion.text());
  const auto net = next.compile(joints_);
  return net ? "" : shortened(net.error());
}

void SentMotions::set(const robotcontrol::MotionText& motion, Instant now) {
  if (!library()) return;
  (*library_)->replace(motion.name(), motion.text());
  send(now);
}

void SentMotions::add(const robotcontrol::MotionTexts& motions, Instant now) {
  if (!library()) return;
  for (const auto& motion : motions.motions()) (*library_)->replace(motion.name(), motion.text());
  send(now);
}

void SentMotions::send(Instant now) {
  auto texts = std::make_shared<robotcontrol::MotionTexts>();
  assign(*texts->mutable_timestamp(), now);
  for (const MotionLibrary::Entry& entry : (*library_)->entries()) {
    if (!entry.isReplaced) continue;
    auto& motion = *texts->add_motions();
    motion.set_name(entry.name);
    motion.set_text(entry.text);
  }
  sender_.send(std::move(texts));
}

robotcontrol::MotionTable SentMotions::table(const std::vector<robotcontrol::MotionText>& more) const {
  robotcontrol::MotionTable table;
  *table.mutable_joints() = {joints_.begin(), joints_.end()};
  if (!library()) return table;
  MotionLibrary all = *library();
  for (const auto& motion : more) all.replace(motion.name(), motion.text());
  for (const MotionLibrary::Entry& entry : all.entries()) {
    auto& motion = *table.add_motions();
    motion.set_name(entry.name);
    motion.set_text(entry.text);
    motion.set_sent(entry.isReplaced);
  }
  return table;
}

}  // namespace robotlink
