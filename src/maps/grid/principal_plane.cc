#include "maps/grid/principal_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "base/core/threads.h"
#include "maps/grid/leading_eigenvectors.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::size_t kPlaneStrip = 64;       // rows that are multiplied at once
constexpr std::size_t kRowsOfPlaneTask = 16;  // of the sums
constexpr double kNoVariance = 1e-12;         // of that of the first component
constexpr int kMostPlaneBits = 22;            // of the integer that stands for a value
constexpr int kBitsOfPlaneSum = 62;
constexpr std::size_t kSamplesExact = 512;  // the products of which a double holds: 2^9 2^44 = 2^53

std::vector<std::size_t> varying_features(std::span<const float> low, std::span<const float> high) {
  std::vector<std::size_t> varying;
  for (std::size_t d = 0; d < low.size(); ++d) {
    if (low[d] < high[d]) varying.push_back(d);
  }
  return varying;
}

std::vector<double> centres_of(std::span<const float> low, std::span<const float> high) {
  std::vector<double> centres(low.size());
  for (std::size_t d = 0; d < low.size(); ++d)
    centres[d] = 0.5 * (double{low[d]} + double{high[d]});
  return centres;
}

// Adds the products of columns i <= j of the first `rows` rows, one row after the other; of four
// rows in one pass over the sums.
void add_row_of_products(const Matrix<double>& strip, std::size_t rows, std::size_t i,
                         std::span<double> sums) {
  std::size_t s = 0;
  for (; s + 4 <= rows; s += 4) {
    const double* const a = strip.row(s).data();
    const double* const b = strip.row(s + 1).data();
    const double* const c = strip.row(s + 2).data();
    const double* const d = strip.row(s + 3).data();
    for (std::size_t j = i; j < sums.size(); ++j) {
      sums[j] = (((sums[j] + a[i] * a[j]) + b[i] * b[j]) + c[i] * c[j]) + d[i] * d[j];
    }
  }
  for (; s < rows; ++s) {
    const double* const a = strip.row(s).data();
    for (std::size_t j = i; j < sums.size(); ++j) sums[j] += a[i] * a[j];
  }
}

void add_products_of_strip(const Matrix<double>& strip, std::size_t rows, Matrix<double>& sums,
                           std::size_t threads) {
  const std::size_t tasks = (sums.rows() + kRowsOfPlaneTask - 1) / kRowsOfPlaneTask;
  for_each_task(tasks, threads, [&](std::size_t task) {
    const std::size_t end = std::min(sums.rows(), (task + 1) * kRowsOfPlaneTask);
    for (std::size_t i = task * kRowsOfPlaneTask; i < end; ++i) {
      add_row_of_products(strip, rows, i, sums.row(i));
    }
  });
}

void mirror(Matrix<double>& upper) {
  for (std::size_t i = 0; i < upper.rows(); ++i) {
    for (std::size_t j = 0; j < i; ++j) upper(i, j) = upper(j, i);
  }
}

// The roots of the two largest eigenvalues; the second is 0 if it is no more than rounding.
std::pair<double, double> deviations(const Eigenvectors& found) {
  const auto value = [&](std::size_t k) { return k < found.values.size() ? found.values[k] : 0.0; };
  const double first = std::max(0.0, value(0));
  const double second = value(1) > kNoVariance * first ? value(1) : 0.0;
  return {std::sqrt(first), std::sqrt(second)};
}

void orient(std::vector<double>& component) {
  std::size_t greatest = 0;
  for (std::size_t d = 1; d < component.size(); ++d) {
    if (std::fabs(component[d]) > std::fabs(component[greatest])) greatest = d;
  }
  if (component.empty() || component[greatest] >= 0.0) return;
  for (double& value : component) value = -value;
}

// Reads some features of all samples, in ascending order of the features, minus an offset of each.
class FeatureStrips {
 public:
  FeatureStrips(const Samples& samples, const std::vector<std::size_t>& features,
                const std::vector<double>& offsets)
      : samples_(samples),
        features_(features),
        offsets_(offsets),
        places_(samples.count()),
        strip_(kPlaneStrip, samples.count()) {}

  // Calls `use` with a strip of features x samples, the number of its rows, and the first of these
  // in the list of features.
  template <typename Use>
  void for_each(const Use& use) {
    std::fill(places_.begin(), places_.end(), std::size_t{0});
    for (std::size_t first = 0; first < features_.size(); first += kPlaneStrip) {
      const std::size_t rows = std::min(kPlaneStrip, features_.size() - first);
      for (std::size_t i = 0; i < samples_.count(); ++i) read(i, first, rows);
      use(strip_, rows, first);
    }
  }

 private:
  void read(std::size_t sample, std::size_t first, std::size_t rows) {
    const SignalView values = samples_[sample];
    for (std::size_t r = 0; r < rows; ++r) {
      const std::size_t feature = features_[first + r];
      strip_(r, sample) = double{value(values, sample, feature)} - offsets_[feature];
    }
  }

