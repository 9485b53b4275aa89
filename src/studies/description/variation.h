#pragma once

#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/value.h"

namespace somato {

/// A change of a system's file: tables and keys with other values.
struct Variation {
  std::string name;
  std::string where;                 ///< `file:line` of its table.
  std::vector<std::string> systems;  ///< The systems it applies to; empty: all.
  Table changes;
};

/// The tables `[variation.NAME]` of a file, in order. A key `systems` lists the systems that a
/// variation applies to; everything else is a change. Errors (kUsage) with their location.
Result<std::vector<Variation>> read_variations(const Table& file);

/// Applies the changes to the file: a key replaces the existing one or is added; a table is changed
/// key by key; a list of tables, such as `[[phase]]`, replaces the complete list. Errors (kUsage,
/// at the line of the change): an unknown module, with the nearest name; a value instead of a table
/// or vice versa.
Result<Table> with_changes(Table file, const Table& changes);

}  // namespace somato
