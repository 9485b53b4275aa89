#pragma once

#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/value.h"

namespace somato {

/// A change of a system's file: tables and keys as they stand there, with other values.
struct Variation {
  std::string name;
  std::string where;                 ///< `file:line` of its table.
  std::vector<std::string> systems;  ///< Those it is for; empty: all that are asked.
  Table changes;
};

/// The tables `[variation.NAME]` of a file, in their order. A key `systems` lists those that a
/// variation is for; everything else is a change. Errors (kUsage) with their place.
Result<std::vector<Variation>> read_variations(const Table& file);

/// The file with the changes put in: a key takes the place of the one there or is added; a table is
/// changed key by key; a list of tables, such as `[[phase]]`, takes the place of the whole list.
/// Errors (kUsage, at the line of the change): a module that is not there, with the nearest name; a
/// value in the place of a table or the other way round.
Result<Table> with_changes(Table file, const Table& changes);

}  // namespace somato
