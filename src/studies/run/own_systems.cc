#include "somato/studies/own_systems.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "base/files/embedded.h"
#include "base/files/toml_file.h"

namespace somato {
namespace {

// In the order of P06 and P11.
constexpr std::array<std::string_view, 9> kOrder = {"single_tensor_product",
                                                    "tensor_chain",
                                                    "t_mpsom_multiplied",
                                                    "t_mpsom_added",
                                                    "shape_and_size",
                                                    "texture",
                                                    "hardness",
                                                    "combined",
                                                    "bimodal"};

constexpr std::array<std::string_view, 5> kFolders = {
    "systems", "systems/recorded", "systems/questions", "systems/announced", "studies"};

std::string name_of(const detail::EmbeddedFile& file) {
  return std::filesystem::path(file.path).stem().string();
}

bool is_in(const detail::EmbeddedFile& file, std::string_view folder) {
  return std::filesystem::path(file.path).parent_path() == folder;
}

bool is_own(const detail::EmbeddedFile& file) {
  return std::any_of(kFolders.begin(), kFolders.end(),
                     [&](std::string_view folder) { return is_in(file, folder); });
}

Result<std::vector<NamedFile>> files_in(std::string_view folder) {
  std::vector<NamedFile> files;
  for (const detail::EmbeddedFile& file : detail::embedded_files()) {
    if (!is_in(file, folder)) continue;
    SOMATO_TRY(auto content, parse_toml(file.text, file.path));
    files.push_back({name_of(file), std::move(content), std::string(file.text)});
  }
  return files;
}

std::size_t place_of(const NamedFile& file) {
  const auto found = std::find(kOrder.begin(), kOrder.end(), file.name);
  return static_cast<std::size_t>(found - kOrder.begin());
}

}  // namespace

Result<OwnSystems> own_systems() {
  OwnSystems own;
  std::array<std::vector<NamedFile>*, kFolders.size()> parts = {
      &own.systems, &own.recorded, &own.questions, &own.announced, &own.studies};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    SOMATO_TRY(auto files, files_in(kFolders[i]));
    *parts[i] = std::move(files);
  }
  std::vector<NamedFile> announced = std::move(own.announced);
  own.announced.clear();
  for (NamedFile& file : announced) {
    auto& files = file.content.find("question") ? own.announced_questions : own.announced;
    files.push_back(std::move(file));
  }
  std::sort(own.systems.begin(), own.systems.end(), [](const NamedFile& a, const NamedFile& b) {
    return std::pair(place_of(a), a.name) < std::pair(place_of(b), b.name);
  });
  return own;
}

std::vector<NamedFile> questionable_systems(const OwnSystems& own) {
  std::vector<NamedFile> systems = own.systems;
  systems.insert(systems.end(), own.announced.begin(), own.announced.end());
  return systems;
}

std::optional<OwnFile> find_own_file(const std::string& name) {
  for (const detail::EmbeddedFile& file : detail::embedded_files()) {
    if (is_own(file) && (file.path == name || name_of(file) == name)) {
      return OwnFile{file.path, file.text};
    }
  }
  return std::nullopt;
}

std::vector<std::string> own_file_names() {
  std::vector<std::string> names;
  for (const detail::EmbeddedFile& file : detail::embedded_files()) {
    if (is_own(file)) names.push_back(name_of(file));
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace somato
