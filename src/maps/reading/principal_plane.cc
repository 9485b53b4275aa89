#include "maps/reading/principal_plane.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "maps/reading/winner_search.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Vector = std::vector<double>;

// More vectors than are needed, with which the iteration converges at the ratio of the ninth to the
// second eigenvalue; up to 8 elements need no iteration.
constexpr std::size_t kBlock = 8;
constexpr int kMostIterations = 300;
constexpr double kConverged = 1e-13;  // relative change of the first two eigenvalues

double dot(const Vector& a, const Vector& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum = std::fma(a[i], b[i], sum);
  return sum;
}

void add(Vector& to, const Vector& vector, double factor) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = std::fma(vector[i], factor, to[i]);
}

// Gram and Schmidt, twice for rounding; what depends on the vectors before becomes 0.
void orthonormalize(std::vector<Vector>& vectors) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    const double before = std::sqrt(dot(vectors[i], vectors[i]));
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t j = 0; j < i; ++j) {
        add(vectors[i], vectors[j], -dot(vectors[i], vectors[j]));
      }
    }
    const double length = std::sqrt(dot(vectors[i], vectors[i]));
    const bool is_dependent = !(length > 1e-12 * before);
    for (double& value : vectors[i]) value = is_dependent ? 0.0 : value / length;
  }
}

// The eigenvectors of a small symmetric matrix as rows, by Jacobi's rotations; `matrix` becomes
// diagonal.
std::vector<Vector> eigenvectors_of(std::vector<Vector>& matrix) {
  const std::size_t size = matrix.size();
  std::vector<Vector> vectors(size, Vector(size, 0.0));
  for (std::size_t i = 0; i < size; ++i) vectors[i][i] = 1.0;
  constexpr int kSweeps = 60;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double rest = 0.0;
    for (std::size_t p = 0; p < size; ++p) {
      for (std::size_t q = p + 1; q < size; ++q) {
        rest += std::fabs(matrix[p][q]);
        if (matrix[p][q] == 0.0) continue;
        const double theta = (matrix[q][q] - matrix[p][p]) / (2 * matrix[p][q]);
        const double tangent =
            (theta >= 0 ? 1.0 : -1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
        const double cosine = 1 / std::sqrt(tangent * tangent + 1);
        const double sine = tangent * cosine;
        for (std::size_t k = 0; k < size; ++k) {
          const double at_p = matrix[k][p];
          const double at_q = matrix[k][q];
          matrix[k][p] = cosine * at_p - sine * at_q;
          matrix[k][q] = sine * at_p + cosine * at_q;
        }
        for (std::size_t k = 0; k < size; ++k) {
          const double at_p = matrix[p][k];
          const double at_q = matrix[q][k];
          matrix[p][k] = cosine * at_p - sine * at_q;
          matrix[q][k] = sine * at_p + cosine * at_q;
        }
        for (std::size_t k = 0; k < size; ++k) {
          const double of_p = vectors[p][k];
          const double of_q = vectors[q][k];
          vectors[p][k] = cosine * of_p - sine * of_q;
          vectors[q][k] = sine * of_p + cosine * of_q;
        }
      }
    }
    if (rest == 0.0) break;
  }
  return vectors;
}

// Rows around their mean.
class Centred {
 public:
  Centred(const LaneMatrix<float>& weights, const Vector& mean) : rows_(weights.rows(), mean) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (std::size_t d = 0; d < mean.size(); ++d) {
        rows_[i][d] = double{weights(i, d)} - mean[d];
      }
    }
  }

  // The product of their scatter matrix with a vector.
  Vector scatter_times(const Vector& vector) const {
    Vector product(vector.size(), 0.0);
    for (const Vector& row : rows_) add(product, row, dot(row, vector));
    return product;
  }

  double variance() const {
    return std::accumulate(rows_.begin(), rows_.end(), 0.0,
                           [](double sum, const Vector& row) { return sum + dot(row, row); });
  }

  Position position(std::size_t row, const std::array<Vector, 2>& axes) const {
    return {dot(rows_[row], axes[0]), dot(rows_[row], axes[1])};
  }

 private:
  std::vector<Vector> rows_;
};

std::vector<Vector> first_block(std::size_t size) {
  std::vector<Vector> block(std::min(kBlock, size), Vector(size));
  Random random(1);
  for (Vector& vector : block) {
    for (double& value : vector) value = random.uniform() - 0.5;
  }
  orthonormalize(block);
  return block;
}

struct Eigen {
  double value = 0.0;
  Vector vector;
};

