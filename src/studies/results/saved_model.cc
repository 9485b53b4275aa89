#include "studies/results/saved_model.h"

#include <fmt/format.h>

#include <utility>

#include "base/archives/checksum.h"
#include "base/files/whole_file.h"

namespace somato {

Result<std::string> hash_of_file(const std::string& path) {
  return read_whole(path).map(
      [](const std::string& bytes) { return fmt::format("fnv1a64:{:016x}", fnv1a64(bytes)); });
}

Result<void> save_model(const std::filesystem::path& folder, const std::string& path,
                        const SystemModel& model, PartResults& results) {
  const std::string file = (folder / path).string();
  auto saved = save_system(file, model);
  if (!saved) return saved;
  SOMATO_TRY(auto hash, hash_of_file(file));
  results.model = ModelFile{path, std::move(hash), results.pairs.front().seed};
  return {};
}

}  // namespace somato
