#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"
#include "somato/studies/reproduction_plan.h"

namespace somato {

/// The files that travel with the library: those of `systems/` and `studies/`.
struct OwnSystems {
  std::vector<NamedFile> systems;    ///< The papers' nine, for the bodies that are simulated.
  std::vector<NamedFile> recorded;   ///< The same, where they apply, for data sets of others.
  std::vector<NamedFile> questions;  ///< Side questions about the nine.
  std::vector<NamedFile> studies;    ///< Of data sets of others, each with a system of its own.
};

/// Reads them; their names are those of the files. The nine stand in the order of the papers.
Result<OwnSystems> own_systems();

/// One of these files as it stands in the source tree.
struct OwnFile {
  std::string_view path;  ///< Such as "systems/texture.toml".
  std::string_view text;
};

/// The one that is named, by its path or by its file name without ".toml"; nothing for others.
std::optional<OwnFile> find_own_file(const std::string& name);

/// The names of all of them, sorted.
std::vector<std::string> own_file_names();

}  // namespace somato
