#include "somato/studies/own_systems.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "files/embedded.h"
#include "somato/files/toml_file.h"

namespace somato {
namespace {

// As P06 and P11 present them.
constexpr std::array<std::string_view, 9> kOrder = {"single_tensor_product",
                                                    "tensor_chain",
                                                    "t_mpsom_multiplied",
                                                    "t_mpsom_added",
                                                    "shape_and_size",
                                                    "texture",
                                                    "hardness",
                                                    "combined",
                                                    "bimodal"};

Result<std::vector<NamedFile>> files_in(std::string_view folder) {
  std::vector<NamedFile> files;
  for (const detail::EmbeddedFile& file : detail::embedded_files()) {
    const std::filesystem::path path(file.path);
    if (path.parent_path() != folder || path.extension() != ".toml") continue;
    auto content = parse_toml(file.text, file.path);
    if (!content) return fail(std::move(content.error()));
    files.push_back({path.stem().string(), std::move(*content)});
  }
  return files;
}

std::size_t place_of(const NamedFile& file) {
  const auto found = std::find(kOrder.begin(), kOrder.end(), file.name);
  return static_cast<std::size_t>(found - kOrder.begin());
}

}  // namespace

Result<OwnSystems> own_systems() {
  auto systems = files_in("systems");
  if (!systems) return fail(std::move(systems.error()));
  auto recorded = files_in("systems/recorded");
  if (!recorded) return fail(std::move(recorded.error()));
  auto questions = files_in("systems/questions");
  if (!questions) return fail(std::move(questions.error()));
  std::sort(systems->begin(), systems->end(), [](const NamedFile& a, const NamedFile& b) {
    return std::pair(place_of(a), a.name) < std::pair(place_of(b), b.name);
  });
  return OwnSystems{std::move(*systems), std::move(*recorded), std::move(*questions)};
}

}  // namespace somato