  float value(const SignalView& values, std::size_t sample, std::size_t feature) {
    if (!values.sparse) return values.values[feature];
    std::size_t& place = places_[sample];
    while (place < values.indices.size() && values.indices[place] < feature) ++place;
    const bool is_there = place < values.indices.size() && values.indices[place] == feature;
    return is_there ? values.values[place] : 0.0F;
  }

  const Samples& samples_;
  const std::vector<std::size_t>& features_;
  const std::vector<double>& offsets_;
  std::vector<std::size_t> places_;  // in sparse samples
  Matrix<double> strip_;
};

// The means, by sums of differences from the centres, which are exact for equal values.
std::vector<double> means_of_samples(const Samples& samples,
                                     const std::vector<std::size_t>& varying,
                                     const std::vector<double>& centres) {
  std::vector<double> means = centres;
  const auto count = static_cast<double>(samples.count());
  FeatureStrips(samples, varying, centres)
      .for_each([&](const Matrix<double>& strip, std::size_t rows, std::size_t first) {
        for (std::size_t r = 0; r < rows; ++r) {
          double sum = 0.0;
          for (const double value : strip.row(r)) sum += value;
          means[varying[first + r]] += sum / count;
        }
      });
  return means;
}

// The combination of samples minus their means, with factors divided by the root of their number.
void combine_samples(const Matrix<double>& strip, std::size_t rows, std::span<const double> factors,
                     double* out) {
  const double scale = 1.0 / std::sqrt(static_cast<double>(factors.size()));
  for (std::size_t r = 0; r < rows; ++r) {
    double sum = 0.0;
    for (std::size_t i = 0; i < factors.size(); ++i) sum += factors[i] * strip(r, i);
    out[r] = scale * sum;
  }
}

// By the inner products of samples: X' u / sqrt(n) for an eigenvector u of X X', where X are the
// samples minus their mean, is a component times its standard deviation.
PrincipalPlane plane_by_samples(const Samples& samples, const std::vector<std::size_t>& varying,
                                const std::vector<double>& centres, std::size_t threads) {
  const std::size_t size = centres.size();
  PrincipalPlane plane{means_of_samples(samples, varying, centres), std::vector<double>(size),
                       std::vector<double>(size)};
  if (varying.empty()) return plane;
  FeatureStrips strips(samples, varying, plane.mean);
  Matrix<double> products(samples.count(), samples.count());
  strips.for_each([&](const Matrix<double>& strip, std::size_t rows, std::size_t /*first*/) {
    add_products_of_strip(strip, rows, products, threads);
  });
  mirror(products);
  const Eigenvectors found = leading_eigenvectors(products, 2);
  const bool has_second = deviations(found).second > 0.0;
  strips.for_each([&](const Matrix<double>& strip, std::size_t rows, std::size_t first) {
    double out[kPlaneStrip];
    for (const std::size_t k : {0U, 1U}) {
      if (k == 1 && !has_second) continue;
      combine_samples(strip, rows, found.vectors.row(k), out);
      std::vector<double>& component = k == 0 ? plane.first : plane.second;
      for (std::size_t r = 0; r < rows; ++r) component[varying[first + r]] = out[r];
    }
  });
  orient(plane.first);
  orient(plane.second);
  return plane;
}

int plane_bits_for(std::size_t count) {
  return std::min(kMostPlaneBits, (kBitsOfPlaneSum - static_cast<int>(std::bit_width(count))) / 2);
}

// The power of 2 that takes half of a range below 2^bits.
double scale_of_range(float low, float high, int bits) {
  int exponent = 0;
  static_cast<void>(std::frexp(0.5 * (double{high} - double{low}), &exponent));
  return std::ldexp(1.0, bits - exponent);
}

double rounded_to_integer(double value) {
  constexpr double kOneIsLast = 0x1.8p52;  // a double of this size has no places behind the point
  return (value + kOneIsLast) - kOneIsLast;
}

}  // namespace

Result<void> check_plane(std::size_t count, std::span<const float> low,
                         std::span<const float> high) {
  const std::size_t varying = varying_features(low, high).size();
  if (std::min(count, varying) <= kMostRowsOfPlane) return {};
  return fail(
      ErrorKind::kUsage,
      fmt::format("linear initial weights of {} samples with {} features that vary take too "
                  "long; one of these numbers can be at most {}",
                  count, varying, kMostRowsOfPlane),
      "initial_weights", "choose other initial weights, such as range or samples");
}

bool plane_needs_all(std::size_t count, std::span<const float> low, std::span<const float> high) {
  return varying_features(low, high).size() >= count;
}

PrincipalPlane principal_plane(const Samples& samples, std::span<const float> low,
                               std::span<const float> high, std::size_t threads) {
  require(samples.count() > 0 && samples.size() == low.size(),
          "a plane needs samples and the range of each feature");
  if (plane_needs_all(samples.count(), low, high)) {
    return plane_by_samples(samples, varying_features(low, high), centres_of(low, high), threads);
  }
  CovarianceSums sums(samples.count(), low, high, threads);
  sums.add(samples);
  return sums.plane();
}

