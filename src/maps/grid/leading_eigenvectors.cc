#include "maps/grid/leading_eigenvectors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "somato/core/random.h"

namespace somato {
namespace {

constexpr std::size_t kMostRowsToRotate = 64;
constexpr std::size_t kKrylovBlock = 8;   // vectors that are multiplied at once
constexpr std::size_t kKrylovBlocks = 8;  // of a Krylov space
constexpr std::size_t kKrylovRestarts = 60;
constexpr double kKrylovResidual = 1e-10;  // of the largest eigenvalue

// One rotation that makes the element (p, q) of a symmetric matrix 0, and the same of `vectors`,
// whose rows are to become eigenvectors.
void rotate_to_zero(Matrix<double>& a, Matrix<double>& vectors, std::size_t p, std::size_t q) {
  if (a(p, q) == 0.0) return;
  const double ratio = (a(q, q) - a(p, p)) / (2.0 * a(p, q));
  const double tangent =
      (ratio >= 0.0 ? 1.0 : -1.0) / (std::fabs(ratio) + std::sqrt(1.0 + ratio * ratio));
  const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
  const double sine = tangent * cosine;
  const auto turn = [&](double& first, double& second) {
    const double before = first;
    first = cosine * before - sine * second;
    second = sine * before + cosine * second;
  };
  for (std::size_t k = 0; k < a.rows(); ++k) turn(a(k, p), a(k, q));
  for (std::size_t k = 0; k < a.rows(); ++k) turn(a(p, k), a(q, k));
  for (std::size_t k = 0; k < a.rows(); ++k) turn(vectors(p, k), vectors(q, k));
  a(p, q) = 0.0;
  a(q, p) = 0.0;
}

bool is_diagonal(const Matrix<double>& a) {
  double greatest = 0.0;
  double beside = 0.0;
  for (std::size_t i = 0; i < a.rows(); ++i) {
    for (std::size_t j = 0; j < a.rows(); ++j) {
      double& of = i == j ? greatest : beside;
      of = std::max(of, std::fabs(a(i, j)));
    }
  }
  constexpr double kRounding = 0x1p-56;
  return beside <= kRounding * greatest;
}

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

void add_multiple(std::span<double> to, double factor, std::span<const double> what) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * what[i];
}

// `out` = the dot of the matrix with rows first .. first + kKrylovBlock - 1 of `vectors`.
void multiply_block_of_vectors(const Matrix<double>& matrix, const Matrix<double>& vectors,
                               std::size_t first, Matrix<double>& out) {
  const std::size_t rows = matrix.rows();
  std::vector<double> lanes(rows * kKrylovBlock);
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t k = 0; k < kKrylovBlock; ++k)
      lanes[j * kKrylovBlock + k] = vectors(first + k, j);
  }
  for (std::size_t i = 0; i < rows; ++i) {
    double sums[kKrylovBlock] = {};
    const double* row = matrix.row(i).data();
    for (std::size_t j = 0; j < rows; ++j) {
      for (std::size_t k = 0; k < kKrylovBlock; ++k)
        sums[k] += row[j] * lanes[j * kKrylovBlock + k];
    }
    for (std::size_t k = 0; k < kKrylovBlock; ++k) out(first + k, i) = sums[k];
  }
}

// Makes row `number` of length 1 and orthogonal to the rows before it, or 0 if it depends on them;
// twice, because the first time leaves rounding errors of what it subtracts.
void make_orthonormal(Matrix<double>& basis, std::size_t number) {
  constexpr double kDependent = 1e-10;
  const auto row = basis.row(number);
  const double before = std::sqrt(dot(row, row));
  for (int time = 0; time < 2; ++time) {
    for (std::size_t other = 0; other < number; ++other) {
      add_multiple(row, -dot(row, basis.row(other)), basis.row(other));
    }
  }
  const double length = std::sqrt(dot(row, row));
  const double factor = length > kDependent * before ? 1.0 / length : 0.0;
  for (double& value : row) value *= factor;
}

// The space of kKrylovBlocks powers of a matrix times the first vectors, and its products with it.
class KrylovSpace {
 public:
  explicit KrylovSpace(const Matrix<double>& matrix)
      : matrix_(matrix),
        basis_(kKrylovBlock * kKrylovBlocks, matrix.rows()),
        products_(kKrylovBlock * kKrylovBlocks, matrix.rows()) {
    for (std::size_t k = 0; k < kKrylovBlock; ++k) fill(k);
  }

