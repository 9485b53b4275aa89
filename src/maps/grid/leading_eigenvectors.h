#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/matrix.h"

namespace somato {

/// Eigenvalues in descending order, each with a vector of length 1: a row of `vectors`.
struct Eigenvectors {
  std::vector<double> values;
  Matrix<double> vectors;
};

/// All eigenvectors of a symmetric matrix, by Jacobi's rotations (Golub and Van Loan, Matrix
/// Computations, section 8.5).
Eigenvectors all_eigenvectors(Matrix<double> symmetric);

/// The eigenvectors of the `count` largest eigenvalues of a symmetric matrix without negative ones,
/// such as a covariance; `count` is at most 8, and fewer are found if the matrix has fewer rows.
/// Matrices of up to 64 rows take rotations; larger ones a block Krylov method with restarts (Saad,
/// Numerical Methods for Large Eigenvalue Problems, chapter 6), until the residuals are 1e-10 of
/// the largest eigenvalue. The bits are the same on every machine.
Eigenvectors leading_eigenvectors(const Matrix<double>& symmetric, std::size_t count);

}  // namespace somato
