// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/series/Spectrum.h"

#include <kissfft/kiss_fftr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace robotlink {
namespace {

constexpr std::size_t kMinPoints = 16;

/// The weights of cos(0), cos(x), cos(2x), ... of a window, with alternating signs.
std::array<double, 5> cosinesOf(SpectrumWindow window) {
  switch (window) {
    case SpectrumWindow::kHann:
      return {0.5, 0.5};
    case SpectrumWindow::kHamming:
      return {0.54, 0.46};
    case SpectrumWindow::kBlackman:
      return {0.42, 0.5, 0.08};
    case SpectrumWindow::kFlatTop:
      return {0.21557895, 0.41663158, 0.277263158, 0.083578947, 0.006947368};
    default:
      return {1};
  }
}

std::vector<double> weights(SpectrumWindow window, std::size_t count) {
  const auto cosines = cosinesOf(window);
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    double sign = 1;
    for (std::size_t k = 0; k < cosines.size(); ++k, sign = -sign)
      all[i] += sign * cosines[k] * std::cos(static_cast<double>(k) * x);
  }
  return all;
}

/// The points of a series that are numbers, one for each time.
std::vector<Series::Point> numbersIn(const Series& series, double from, double to) {
  std::vector<Series::Point> points;
  const std::size_t end = series.firstAfter(to);
  for (std::size_t i = series.firstFrom(from); i < end; ++i) {
    const Series::Point point = series[i];
    if (!std::isfinite(point.value)) continue;
    if (!points.empty() && points.back().time == point.time) points.pop_back();
    points.push_back(point);
  }
  return points;
}

/// The nearest number of samples that is not greater and has small factors only, of which a transform is
/// quick.
std::size_t fastCount(std::size_t most) {
  int count = static_cast<int>(most - most % 2);
  while (kiss_fftr_next_fast_size_real(count) != count) count -= 2;
  return static_cast<std::size_t>(count);
}

/// Values at even distances, on the lines between points.
std::vector<double> sampled(const std::vector<Series::Point>& points, std::size_t count) {
  const double from = points.front().time;
  const double step = (points.back().time - from) / static_cast<double>(count - 1);
  std::vector<double> samples;
  samples.reserve(count);
  std::size_t next = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double time = from + static_cast<double>(i) * step;
    while (next + 1 < points.size() && points[next].time < time) ++next;
    const Series::Point &a = points[next - 1], &b = points[next];
    const double share = std::clamp((time - a.time) / (b.time - a.time), 0.0, 1.0);
    samples.push_back(a.value + share * (b.value - a.value));
  }
  return samples;
}

}  // namespace

Result<Spectrum> spectrumOf(const Series& series, double from, double to, SpectrumWindow window) {
  const auto points = numbersIn(series, from, to);
  if (points.size() < kMinPoints)
    return failure("spectrum.points", "a spectrum needs " + std::to_string(kMinPoints) + " points or more");
  Spectrum spectrum;
  const std::size_t count = fastCount(std::min(points.size(), kMaxSpectrumSamples));
  spectrum.isThinned = points.size() > kMaxSpectrumSamples;
  const double length = points.back().time - points.front().time;
  spectrum.rate = static_cast<double>(count - 1) / length;
  spectrum.step = spectrum.rate / static_cast<double>(count);
  for (std::size_t i = 1; i < points.size(); ++i)
    spectrum.largestGap =
        std::max(spectrum.largestGap, (points[i].time - points[i - 1].time) * spectrum.rate);

  const auto samples = sampled(points, count);
  const auto shape = weights(window, count);
  double mean = 0, gain = 0;
  for (std::size_t i = 0; i < count; ++i) {
    mean += samples[i] / static_cast<double>(count);
    gain += shape[i];
  }
  std::vector<kiss_fft_scalar> in(count);
  for (std::size_t i = 0; i < count; ++i)
    in[i] = static_cast<kiss_fft_scalar>((samples[i] - mean) * shape[i]);
  std::vector<kiss_fft_cpx> out(count / 2 + 1);
  const std::unique_ptr<kiss_fftr_state, void (*)(void*)> plan(
      kiss_fftr_alloc(static_cast<int>(count), 0, nullptr, nullptr),
      [](void* memory) { kiss_fftr_free(memory); });
  if (!plan) return failure("spectrum.memory", "there is too little memory for a spectrum");
  kiss_fftr(plan.get(), in.data(), out.data());
  for (std::size_t i = 0; i < out.size(); ++i) {
    // The last one has no counterpart among the negative frequencies.
    const double both = i == count / 2 ? 1 : 2;
    spectrum.amplitudes.push_back(both * std::hypot(double{out[i].r}, double{out[i].i}) / gain);
  }
  spectrum.amplitudes.front() = std::abs(mean);
  return spectrum;
}

}  // namespace robotlink
