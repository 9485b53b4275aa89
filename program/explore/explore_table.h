#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "flags/command_line.h"
#include "somato/bodies/object_table.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/value.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato::program {

/// The body named by --body. Errors: kUsage with the nearest name.
Result<ExploringBody> read_body(const Arguments& arguments);

/// The table `[explore]` of a system's file: the recordings that are explored if none are given.
struct ExploreParameters {
  ExploringBody body = ExploringBody::kLucs2;
  std::string objects;
  std::size_t explorations = 5;
  bool new_objects = false;

  static const Declarations<ExploreParameters>& declarations();
};

/// The same with its subtables, such as [explore.simulation].
struct ExploreTable {
  ExploreParameters explore;
  ExploringParameters exploring;
  std::optional<ObjectTable> things = {};  ///< Those of [explore.object] and [explore.material].
  std::string things_text = {};            ///< These tables as TOML; empty without them.
};

/// Errors (kUsage) with their location: unknown keys, values out of range, no body, both `objects`
/// and tables of objects or materials; errors of object_table_of().
Result<ExploreTable> read_explore_table(const Table& table);

/// The descriptions of its keys, by names such as "explore.explorations" and
/// "explore.simulation.placement_noise".
std::map<std::string, ParameterInfo> explore_parameters();

/// The defaults of these keys as text.
std::map<std::string, std::string> explore_defaults();

/// The settings as text; equal texts give equal explorations.
std::string to_text(const ExploreTable& table);

}  // namespace somato::program
