#pragma once

#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"

namespace somato::program {

/// Keys of a table of a file, or of flags.
struct KeyTable {
  std::string title;  ///< Markdown, such as "`[study]`".
  std::vector<ParameterInfo> keys;
  std::string text = {};  ///< Markdown before the table, or nothing.
};

/// A section of the reference: tables of keys that a command reads.
struct KeySection {
  std::string title;
  std::string text;  ///< Markdown.
  std::vector<KeyTable> tables;
};

template <typename Parameters>
KeyTable key_table(std::string title, std::string text = {}) {
  return {std::move(title), Parameters::declarations().infos(), std::move(text)};
}

}  // namespace somato::program