// The eigenvectors of the scatter matrix within the block, the greatest value first (Rayleigh and
// Ritz).
std::vector<Eigen> within(const std::vector<Vector>& block, const std::vector<Vector>& products) {
  std::vector<Vector> small(block.size(), Vector(block.size()));
  for (std::size_t i = 0; i < block.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) small[i][j] = small[j][i] = dot(block[i], products[j]);
  }
  const std::vector<Vector> rotation = eigenvectors_of(small);
  std::vector<Eigen> all;
  for (std::size_t i = 0; i < block.size(); ++i) {
    Vector vector(block[0].size(), 0.0);
    for (std::size_t j = 0; j < block.size(); ++j) add(vector, block[j], rotation[i][j]);
    all.push_back({small[i][i], std::move(vector)});
  }
  // A handful, in a tie in their order.
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto greatest =
        std::max_element(all.begin() + static_cast<std::ptrdiff_t>(i), all.end(),
                         [](const Eigen& a, const Eigen& b) { return a.value < b.value; });
    std::swap(all[i], *greatest);
  }
  return all;
}

double changed(const std::vector<Eigen>& eigen, const std::vector<Eigen>& before) {
  double change = before.empty() ? 1.0 : 0.0;
  for (std::size_t i = 0; i < std::min<std::size_t>(before.size(), 2); ++i) {
    change = std::max(
        change, std::fabs(eigen[i].value - before[i].value) / std::max(eigen[0].value, 1e-300));
  }
  return change;
}

// Subspace iteration.
std::vector<Eigen> greatest_of(const Centred& rows, std::size_t size) {
  std::vector<Vector> block = first_block(size);
  std::vector<Eigen> eigen;
  for (int i = 0; i < kMostIterations; ++i) {
    std::vector<Vector> products;
    products.reserve(block.size());
    for (const Vector& vector : block) products.push_back(rows.scatter_times(vector));
    std::vector<Eigen> now = within(block, products);
    const double change = changed(now, eigen);
    eigen = std::move(now);
    if (change < kConverged) break;
    block = std::move(products);
    orthonormalize(block);
  }
  return eigen;
}

void set_sign(Vector& vector) {
  const auto greatest = std::max_element(
      vector.begin(), vector.end(), [](double a, double b) { return std::fabs(a) < std::fabs(b); });
  if (greatest == vector.end() || *greatest >= 0) return;
  for (double& value : vector) value = -value;
}

Vector mean_of(const LaneMatrix<float>& weights) {
  Vector mean(weights.columns(), 0.0);
  for (std::size_t i = 0; i < weights.rows(); ++i) {
    for (std::size_t d = 0; d < mean.size(); ++d) mean[d] += double{weights(i, d)};
  }
  for (double& value : mean) value /= static_cast<double>(weights.rows());
  return mean;
}

}  // namespace

PrincipalPlane::PrincipalPlane(const Som& som) : mean_(mean_of(som.weights())) {
  // Variances below this are rounding of equal weights.
  constexpr double kLeastShare = 1e-12;
  const Centred rows(som.weights(), mean_);
  const double variance = rows.variance();
  const std::vector<Eigen> eigen =
      variance > 0 ? greatest_of(rows, mean_.size()) : std::vector<Eigen>();
  for (std::size_t i = 0; i < 2; ++i) {
    axes_[i].assign(mean_.size(), 0.0);
    if (i >= eigen.size() || !(eigen[i].value > kLeastShare * variance)) continue;
    axes_[i] = eigen[i].vector;
    set_sign(axes_[i]);
    shares_[i] = std::min(eigen[i].value / variance, 1.0);
  }
  for (std::size_t n = 0; n < som.neurons(); ++n) neurons_.push_back(rows.position(n, axes_));
}

std::vector<Position> PrincipalPlane::positions_of(const Som& som, const Samples& samples) const {
  Samples storage;
  const Samples& seen = seen_samples(som, samples, storage);
  std::vector<Position> positions;
  positions.reserve(seen.count());
  const std::array<double, 2> of_mean{dot(mean_, axes_[0]), dot(mean_, axes_[1])};
  for (std::size_t i = 0; i < seen.count(); ++i) {
    const SignalView sample = seen[i];
    Position at{-of_mean[0], -of_mean[1]};
    for (std::size_t k = 0; k < sample.values.size(); ++k) {
      const std::size_t d = sample.sparse ? sample.indices[k] : k;
      at.x = std::fma(double{sample.values[k]}, axes_[0][d], at.x);
      at.y = std::fma(double{sample.values[k]}, axes_[1][d], at.y);
    }
    positions.push_back(at);
  }
  return positions;
}

}  // namespace somato
