#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"
#include "somato/studies/reproduction.h"

namespace somato {

/// The built-in files: those of `systems/` and `studies/`.
struct OwnSystems {
  std::vector<NamedFile> systems;    ///< The nine systems of the papers, for simulated bodies.
  std::vector<NamedFile> recorded;   ///< The same, if applicable, for public data sets.
  std::vector<NamedFile> questions;  ///< Questions about the nine systems.
  std::vector<NamedFile> announced;  ///< Systems beyond the papers, which their authors announced.
  std::vector<NamedFile> announced_questions;  ///< Comparisons of these with the nine.
  std::vector<NamedFile> studies;  ///< Studies of public data sets, with separate systems.
};

/// The systems that a question can be about: the nine, then the announced ones.
std::vector<NamedFile> questionable_systems(const OwnSystems& own);

/// Reads them; their names are those of the files. The nine systems are in the order of the papers.
Result<OwnSystems> own_systems();

/// One of these files, unchanged.
struct OwnFile {
  std::string_view path;  ///< Such as "systems/texture.toml".
  std::string_view text;
};

/// The file with that path or file name without ".toml"; empty if there is none.
std::optional<OwnFile> find_own_file(const std::string& name);

/// The names of all of them, sorted.
std::vector<std::string> own_file_names();

}  // namespace somato
