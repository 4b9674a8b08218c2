// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/localization/FieldMonteCarlo.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::kPi;
using robotlink::normalizedAngle;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

/// A squared deviation counts at most as much, so that one wrong measurement does not outweigh the others.
constexpr double kMaxSquare = 9;
/// Goals have no exact position, because posts and robots hide parts of them.
constexpr double kGoalDoubt = 2;
/// The distance between the middle of the visible part of a goal and that of the goal, at most, m.
constexpr double kGoalBlur = 0.12;
/// The error of the distance of a goal of which robots hide parts, m. In games it was 0.25 to 0.55 m on
/// the average, most near the goal, and up to 3 m.
constexpr double kGoalDistanceBlur = 0.6;
/// Cells of poses in which clusters are looked for, m and per turn.
constexpr double kClusterCell = 0.4;
/// The factor by which another cluster must be denser than that of the last estimate to take its place.
constexpr double kKeepsCluster = 1.5;
constexpr int kHeadingCells = 12;
/// The share of new particles that keep their place and turn.
constexpr double kTurnedShare = 0.5;
/// The fraction by which the fit follows an image.
constexpr double kFitRate = 0.12;

}  // namespace

FieldMonteCarlo::FieldMonteCarlo(const robotlink::FieldDescription& field, const Options& options)
    : options_(options),
      random_(options.seed),
      edges_(field),
      halfLength_(0.5 * field.length),
      halfWidth_(0.5 * field.width),
      particles_(static_cast<std::size_t>(std::max(1, options.particles))) {
  for (Particle& particle : particles_) set(particle, anyPose());
  summarize();
}

void FieldMonteCarlo::startAt(const Pose2& pose, double deviation) {
  for (Particle& particle : particles_) {
    set(particle,
        {pose.x + deviation * noise(), pose.y + deviation * noise(), pose.heading + deviation * noise()});
    particle.weight = 1;
  }
  memory_.clear();
  fit_ = 1;
  summarize();
}

double FieldMonteCarlo::noise() {
  // The sum of four uniform numbers, scaled to a deviation of 1 (Irwin-Hall).
  const std::uint64_t bits = random_.bits();
  const auto part = [&](int i) { return static_cast<double>((bits >> (16 * i)) & 0xFFFFU); };
  constexpr double kScale = 1.7320508075688772 / 65536;
  return (part(0) + part(1) + part(2) + part(3) - 2 * 65535.0) * kScale;
}

void FieldMonteCarlo::set(Particle& particle, const Pose2& pose) const {
  particle.pose = {std::clamp(pose.x, -halfLength_, halfLength_), std::clamp(pose.y, -halfWidth_, halfWidth_),
                   normalizedAngle(pose.heading)};
  particle.cosine = std::cos(pose.heading);
  particle.sine = std::sin(pose.heading);
}

Pose2 FieldMonteCarlo::anyPose() {
  return {random_.uniform(-halfLength_, halfLength_), random_.uniform(-halfWidth_, halfWidth_),
          random_.uniform(-kPi, kPi)};
}

void FieldMonteCarlo::move(const Pose2& step, bool shaken) {
  const double drift = (shaken ? 10 : 1) * options_.driftNoise;
  const double way = options_.walkNoise * std::sqrt(std::hypot(step.x, step.y)) + drift;
  const double turn = options_.turnNoise * std::sqrt(std::abs(step.heading)) + drift;
  for (Particle& particle : particles_) {
    const double x = step.x + way * noise(), y = step.y + way * noise();
    set(particle, {particle.pose.x + particle.cosine * x - particle.sine * y,
                   particle.pose.y + particle.sine * x + particle.cosine * y,
                   particle.pose.heading + step.heading + turn * noise()});
  }
}

void FieldMonteCarlo::choose(const Frame& frame) {
  sights_.clear();
  for (const LandmarkMeasurement& landmark : frame.landmarks) {
    const double doubt = (landmark.isGoal ? kGoalDoubt : 1) * (2 - landmark.confidence);
    const double blur = landmark.isGoal ? kGoalBlur / std::max(0.3, landmark.distance) : 0;
    sights_.push_back({landmark.position,
                       {std::cos(landmark.bearing), std::sin(landmark.bearing)},
                       landmark.distance,
                       doubt * options_.bearingDeviation + blur,
                       doubt * (options_.distanceDeviation * landmark.distance + 0.05) +
                           (landmark.isGoal ? kGoalDistanceBlur : 0)});
  }
  // Evenly chosen points: neighbors in the list are next to each other in the image.
  points_.clear();
  const auto wanted = static_cast<std::size_t>(std::max(0, options_.linePoints));
  const std::size_t count = std::min(frame.lines.size(), wanted);
  for (std::size_t i = 0; i < count; ++i) {
    const LineMeasurement& point = frame.lines[i * frame.lines.size() / count];
    const double deviation = options_.lineDeviation + options_.lineDeviationPerMeter * point.inRobot.norm();
    points_.push_back({point.inRobot, point.direction, 1 / deviation});
  }
}

