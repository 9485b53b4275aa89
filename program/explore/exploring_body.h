#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "explore/device.h"
#include "flags/command_line.h"
#include "somato/bodies/explorer.h"
#include "somato/bodies/object_table.h"

namespace somato::program {

/// A body that explores in a session, simulated or real, and its objects.
struct BodySession {
  std::string name;
  std::string body;  ///< The simulated body, or the one that a device stands for; may be empty.
  std::vector<Object> objects;
  std::unique_ptr<Explorer> explorer;
  std::vector<std::string> channels = {};  ///< Those of topics; empty for other bodies.
};

/// The body named by --body, or the device of --device, which explores what --objects names, or the
/// topics of --topics; `permitted` concerns a device.
/// Errors: kUsage for an unknown body, and for a choice that consists of several bodies; those of
/// the objects and of device_explorer().
Result<BodySession> body_session(const Arguments& arguments, std::uint64_t seed,
                                 PermittedBy permitted);

/// The simulated body of --body once more, for explorations beside those of the session. Errors:
/// those of body_session().
Result<std::unique_ptr<SimulatedExplorer>> chosen_simulation(const Arguments& arguments,
                                                             std::uint64_t seed);

/// The number of a thing. Errors: kUsage with the nearest name.
Result<std::size_t> find_thing(const Explorer& explorer, const std::string& name);

/// The objects of --objects in addition to the built-in ones, or none.
Result<ObjectTable> read_objects(const Arguments& arguments);

}  // namespace somato::program
