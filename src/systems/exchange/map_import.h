#pragma once

#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/value.h"
#include "systems/exchange/cod_file.h"

namespace somato {

/// Content that a file of another program may lack.
struct MapImportOptions {
  /// Parameters of the map by their names; those of MapImportOptions::parameters().
  Table given = {};
  std::vector<std::string> features = {};  ///< Names of the features, or empty.
  std::string variable = {};               ///< The array of an NPZ archive with several.

  /// The parameters of a map that matter once it is trained.
  static std::vector<ParameterInfo> parameters();
};

/// The map in the file at `path`: a model file, an archive of save_map_npz(), a codebook (see
/// map_in_cod()), or weights of (rows, columns, features) or (neurons, features) in an NPY or NPZ
/// file. Errors: those of the formats; kUsage for an option without effect on the file.
Result<ImportedMap> import_map(const std::string& path, const MapImportOptions& options = {});

}  // namespace somato
