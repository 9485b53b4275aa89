#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "command_line.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/value.h"
#include "somato/simulation/explorer.h"

namespace somato::program {

/// The body that --body names. Errors: kUsage with the nearest name.
Result<ExploringBody> read_body(const Arguments& arguments);

/// What the table `[explore]` of a system's file says: which recordings are made where none are
/// given.
struct ExploreParameters {
  ExploringBody body = ExploringBody::kLucs2;
  std::string objects;
  std::size_t explorations = 5;
  bool new_objects = false;

  static const Declarations<ExploreParameters>& declarations();
};

/// The same with the tables within it, such as [explore.simulation].
struct ExploreTable {
  ExploreParameters explore;
  ExploringParameters exploring;
};

/// Errors (kUsage) with their place: unknown keys, values out of range, no body.
Result<ExploreTable> read_explore_table(const Table& table);

/// What is said about each of its keys, by names such as "explore.explorations" and
/// "explore.simulation.placement_noise".
std::map<std::string, ParameterInfo> explore_parameters();

/// All of it as text; equal texts explore alike.
std::string to_text(const ExploreTable& table);

}  // namespace somato::program
