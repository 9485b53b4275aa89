#include "model_files.h"

#include <fmt/format.h>

#include <utility>

#include "files/checksum.h"
#include "files/whole_file.h"
#include "somato/graph/system_model.h"

namespace somato::program {
namespace {

Result<std::string> hash_of_file(const std::string& path) {
  return read_whole(path).map(
      [](const std::string& bytes) { return fmt::format("fnv1a64:{:016x}", fnv1a64(bytes)); });
}

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

Result<void> save_model(const std::filesystem::path& folder, const std::string& path,
                        const StudyOutcome& outcome, PartResults& results) {
  const std::string file = (folder / path).string();
  auto saved = save_system(file, outcome.model.system, outcome.model.answer);
  if (!saved) return saved;
  SOMATO_TRY(auto hash, hash_of_file(file));
  results.model = ModelFile{path, std::move(hash), results.pairs.front().seed};
  return {};
}

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
