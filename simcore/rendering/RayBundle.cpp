// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/RayBundle.h"

#include <algorithm>
#include <cmath>

namespace simcore {
namespace {

// The columns and rows of a packet, and the numbers of packets along each in a group.
constexpr int kPacketColumns = 4, kPacketRows = 2, kGroupColumns = 4, kGroupRows = 4;

/// The cone around directions of unit length.
RayBundle::Cone coneAround(const std::vector<Eigen::Vector3f>& directions) {
  RayBundle::Cone cone;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& direction : directions) sum += direction;
  cone.wide = sum.norm() < 1e-3F;
  cone.axis = cone.wide ? Eigen::Vector3f(1, 0, 0) : sum.normalized();
  for (const Eigen::Vector3f& direction : directions)
    cone.cosHalf = std::min(cone.cosHalf, cone.axis.dot(direction));
  // Slightly wider, to allow for rounding.
  cone.cosHalf -= 1e-6F;
  cone.wide = cone.wide || cone.cosHalf < 0.05F;
  cone.sinHalf = std::sqrt(std::max(0.F, 1 - cone.cosHalf * cone.cosHalf));
  return cone;
}

}  // namespace

RayBundle::RayBundle(int rows, int columns, const std::vector<Eigen::Vector3d>& directions)
    : size_(directions.size()) {
  const auto addPacket = [&](int row, int column, std::vector<Eigen::Vector3f>& ofGroup) {
    Packet packet;
    std::vector<Eigen::Vector3f> own;
    for (int y = row; y < std::min(row + kPacketRows, rows); ++y) {
      for (int x = column; x < std::min(column + kPacketColumns, columns); ++x) {
        const int ray = y * columns + x;
        own.emplace_back(directions[static_cast<std::size_t>(ray)].normalized().cast<float>());
        packet.ray[static_cast<std::size_t>(packet.count++)] = ray;
      }
    }
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const std::size_t from = std::min(lane, own.size() - 1);
      for (std::size_t k = 0; k < 3; ++k) packet.direction[k][lane] = own[from][static_cast<int>(k)];
      packet.ray[lane] = packet.ray[from];
    }
    packets_.push_back(packet);
    cones_.push_back(coneAround(own));
    ofGroup.insert(ofGroup.end(), own.begin(), own.end());
  };
  for (int top = 0; top < rows; top += kPacketRows * kGroupRows) {
    for (int left = 0; left < columns; left += kPacketColumns * kGroupColumns) {
      Group group;
      group.first = packets_.size();
      std::vector<Eigen::Vector3f> ofGroup;
      for (int y = top; y < std::min(top + kPacketRows * kGroupRows, rows); y += kPacketRows) {
        for (int x = left; x < std::min(left + kPacketColumns * kGroupColumns, columns); x += kPacketColumns)
          addPacket(y, x, ofGroup);
      }
      group.last = packets_.size();
      group.cone = coneAround(ofGroup);
      groups_.push_back(group);
    }
  }
}

}  // namespace simcore