CovarianceSums::CovarianceSums(std::size_t count, std::span<const float> low,
                               std::span<const float> high, std::size_t threads)
    : count_(count),
      threads_(threads),
      bits_(plane_bits_for(count)),
      centres_(centres_of(low, high)),
      varying_(varying_features(low, high)),
      sums_(size()),
      products_(size() * size()),
      strip_(kPlaneStrip, size()),
      exact_(size(), size()) {
  for (const std::size_t d : varying_) scales_.push_back(scale_of_range(low[d], high[d], bits_));
}

void CovarianceSums::add(const Samples& part) {
  std::vector<float> row(centres_.size());
  for (std::size_t i = 0; i < part.count(); ++i) {
    write_dense(part[i], row);
    for (std::size_t k = 0; k < size(); ++k) {
      const std::size_t d = varying_[k];
      const double integer = rounded_to_integer((double{row[d]} - centres_[d]) * scales_[k]);
      strip_(in_strip_, k) = integer;
      sums_[k] += static_cast<std::int64_t>(integer);
    }
    if (++in_strip_ == kPlaneStrip) add_strip();
  }
}

void CovarianceSums::add_strip() {
  add_products_of_strip(strip_, in_strip_, exact_, threads_);
  in_exact_ += in_strip_;
  in_strip_ = 0;
  if (in_exact_ + kPlaneStrip > kSamplesExact) flush();
}

void CovarianceSums::flush() {
  const std::span<double> exact = exact_.values();
  for (std::size_t i = 0; i < exact.size(); ++i) {
    products_[i] += static_cast<std::int64_t>(exact[i]);
  }
  std::fill(exact.begin(), exact.end(), 0.0);
  in_exact_ = 0;
}

void CovarianceSums::combine(ProcessGroup& processes) {
  add_strip();
  flush();
  processes.sum(sums_);
  processes.sum(products_);
}

Matrix<double> CovarianceSums::covariance() const {
  const auto count = static_cast<double>(count_);
  Matrix<double> covariance(size(), size());
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t j = i; j < size(); ++j) {
      const double of_means =
          static_cast<double>(sums_[i]) * (static_cast<double>(sums_[j]) / count);
      const double sum = static_cast<double>(products_[i * size() + j]) - of_means;
      covariance(i, j) = sum / count / scales_[i] / scales_[j];
    }
  }
  mirror(covariance);
  return covariance;
}

PrincipalPlane CovarianceSums::plane() {
  add_strip();
  flush();
  PrincipalPlane plane{centres_, std::vector<double>(centres_.size()),
                       std::vector<double>(centres_.size())};
  if (varying_.empty()) return plane;
  const Eigenvectors found = leading_eigenvectors(covariance(), 2);
  const auto [first, second] = deviations(found);
  for (std::size_t k = 0; k < size(); ++k) {
    const std::size_t d = varying_[k];
    plane.mean[d] += static_cast<double>(sums_[k]) / static_cast<double>(count_) / scales_[k];
    plane.first[d] = first * found.vectors(0, k);
    if (second > 0.0) plane.second[d] = second * found.vectors(1, k);
  }
  orient(plane.first);
  orient(plane.second);
  return plane;
}

PlanePlace place_on_plane(const Grid& grid, std::size_t neuron) {
  const auto along = [](double place, double last) { return 2.0 * place / last - 1.0; };
  const Position position = grid.position(neuron);
  const bool shifted = grid.lattice() == Lattice::kHexagonal && grid.rows() > 1;
  const double width = grid.position(grid.columns() - 1).x + (shifted ? 0.5 : 0.0);
  const double height = grid.position(grid.size() - 1).y;
  const double horizontal = grid.columns() > 1 ? along(position.x, width) : 0.0;
  const double vertical = grid.rows() > 1 ? along(position.y, height) : 0.0;
  return grid.rows() > grid.columns() ? PlanePlace{vertical, horizontal}
                                      : PlanePlace{horizontal, vertical};
}

std::vector<double> factors_of_component(const PrincipalPlane& plane,
                                         std::span<const double> component,
                                         const Samples& samples) {
  double square = 0.0;
  for (const double value : component) square += value * value;
  std::vector<double> factors(samples.count());
  if (square == 0.0) return factors;
  std::vector<float> row(samples.size());
  for (std::size_t i = 0; i < factors.size(); ++i) {
    write_dense(samples[i], row);
    double sum = 0.0;
    for (std::size_t d = 0; d < row.size(); ++d) {
      sum += (double{row[d]} - plane.mean[d]) * component[d];
    }
    factors[i] = sum / (static_cast<double>(samples.count()) * square);
  }
  return factors;
}

}  // namespace somato
