#pragma once

#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato {

/// The array of an NPZ archive in `bytes`, from the source `where`, as the bytes of an NPY file: a
/// sparse matrix of scipy.sparse.save_npz (csr, csc or coo), or a member of numpy.savez: the one
/// named `variable`, or the only one if that is empty. Errors: kData for a damaged archive or a
/// sparse matrix of another format; kUsage, with the names, for a member that does not exist or is
/// not named; those of npy_of_sparse(). Source: scipy.sparse.save_npz in SciPy's documentation.
Result<std::string> npy_in_npz(std::string_view bytes, const std::string& where,
                               const std::string& variable);

}  // namespace somato
