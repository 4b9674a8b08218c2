// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robotlink/base/Random.h"
#include "simcore/rendering/CameraRenderer.h"

using namespace simcore;
using robotlink::Image;
using robotlink::PixelFormat;

namespace {

/// Images of nothing but a gray background.
class GrayCamera {
 public:
  explicit GrayCamera(CameraRenderer::Arithmetic arithmetic = CameraRenderer::Arithmetic::kFastest)
      : renderer_(scene(), {false, arithmetic}) {}

  Image image(const ImageNoise& noise, PixelFormat format = PixelFormat::kYuyv) {
    Image image;
    renderer_.render(Pose3::Identity(), {}, format, noise, image);
    return image;
  }

 private:
  static std::shared_ptr<const RenderScene> scene() {
    auto scene = std::make_shared<RenderScene>();
    scene->background = {128, 128, 128};
    return scene;
  }
  CameraRenderer renderer_;
};

/// The deviations of every `stride`-th byte from gray.
std::vector<double> deviations(const Image& image, std::size_t first = 0, std::size_t stride = 1) {
  std::vector<double> result;
  for (std::size_t i = first; i < image.data.size(); i += stride) result.push_back(image.data[i] - 128.0);
  return result;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double covariance(const std::vector<double>& a, const std::vector<double>& b) {
  const double meanA = mean(a), meanB = mean(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - meanA) * (b[i] - meanB);
  return sum / static_cast<double>(a.size());
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  return covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
}

}  // namespace

TEST(ImageNoise, hasNoMeanAndTheSigmaAskedFor) {
  GrayCamera camera;
  for (const double sigma : {1.0, 2.0, 5.0, 20.0}) {
    for (const PixelFormat format : {PixelFormat::kYuyv, PixelFormat::kRgb8}) {
      const std::vector<double> noise = deviations(camera.image({sigma, 1, 2, 3}, format));
      EXPECT_NEAR(mean(noise), 0, 4 * sigma / std::sqrt(static_cast<double>(noise.size())));
      EXPECT_NEAR(std::sqrt(covariance(noise, noise)), sigma, 0.03 * sigma);
    }
  }
}

TEST(ImageNoise, isAlikeInAllChannels) {
  const Image image = GrayCamera().image({4.0, 7, 7, 7});
  for (std::size_t channel = 0; channel < 4; ++channel) {
    const std::vector<double> noise = deviations(image, channel, 4);
    EXPECT_NEAR(mean(noise), 0, 4 * 4.0 / std::sqrt(static_cast<double>(noise.size())));
    EXPECT_NEAR(std::sqrt(covariance(noise, noise)), 4.0, 0.12);
  }
}

TEST(ImageNoise, isNearlyGaussian) {
  const std::vector<double> noise = deviations(GrayCamera().image({10.0, 3, 1, 1}, PixelFormat::kRgb8));
  double fourth = 0, within = 0;
  for (const double value : noise) {
    fourth += std::pow(value / 10.0, 4);
    within += std::abs(value) <= 10.0 ? 1 : 0;
  }
  EXPECT_NEAR(fourth / static_cast<double>(noise.size()), 2.7, 0.1)
      << "the kurtosis of a sum of four uniform numbers";
  EXPECT_NEAR(within / static_cast<double>(noise.size()), 0.68, 0.03);
}

TEST(ImageNoise, isIndependentBetweenFramesStreamsAndSeeds) {
  GrayCamera camera;
  const std::vector<double> first = deviations(camera.image({5.0, 1, 1, 1}));
  for (const ImageNoise& other :
       {ImageNoise{5.0, 1, 1, 2}, {5.0, 1, 2, 1}, {5.0, 2, 1, 1}, {5.0, 1, 1, 1000001}}) {
    EXPECT_LT(std::abs(correlation(first, deviations(camera.image(other)))), 0.02);
  }
}

TEST(ImageNoise, isIndependentBetweenNeighbors) {
  GrayCamera camera;
  const std::vector<double> noise = deviations(camera.image({5.0, 1, 1, 1}));
  for (const std::ptrdiff_t distance : {1, 2, 4, 8, 176 * 2}) {
    const std::vector<double> a(noise.begin(), noise.end() - distance),
        b(noise.begin() + distance, noise.end());
    EXPECT_LT(std::abs(correlation(a, b)), 0.02) << distance;
  }
}

TEST(ImageNoise, isTheSameForTheSameNumbers) {
  GrayCamera one, portable(CameraRenderer::Arithmetic::kPortable);
  const Image image = one.image({5.0, 1, 2, 3});
  EXPECT_EQ(image, one.image({5.0, 1, 2, 3}));
  EXPECT_EQ(image, portable.image({5.0, 1, 2, 3}));
  EXPECT_NE(image, one.image({5.0, 1, 2, 4}));
}

TEST(ImageNoise, isTheDocumentedFunctionOfKeyAndPosition) {
  const ImageNoise noise{40.0, 1, 2, 3};
  const std::uint64_t bits = robotlink::hashBits(noise.seed, noise.stream, noise.frame);
  const auto scale = static_cast<float>(std::sqrt((40.0 * 40.0 - 1.0 / 12) * 3 / 65535));
  auto scene = std::make_shared<RenderScene>();
  scene->bodies = {"world"};
  for (const auto arithmetic :
       {CameraRenderer::Arithmetic::kFastest, CameraRenderer::Arithmetic::kPortable}) {
    const CameraRenderer renderer(scene, {false, arithmetic});
    // More and fewer bytes than are computed together, and all gray values.
    for (const int size : {1, 7, 31, 32, 33, 95, 1000}) {
      Image image;
      image.format = PixelFormat::kMono8;
      image.width = size;
      image.height = 1;
      for (int i = 0; i < size; ++i) image.data.push_back(static_cast<std::uint8_t>(i));
      renderer.addNoise(noise, image);
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(size); ++i) {
        std::uint32_t h = i ^ static_cast<std::uint32_t>(bits);
        h = (h ^ h >> 16) * 0x7FEB352DU;
        h = ((h ^ h >> 15) + static_cast<std::uint32_t>(bits >> 32)) * 0x846CA68BU;
        h ^= h >> 16;
        const auto sum = static_cast<int>((h & 255) + (h >> 8 & 255) + (h >> 16 & 255) + (h >> 24)) - 510;
        const float value = static_cast<float>(i & 255) + static_cast<float>(sum) * scale + 0.5F;
        ASSERT_EQ(image.data[i], static_cast<int>(std::clamp(value, 0.0F, 255.0F))) << i << " of " << size;
      }
    }
  }
}

TEST(ImageNoise, noneIsAddedWhenSigmaIsZero) {
  for (const double deviation : deviations(GrayCamera().image({0.0, 1, 2, 3}))) ASSERT_EQ(deviation, 0);
}

TEST(ImageNoise, staysWithinTheBytes) {
  const Image image = GrayCamera().image({200.0, 1, 2, 3});
  std::size_t low = 0, high = 0;
  for (const std::uint8_t byte : image.data) {
    low += byte == 0 ? 1 : 0;
    high += byte == 255 ? 1 : 0;
  }
  EXPECT_GT(low, image.data.size() / 6);
  EXPECT_GT(high, image.data.size() / 6);
}
