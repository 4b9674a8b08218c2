// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/LaserScan.h"

namespace robotlink::arcos {

std::optional<LaserScan> LaserScanAssembler::take(const LaserPacket& part,
                                                  const StandardInformation* information, Instant now) {
  if (part.first == 0) {
    if (scan_) ++incompleteScans_;
    scan_.emplace();
    total_ = part.total;
    scan_->device = part.device;
    scan_->takenAt = now;
    if (!part.extended) {
      scan_->xMm = part.xMm;
      scan_->yMm = part.yMm;
      scan_->headingDeg = part.headingDeg;
    } else if (information) {
      scan_->xMm = information->xMm;
      scan_->yMm = information->yMm;
      scan_->headingDeg = information->heading4096 * 360.0 / 4096;
    }
  }
  // A part without the beginning of its scan is useless; the scan was counted when its first missing part was
  // noticed.
  if (!scan_) return std::nullopt;
  const std::size_t have = scan_->rangesMm.size();
  if (part.total != total_ || part.device != scan_->device || part.first > have) {
    ++incompleteScans_;
    scan_.reset();
    return std::nullopt;
  }
  for (std::size_t i = have - part.first; i < part.readings.size() && part.first + i < total_; ++i) {
    scan_->rangesMm.push_back(part.readings[i].rangeMm);
    scan_->reflectances.push_back(part.readings[i].reflectance);
  }
  if (scan_->rangesMm.size() < total_) return std::nullopt;
  std::optional<LaserScan> complete = std::move(scan_);
  scan_.reset();
  return complete;
}

}  // namespace robotlink::arcos
