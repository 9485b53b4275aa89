#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace somato {

/// The things that a simulated body explored.
enum class SimulatedThings {
  kBuiltIn,  ///< Objects and materials of the built-in tables only.
  kGiven,    ///< Those of another table, which may have the same names.
};

/// The source of explorations by a simulated body, such as "lucs2, simulated (MuJoCo 3.17.0), seed
/// 1"; other things than built-in ones are stated at its end.
std::string simulated_source(std::string_view body, std::string_view engine, std::uint64_t seed,
                             SimulatedThings things);

/// The source of an exploration after sense() with this seed, such as "lucs2, simulated (MuJoCo
/// 3.17.0), seed 1, sensors played, seed 2"; other things than built-in ones are still stated at
/// its end. The seed replaces that of sensors that were played before.
std::string played_source(std::string_view source, std::uint64_t seed);

/// The source of explorations by a device, such as "device left_hand".
std::string device_source(std::string_view name);

/// Whether a source states that a simulated body explored built-in things. Only their properties
/// are known by name: an object of another recording may have the same name.
bool is_of_built_in_things(std::string_view source);

/// Whether a source states a body of this project, simulated or a device. Only its recordings are
/// shown on the models of the hands and probes: other sensors may have the same channels.
bool is_of_body(std::string_view source);

}  // namespace somato
