#include "maps/reading/class_whitening.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "somato/core/check.h"

namespace somato {
namespace {

using Values = std::vector<double>;

Matrix<double> dense_rows(const Samples& samples, std::span<const std::size_t> places) {
  Matrix<double> rows(places.size(), samples.size());
  std::vector<float> row(samples.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    write_dense(samples[places[i]], row);
    std::copy(row.begin(), row.end(), rows.row(i).begin());
  }
  return rows;
}

// Returns the number of classes.
std::size_t subtract_class_means(std::span<const std::size_t> classes, Matrix<double>& rows) {
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < classes.size(); ++i) members[classes[i]].push_back(i);
  for (const auto& [the_class, of_class] : members) {
    for (std::size_t d = 0; d < rows.columns(); ++d) {
      double sum = 0.0;
      for (const std::size_t i : of_class) sum += rows(i, d);
      const double mean = sum / static_cast<double>(of_class.size());
      for (const std::size_t i : of_class) rows(i, d) -= mean;
    }
  }
  return members.size();
}

// The lower triangle of rows' rows.
Matrix<double> scatter_of(const Matrix<double>& rows) {
  Matrix<double> scatter(rows.columns(), rows.columns());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const auto row = rows.row(i);
    for (std::size_t a = 0; a < row.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        scatter(a, b) = std::fma(row[a], row[b], scatter(a, b));
      }
    }
  }
  return scatter;
}

// Over the elements that vary within classes; 0 if none does.
double mean_variance(const Matrix<double>& scatter, double freedom) {
  double sum = 0.0;
  double varying = 0.0;
  for (std::size_t d = 0; d < scatter.rows(); ++d) {
    sum += scatter(d, d);
    varying += scatter(d, d) > 0.0 ? 1.0 : 0.0;
  }
  return varying > 0.0 ? sum / (varying * freedom) : 0.0;
}

double product(std::span<const double> a, std::span<const double> b, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) sum = std::fma(a[i], b[i], sum);
  return sum;
}

// The lower triangle L of a positive definite matrix L L', of which the lower triangle is given.
void factorize(Matrix<double>& matrix) {
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double rest = matrix(i, j) - product(matrix.row(i), matrix.row(j), j);
      matrix(i, j) = i == j ? std::sqrt(rest) : rest / matrix(j, j);
    }
  }
}

// The inverse of a lower triangle.
Matrix<double> inverse_of(const Matrix<double>& triangle) {
  const std::size_t size = triangle.rows();
  Matrix<double> inverse(size, size);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double factor = triangle(i, j);
      for (std::size_t d = 0; d <= j; ++d) {
        inverse(i, d) = std::fma(-factor, inverse(j, d), inverse(i, d));
      }
    }
    inverse(i, i) = 1.0;
    for (std::size_t d = 0; d <= i; ++d) inverse(i, d) /= triangle(i, i);
  }
  return inverse;
}

Matrix<double> identity(std::size_t size) {
  Matrix<double> matrix(size, size);
  for (std::size_t i = 0; i < size; ++i) matrix(i, i) = 1.0;
  return matrix;
}

void multiply(const Matrix<double>& triangle, std::span<const double> values,
              std::span<double> out) {
  for (std::size_t i = 0; i < triangle.rows(); ++i) {
    out[i] = product(triangle.row(i), values, i + 1);
  }
}

}  // namespace

bool can_be_whitened(const Som& som) {
  const SomParameters& parameters = som.parameters();
  return parameters.similarity == Similarity::kEuclidean &&
         !parameters.normalize_input.value_or(false) && parameters.layers.empty() &&
         som.input_size() <= kMostWhitenedElements;
}

tl::unexpected<Error> not_to_be_whitened() {
  return fail(ErrorKind::kUsage, "'whitening_shrinkage' does not fit the map", {},
              "leave it out, or use a map with Euclidean distances, without normalized inputs or "
              "layers, of at most " +
                  std::to_string(kMostWhitenedElements) + " elements");
}

Matrix<double> whitening_within_classes(const Samples& samples, std::span<const std::size_t> places,
                                        std::span<const std::size_t> classes, double shrinkage) {
  require(!places.empty() && places.size() == classes.size(),
          "whitening needs samples, each with a class");
  require(samples.size() <= kMostWhitenedElements, "too many elements to be whitened");
  require(shrinkage > 0.0 && shrinkage <= 1.0, "a shrinkage is above 0 and at most 1");
  Matrix<double> rows = dense_rows(samples, places);
  const std::size_t count = subtract_class_means(classes, rows);
  Matrix<double> covariance = scatter_of(rows);
  const auto freedom = static_cast<double>(places.size() - count);
  const double mean = mean_variance(covariance, freedom);
  if (!(mean > 0.0)) return identity(samples.size());
  // Divided by shrinkage m, which is B' B's inverse.
  const double factor = (1.0 - shrinkage) / (shrinkage * mean * freedom);
  for (std::size_t i = 0; i < covariance.rows(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) covariance(i, j) *= factor;
    covariance(i, i) += 1.0;
  }
  factorize(covariance);
  return inverse_of(covariance);
}

WhitenedNeurons::WhitenedNeurons(const Matrix<double>& whitening, const Som& som,
                                 std::vector<std::size_t> neurons)
    : whitening_(&whitening),
      neurons_(std::move(neurons)),
      rows_(neurons_.size(), som.input_size()) {
  require(!neurons_.empty(), "whitened distances need a neuron");
  require(whitening.rows() == som.input_size() && whitening.columns() == som.input_size(),
          "a whitening has the size of the map's inputs");
  Values weights(som.input_size());
  for (std::size_t i = 0; i < neurons_.size(); ++i) {
    for (std::size_t d = 0; d < weights.size(); ++d) {
      weights[d] = double{som.weight(neurons_[i], d)};
    }
    multiply(*whitening_, weights, rows_.row(i));
  }
}

WhitenedNeurons::Nearest WhitenedNeurons::nearest(const SignalView& input,
                                                  std::optional<std::size_t> except) const {
  std::vector<float> dense(input.size);
  write_dense(input, dense);
  const Values values(dense.begin(), dense.end());
  Values whitened(values.size());
  multiply(*whitening_, values, whitened);
  std::optional<Nearest> best;
  for (std::size_t i = 0; i < neurons_.size(); ++i) {
    if (neurons_[i] == except && neurons_.size() > 1) continue;
    double squared = 0.0;
    for (std::size_t d = 0; d < whitened.size(); ++d) {
      const double difference = whitened[d] - rows_(i, d);
      squared = std::fma(difference, difference, squared);
    }
    if (!best || squared < best->distance) best = Nearest{neurons_[i], squared};
  }
  best->distance = std::sqrt(best->distance);
  return *best;
}

}  // namespace somato
