// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/LearnedTables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <opencv2/ml.hpp>
#include <set>
#include <vector>

namespace colortool {
namespace {

constexpr std::size_t kCellsASide = ColorTable::kCells;
constexpr double kMiddle = ColorTable::kCellSize / 2;
constexpr int kDimensions = 3;
/// The limit of samples of one cell that are learned from.
constexpr double kMaxRepeats = 32;
/// Samples of a Gaussian are blurred by this, about as large as a cell.
constexpr float kBlur = 5;
constexpr double kBrightnessWeight = 0.4;

struct CellColor {
  double y, cb, cr;
};

CellColor cellColorOf(std::size_t cell) {
  const auto middle = [](std::size_t index) {
    return ColorTable::kCellSize * static_cast<double>(index) + kMiddle;
  };
  return {middle(cell >> 12U), middle(cell >> 6U & 63U), middle(cell & 63U)};
}

/// The features are described in the header.
std::array<float, kDimensions> featureOf(std::size_t cell) {
  const CellColor color = cellColorOf(cell);
  const double k = 160 / (color.y + 24);
  return {static_cast<float>(kBrightnessWeight * color.y), static_cast<float>(k * (color.cb - 128)),
          static_cast<float>(k * (color.cr - 128))};
}

cv::Mat featuresOfAllCells() {
  cv::Mat features(static_cast<int>(ColorTable::kCellCount), kDimensions, CV_32F);
  for (std::size_t cell = 0; cell < ColorTable::kCellCount; ++cell) {
    const auto feature = featureOf(cell);
    std::ranges::copy(feature, features.ptr<float>(static_cast<int>(cell)));
  }
  return features;
}

/// The training data: a feature and a class per row, with repetitions.
struct Lesson {
  cv::Mat features = cv::Mat(0, kDimensions, CV_32F);
  cv::Mat classes = cv::Mat(0, 1, CV_32S);
  std::set<int> known;

  /// `blur`: each sample is repeated at this distance in all directions; otherwise few samples would have
  /// hardly any variance.
  Lesson(std::span<const CellSamples> samples, float blur, double mostRepeats) {
    for (const CellSamples& sample : samples) {
      const auto feature = featureOf(sample.cell);
      const int repeats =
          static_cast<int>(std::clamp(std::round(std::sqrt(sample.pixels)), 1.0, mostRepeats));
      for (int i = 0; i < repeats; ++i) add(feature, sample.colorClass);
      for (std::size_t axis = 0; axis < kDimensions && blur > 0; ++axis) {
        for (const float off : {-blur, blur}) {
          auto beside = feature;
          beside[axis] += off;
          for (int i = 0; i < repeats; ++i) add(beside, sample.colorClass);
        }
      }
      known.insert(sample.colorClass);
    }
  }
  void add(std::array<float, kDimensions> feature, int colorClass) {
    features.push_back(cv::Mat(1, kDimensions, CV_32F, feature.data()));
    classes.push_back(colorClass);
  }
  /// Classification requires at least two classes.
  bool teaches() const { return known.size() >= 2; }
};

/// Builds a table from the class that `classOf` returns for each cell.
template <typename ClassOf>
ColorTable tableOf(ClassOf classOf) {
  ColorTable table;
  for (std::size_t y = 0, cell = 0; y < kCellsASide; ++y) {
    for (std::size_t cb = 0; cb < kCellsASide; ++cb) {
      for (std::size_t cr = 0; cr < kCellsASide; ++cr, ++cell) {
        table.setCell(static_cast<int>(y), static_cast<int>(cb), static_cast<int>(cr),
                      static_cast<std::uint8_t>(classOf(cell)));
      }
    }
  }
  return table;
}

/// The Mahalanobis distance of features from the mean of a class.
class Spread {
 public:
  Spread(const Lesson& lesson, int colorClass) {
    cv::Mat rows(0, kDimensions, CV_32F);
    for (int i = 0; i < lesson.features.rows; ++i) {
      if (lesson.classes.at<int>(i) == colorClass) rows.push_back(lesson.features.row(i));
    }
    cv::Mat covariance;
    cv::calcCovarMatrix(rows, covariance, mean_, cv::COVAR_NORMAL | cv::COVAR_ROWS | cv::COVAR_SCALE, CV_64F);
    inverse_ = covariance.inv(cv::DECOMP_CHOLESKY);
  }
  double squaredDistance(const float* feature) const {
    std::array<double, kDimensions> off{};
    double sum = 0;
    for (int i = 0; i < kDimensions; ++i) off[static_cast<std::size_t>(i)] = feature[i] - mean_.at<double>(i);
    for (int i = 0; i < kDimensions; ++i) {
      for (int j = 0; j < kDimensions; ++j) {
        sum +=
            off[static_cast<std::size_t>(i)] * inverse_.at<double>(i, j) * off[static_cast<std::size_t>(j)];
      }
    }
    return sum;
  }

