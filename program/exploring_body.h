#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "command_line.h"
#include "somato/bodies/explorer.h"
#include "somato/bodies/object_table.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato::program {

/// A simulated body that explores in a session, with the objects or materials that it explores.
struct SimulatedSession {
  ExploringBody body = ExploringBody::kLucs2;
  ObjectTable things;
  std::unique_ptr<Explorer> explorer;
};

/// The body named by --body, which explores what --objects names. Errors: kUsage for an unknown
/// body, and for a choice that consists of several bodies; those of the objects.
Result<SimulatedSession> simulated_session(const Arguments& arguments, std::uint64_t seed);

/// The number of a thing. Errors: kUsage with the nearest name.
Result<std::size_t> find_thing(const Explorer& explorer, const std::string& name);

/// The objects of --objects in addition to the built-in ones, or none.
Result<ObjectTable> read_objects(const Arguments& arguments);

}  // namespace somato::program