  void build() {
    for (std::size_t block = 0; block < kKrylovBlocks; ++block) {
      const std::size_t first = block * kKrylovBlock;
      for (std::size_t k = first; k < first + kKrylovBlock; ++k) {
        if (block > 0) {
          std::copy_n(products_.row(k - kKrylovBlock).begin(), matrix_.rows(),
                      basis_.row(k).begin());
        }
        make_orthonormal(basis_, k);
      }
      multiply_block_of_vectors(matrix_, basis_, first, products_);
    }
  }

  // The best approximations in the space, with which the next one begins; their greatest residual
  // among the first `count`.
  double restart(std::size_t count, Eigenvectors& found) {
    const Eigenvectors in_space = all_eigenvectors(projection());
    found.vectors = combinations(basis_, in_space);
    const Matrix<double> images = combinations(products_, in_space);
    found.values.assign(in_space.values.begin(), in_space.values.begin() + kKrylovBlock);
    double greatest = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<double> residual(images.row(k).begin(), images.row(k).end());
      add_multiple(residual, -found.values[k], found.vectors.row(k));
      greatest = std::max(greatest, std::sqrt(dot(residual, residual)));
    }
    std::copy_n(found.vectors.values().begin(), kKrylovBlock * matrix_.rows(),
                basis_.values().begin());
    return greatest;
  }

 private:
  void fill(std::size_t vector) {
    for (std::size_t row = 0; row < matrix_.rows(); ++row) {
      const float number = uniform_at(0, Stream::kUser, static_cast<std::uint32_t>(vector),
                                      static_cast<std::uint32_t>(row));
      basis_(vector, row) = double{number} - 0.5;
    }
  }

  Matrix<double> projection() const {
    Matrix<double> h(basis_.rows(), basis_.rows());
    for (std::size_t i = 0; i < h.rows(); ++i) {
      for (std::size_t j = i; j < h.rows(); ++j) {
        h(i, j) = dot(basis_.row(i), products_.row(j));
        h(j, i) = h(i, j);
      }
    }
    return h;
  }

  static Matrix<double> combinations(const Matrix<double>& rows, const Eigenvectors& weights) {
    Matrix<double> sums(kKrylovBlock, rows.columns());
    for (std::size_t k = 0; k < kKrylovBlock; ++k) {
      for (std::size_t i = 0; i < rows.rows(); ++i) {
        add_multiple(sums.row(k), weights.vectors(k, i), rows.row(i));
      }
    }
    return sums;
  }

  const Matrix<double>& matrix_;
  Matrix<double> basis_;
  Matrix<double> products_;
};

Eigenvectors first_of(const Eigenvectors& all, std::size_t count) {
  count = std::min(count, all.values.size());
  Eigenvectors first{{}, Matrix<double>(count, all.vectors.columns())};
  for (std::size_t k = 0; k < count; ++k) {
    first.values.push_back(all.values[k]);
    std::copy_n(all.vectors.row(k).begin(), all.vectors.columns(), first.vectors.row(k).begin());
  }
  return first;
}

}  // namespace

Eigenvectors all_eigenvectors(Matrix<double> symmetric) {
  const std::size_t size = symmetric.rows();
  Matrix<double> vectors(size, size);
  for (std::size_t i = 0; i < size; ++i) vectors(i, i) = 1.0;
  constexpr int kMostSweeps = 60;
  for (int sweep = 0; sweep < kMostSweeps && !is_diagonal(symmetric); ++sweep) {
    for (std::size_t p = 0; p + 1 < size; ++p) {
      for (std::size_t q = p + 1; q < size; ++q) rotate_to_zero(symmetric, vectors, p, q);
    }
  }
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double difference = symmetric(a, a) - symmetric(b, b);
    return difference != 0.0 ? difference > 0.0 : a < b;
  });
  Eigenvectors sorted{{}, Matrix<double>(size, size)};
  for (std::size_t k = 0; k < size; ++k) {
    sorted.values.push_back(symmetric(order[k], order[k]));
    std::copy_n(vectors.row(order[k]).begin(), size, sorted.vectors.row(k).begin());
  }
  return sorted;
}

Eigenvectors leading_eigenvectors(const Matrix<double>& symmetric, std::size_t count) {
  require(symmetric.rows() == symmetric.columns() && count <= kKrylovBlock,
          "eigenvectors need a square matrix, and at most 8 are found");
  if (symmetric.rows() <= kMostRowsToRotate) return first_of(all_eigenvectors(symmetric), count);
  KrylovSpace space(symmetric);
  Eigenvectors found;
  for (std::size_t time = 0; time < kKrylovRestarts; ++time) {
    space.build();
    if (space.restart(count, found) <= kKrylovResidual * found.values.front()) break;
  }
  return first_of(found, count);
}

}  // namespace somato