 private:
  cv::Mat mean_, inverse_;
};

/// Whether a cell is close to a sample of any class.
class Neighborhood {
 public:
  Neighborhood(std::span<const CellSamples> samples, double mostDistance)
      : squared_(mostDistance * mostDistance) {
    for (const CellSamples& sample : samples) colors_.push_back(weighted(sample.cell));
  }
  bool contains(std::size_t cell) const {
    const CellColor at = weighted(cell);
    return std::ranges::any_of(colors_, [&](const CellColor& color) {
      const double y = color.y - at.y, cb = color.cb - at.cb, cr = color.cr - at.cr;
      return y * y + cb * cb + cr * cr <= squared_;
    });
  }

 private:
  static CellColor weighted(std::size_t cell) {
    CellColor color = cellColorOf(cell);
    color.y *= kBrightnessWeight;
    return color;
  }
  double squared_;
  std::vector<CellColor> colors_;
};

}  // namespace

ColorTable gaussianTable(std::span<const CellSamples> samples, const GaussianOptions& options) {
  const Lesson lesson(samples, kBlur, kMaxRepeats);
  if (!lesson.teaches()) return {};
  const auto classifier = cv::ml::NormalBayesClassifier::create();
  classifier->train(lesson.features, cv::ml::ROW_SAMPLE, lesson.classes);
  const cv::Mat features = featuresOfAllCells();
  cv::Mat found;
  classifier->predict(features, found);
  std::map<int, Spread> spreads;
  for (const int colorClass : lesson.known) spreads.emplace(colorClass, Spread(lesson, colorClass));
  return tableOf([&](std::size_t cell) {
    const int row = static_cast<int>(cell);
    const int colorClass = found.at<int>(row);
    if (colorClass == ColorClasses::kNone) return 0;
    return spreads.at(colorClass).squaredDistance(features.ptr<float>(row)) <= options.mostSquaredDistance
               ? colorClass
               : 0;
  });
}

ColorTable supportVectorTable(std::span<const CellSamples> samples, const SupportVectorOptions& options) {
  const Lesson lesson(samples, 0, 1);  // no repetitions: the training time grows more than linearly
  if (!lesson.teaches()) return {};
  const auto machine = cv::ml::SVM::create();
  machine->setType(cv::ml::SVM::C_SVC);
  machine->setKernel(cv::ml::SVM::RBF);
  machine->setC(options.cost);
  machine->setGamma(options.gamma);
  machine->train(lesson.features, cv::ml::ROW_SAMPLE, lesson.classes);
  cv::Mat found;
  machine->predict(featuresOfAllCells(), found);
  const Neighborhood near(samples, options.mostDistance);
  return tableOf([&](std::size_t cell) {
    const int colorClass = static_cast<int>(found.at<float>(static_cast<int>(cell)));
    return colorClass != ColorClasses::kNone && near.contains(cell) ? colorClass : 0;
  });
}

}  // namespace colortool