double FieldMonteCarlo::landmarkSquares(const Particle& particle) const {
  double squares = 0;
  for (const Sight& sight : sights_) {
    const double dx = sight.position.x() - particle.pose.x, dy = sight.position.y() - particle.pose.y;
    const double distance = std::max(0.05, std::sqrt(dx * dx + dy * dy));
    // The sine of the angle between two unit vectors is their cross product.
    const double x = (particle.cosine * dx + particle.sine * dy) / distance;
    const double y = (particle.cosine * dy - particle.sine * dx) / distance;
    const double sine = x * sight.direction.y() - y * sight.direction.x();
    const bool ahead = x * sight.direction.x() + y * sight.direction.y() > 0;
    const double off = ahead ? sine / sight.directionDeviation : kMaxSquare;
    const double far = (sight.distance - distance) / sight.distanceDeviation;
    squares += std::min(kMaxSquare, off * off) + std::min(kMaxSquare, far * far);
  }
  return squares;
}

double FieldMonteCarlo::lineSquares(const Particle& particle) const {
  double squares = 0;
  for (const LinePoint& point : points_) {
    const double x = point.inRobot.x(), y = point.inRobot.y();
    const Vector2 inField(particle.pose.x + particle.cosine * x - particle.sine * y,
                          particle.pose.y + particle.sine * x + particle.cosine * y);
    const double off = edges_.distance(inField, point.direction + particle.pose.heading) * point.perDeviation;
    squares += std::min(kMaxSquare, off * off);
  }
  return squares;
}

void FieldMonteCarlo::weigh(const Frame& frame) {
  choose(frame);
  double sum = 0;
  const double measurements = 2 * static_cast<double>(sights_.size());
  for (Particle& particle : particles_) {
    const double landmarks = landmarkSquares(particle);
    if (measurements > 0) sum += std::exp(-0.5 * landmarks / measurements);
    const double weighted =
        options_.landmarkEvidence * landmarks + options_.lineEvidence * lineSquares(particle);
    particle.weight *= std::exp(-0.5 * weighted);
  }
  if (measurements > 0) fit_ += kFitRate * (sum / static_cast<double>(particles_.size()) - fit_);
}

Pose2 FieldMonteCarlo::drawPose(const Pose2& robotInOdometry) {
  const auto& known = memory_.sightings();
  if (known.empty()) return anyPose();
  const Pose2 odometryInRobot = robotInOdometry.inverse();
  const auto place = [&](const LandmarkMemory::Sighting& sighting) {
    const Vector2 inRobot = odometryInRobot * sighting.inOdometry;
    return Vector2(inRobot * (1 + options_.distanceDeviation * noise()));
  };
  const auto pick = [&] {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(known.size()));
  };
  const std::size_t first = pick(), second = pick();
  const Vector2 seen = place(known[first]);
  const double turn = options_.bearingDeviation * noise();
  if (first != second) {
    Pose2 pose =
        LandmarkMemory::poseFrom(known[first].position, seen, known[second].position, place(known[second]));
    pose.heading += turn;
    return pose;
  }
  const double around = random_.uniform(-kPi, kPi), distance = std::max(0.1, seen.norm());
  return {known[first].position.x() + distance * std::cos(around),
          known[first].position.y() + distance * std::sin(around),
          around + kPi - std::atan2(seen.y(), seen.x()) + turn};
}

Pose2 FieldMonteCarlo::turned(const Pose2& pose, const Frame& frame) {
  const auto number =
      static_cast<std::size_t>(random_.uniform() * static_cast<double>(frame.landmarks.size()));
  const LandmarkMeasurement& seen = frame.landmarks[number];
  const Vector2 way = seen.position - pose.translation();
  return {pose.x, pose.y, std::atan2(way.y(), way.x()) - seen.bearing + options_.bearingDeviation * noise()};
}

void FieldMonteCarlo::resample(const Frame& frame) {
  const std::size_t count = particles_.size();
  double sum = 0;
  for (const Particle& particle : particles_) sum += particle.weight;
  if (!(sum > 0)) return;
  const double lack = options_.goodFit > 0 ? std::max(0.0, 1 - fit_ / options_.goodFit) : 0;
  const bool shows = !frame.landmarks.empty();
  const double fresh = shows ? options_.newShare * lack : 0;
  if (fresh == 0 && effectiveParticles(particles_) > 0.5 * static_cast<double>(count)) return;
  const double share = shows ? fresh + options_.probeShare : 0;
  const double start = random_.uniform(), rough = options_.roughening;
  double passed = 0;
  std::size_t at = 0;
  drawn_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = (start + static_cast<double>(i)) / static_cast<double>(count) * sum;
    while (at + 1 < count && passed + particles_[at].weight < wanted) passed += particles_[at++].weight;
    const Pose2& from = particles_[at].pose;
    Particle& added = drawn_.emplace_back();
    // If duplicates stayed equal, the cloud would shrink whatever is seen.
    if (random_.uniform() < share)
      set(added, random_.uniform() < kTurnedShare ? turned(from, frame) : drawPose(frame.robotInOdometry));
    else
      set(added, {from.x + rough * noise(), from.y + rough * noise(), from.heading + rough * noise()});
  }
  particles_.swap(drawn_);
}

