#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "somato/core/result.h"
#include "somato/studies/results.h"
#include "views/report/report.h"

namespace somato::program {

/// The path of the trained system of the results at a path.
std::filesystem::path model_path(const std::filesystem::path& results, const ModelFile& model);

/// The trained system of the results at a path: at its model_path(), or else at `named`. Errors:
/// kSystem if there is no file, kData if its bytes differ.
Result<ReportModel> load_model(const std::filesystem::path& results, const ModelFile& model,
                               const std::optional<std::string>& named);

}  // namespace somato::program
