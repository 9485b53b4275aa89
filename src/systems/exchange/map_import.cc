#include "systems/exchange/map_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/archives/archive.h"
#include "base/archives/zip_reader.h"
#include "base/arrays/npz_array.h"
#include "base/files/whole_file.h"
#include "somato/core/parameter.h"
#include "somato/files/npy.h"
#include "systems/exchange/map_array.h"
#include "systems/exchange/map_npz_reader.h"

namespace somato {
namespace {

constexpr std::array<std::string_view, 9> kGiven{"rows",     "columns",          "lattice",
                                                 "topology", "similarity",       "normalize_input",
                                                 "softmax",  "softmax_exponent", "activity_norm"};

// A file that describes its map completely leaves nothing to give.
Result<void> refuse_options(const MapImportOptions& options, const std::string& what) {
  if (options.given.entries.empty() && options.features.empty() && options.variable.empty()) {
    return {};
  }
  const std::string name = !options.given.entries.empty() ? options.given.entries.front().name
                           : !options.features.empty()    ? "features"
                                                          : "variable";
  const std::string where =
      !options.given.entries.empty() ? options.given.entries.front().where : name;
  return fail(without_effect(name, what, where));
}

Result<ImportedMap> complete(Result<SomModel> model, const MapImportOptions& options,
                             const std::string& what) {
  if (!model) return fail(std::move(model.error()));
  SOMATO_TRY_VOID(refuse_options(options, what));
  return ImportedMap{std::move(*model)};
}

Result<ImportedMap> of_array(const std::string& bytes, const std::string& path,
                             const MapImportOptions& options) {
  SOMATO_TRY(const auto parameters, read_parameters<SomParameters>(options.given));
  SOMATO_TRY(auto array, map_array_in_npy(bytes, path));
  return map_of_weights(parameters, array, options.features, path).map([](SomModel&& model) {
    return ImportedMap{std::move(model)};
  });
}

// A codebook may have no names.
Result<void> name_features(const std::vector<std::string>& features, const std::string& path,
                           SomModel& model) {
  if (features.empty()) return {};
  if (features.size() != model.som.input_size()) {
    return fail(
        ErrorKind::kUsage,
        fmt::format("there are {} names for {} features", features.size(), model.som.input_size()),
        path, "give one name for each feature, or none");
  }
  model.features = features;
  return {};
}

Result<ImportedMap> of_cod(const std::string& bytes, const std::string& path,
                           const MapImportOptions& options) {
  MapImportOptions contained = options;
  std::erase_if(contained.given.entries, [](const Table::Entry& entry) {
    return entry.name != "rows" && entry.name != "columns" && entry.name != "lattice";
  });
  SOMATO_TRY(const auto parameters, read_parameters<SomParameters>(options.given));
  contained.features.clear();
  SOMATO_TRY_VOID(refuse_options(contained, "a codebook contains it"));
  SOMATO_TRY(auto map, map_in_cod(bytes, path, parameters));
  if (!map.model.features.empty()) {
    contained.features = options.features;
    SOMATO_TRY_VOID(refuse_options(contained, "a codebook contains it"));
  }
  SOMATO_TRY_VOID(name_features(options.features, path, map.model));
  return map;
}

}  // namespace

std::vector<ParameterInfo> MapImportOptions::parameters() {
  std::vector<ParameterInfo> chosen;
  for (ParameterInfo& info : SomParameters::declarations().infos()) {
    if (std::find(kGiven.begin(), kGiven.end(), info.name) != kGiven.end()) {
      chosen.push_back(std::move(info));
    }
  }
  return chosen;
}

Result<ImportedMap> import_map(const std::string& path, const MapImportOptions& options) {
  SOMATO_TRY(const std::string bytes, read_whole(path));
  if (is_archive(bytes)) {
    return complete(decode_som_model(bytes, path), options, "a model file contains the whole map");
  }
  if (is_map_npz(bytes)) {
    return complete(map_in_npz(bytes, path), options, "the file contains the whole map");
  }
  if (is_zip(bytes)) {
    SOMATO_TRY(const std::string npy, npy_in_npz(bytes, path, options.variable));
    return of_array(npy, path, options);
  }
  if (!options.variable.empty()) {
    return fail(without_effect("variable", "the file is not an NPZ archive", "variable"));
  }
  if (is_npy(bytes)) return of_array(bytes, path, options);
  if (is_cod(bytes)) return of_cod(bytes, path, options);
  return fail(ErrorKind::kData, "the file contains no map that is known", path,
              "use a model file, an NPZ archive that was exported, weights of rows x columns x "
              "features in an NPY file, or a codebook of SOM_PAK or SOM Toolbox (.cod)");
}

}  // namespace somato