bool FieldMonteCarlo::Block::contains(const Block& cell) const {
  const int turned = (cell.heading - heading + kHeadingCells) % kHeadingCells;
  return cell.x >= x && cell.x <= x + 1 && cell.y >= y && cell.y <= y + 1 && turned <= 1;
}

FieldMonteCarlo::Block FieldMonteCarlo::cellOf(const Pose2& pose) const {
  return {static_cast<int>((pose.x + halfLength_) / kClusterCell),
          static_cast<int>((pose.y + halfWidth_) / kClusterCell),
          static_cast<int>((pose.heading + kPi) / (2 * kPi) * kHeadingCells) % kHeadingCells};
}

FieldMonteCarlo::Block FieldMonteCarlo::densestBlock() {
  const int columns = static_cast<int>(2 * halfLength_ / kClusterCell) + 2;
  const int rows = static_cast<int>(2 * halfWidth_ / kClusterCell) + 2;
  const auto at = [&](int x, int y, int h) -> double& {
    return cells_[static_cast<std::size_t>((y * columns + x) * kHeadingCells + h)];
  };
  // Each particle counts for the eight blocks that contain its cell; a block is named by its first cell.
  cells_.assign(static_cast<std::size_t>(columns * rows * kHeadingCells), 0);
  for (const Particle& particle : particles_) {
    const Block cell = cellOf(particle.pose);
    const int before = (cell.heading + kHeadingCells - 1) % kHeadingCells;
    for (int y = std::max(0, cell.y - 1); y <= cell.y; ++y) {
      for (int x = std::max(0, cell.x - 1); x <= cell.x; ++x) {
        at(x, y, cell.heading) += particle.weight;
        at(x, y, before) += particle.weight;
      }
    }
  }
  const auto index = static_cast<int>(std::ranges::max_element(cells_) - cells_.begin());
  const int place = index / kHeadingCells;
  Block best{place % columns, place / columns, index % kHeadingCells};
  if (!hasEstimate_) return best;
  // Between two equally dense clusters, the estimate does not jump to and fro.
  const Block last = cellOf(estimate_.robotInField);
  double most = at(best.x, best.y, best.heading) / kKeepsCluster;
  for (int y = std::max(0, last.y - 1); y <= std::min(last.y, rows - 1); ++y) {
    for (int x = std::max(0, last.x - 1); x <= std::min(last.x, columns - 1); ++x) {
      for (const int heading : {(last.heading + kHeadingCells - 1) % kHeadingCells, last.heading}) {
        if (at(x, y, heading) <= most) continue;
        most = at(x, y, heading);
        best = {x, y, heading};
      }
    }
  }
  return best;
}

void FieldMonteCarlo::summarize() {
  const Block best = densestBlock();
  double sum = 0, all = 0, x = 0, y = 0, c = 0, s = 0, squares = 0;
  for (const Particle& particle : particles_) {
    all += particle.weight;
    if (!best.contains(cellOf(particle.pose))) continue;
    sum += particle.weight;
    x += particle.weight * particle.pose.x;
    y += particle.weight * particle.pose.y;
    c += particle.weight * particle.cosine;
    s += particle.weight * particle.sine;
    squares += particle.weight * (particle.pose.x * particle.pose.x + particle.pose.y * particle.pose.y);
  }
  if (!(sum > 0)) return;
  hasEstimate_ = true;
  x /= sum;
  y /= sum;
  estimate_.robotInField = {x, y, std::atan2(s, c)};
  // Particles elsewhere make the estimate doubtful, as if they were a meter and a radian away.
  const double elsewhere = std::max(0.0, 1 - sum / all);
  const double inside = std::max(0.0, squares / sum - x * x - y * y);
  estimate_.positionDeviation = std::sqrt(0.5 * inside + elsewhere);
  const double length = std::clamp(std::hypot(c, s) / sum, 1e-6, 1.0);
  estimate_.headingDeviation = std::sqrt(-2 * std::log(length) + elsewhere);
}

void FieldMonteCarlo::update(const Frame& frame) {
  if (hasOdometry_) {
    const Pose2 step = odometry_.inverse() * frame.robotInOdometry;
    move(step, frame.shaken);
    estimate_.robotInField = estimate_.robotInField * step;
  }
  odometry_ = frame.robotInOdometry;
  hasOdometry_ = true;
  if (frame.carried) {
    memory_.clear();
    fit_ = 0;
  }
  memory_.add(frame.time, frame.robotInOdometry, frame.landmarks, options_.memory);
  if (!frame.landmarks.empty() || !frame.lines.empty()) {
    weigh(frame);
    resample(frame);
  }
  summarize();
}

}  // namespace modules
