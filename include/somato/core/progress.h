#pragma once

#include <cstdint>
#include <functional>

namespace somato {

/// Reports progress and requests permission to continue: called regularly with the completed and
/// the total number of steps; if it returns false, the work ends with an Error of kind
/// kInterrupted. May be empty. The library itself never prints.
using Progress = std::function<bool(std::uint64_t done, std::uint64_t total)>;

}  // namespace somato
