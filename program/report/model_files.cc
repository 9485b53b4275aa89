#include "report/model_files.h"

#include <utility>

#include "somato/graph/system_model.h"
#include "studies/results/saved_model.h"

namespace somato::program {
namespace {

Result<ReportModel> load_same(const std::string& path, const std::string& hash) {
  SOMATO_TRY(const auto found, hash_of_file(path));
  if (found != hash) {
    return fail(ErrorKind::kData, "the trained system is not the one named in the results", path,
                "use the original file, or run the study again");
  }
  return load_system(path).map(
      [&](SystemModel model) { return ReportModel{path, std::move(model)}; });
}

}  // namespace

std::filesystem::path model_path(const std::filesystem::path& results, const ModelFile& model) {
  return results.parent_path() / model.path;
}

Result<ReportModel> load_model(const std::filesystem::path& results, const ModelFile& model,
                               const std::optional<std::string>& named) {
  auto beside = load_same(model_path(results, model).string(), model.hash);
  if (beside || !named) return beside;
  return load_same(*named, model.hash);
}

}  // namespace somato::program
