#pragma once

#include <cstdint>
#include <functional>

namespace somato {

/// How long work tells how far it is, and is asked to stop: called now and then with the steps done
/// and the steps in all; when it returns false the work ends with an Error of kind kInterrupted.
/// May be empty. The library itself never prints.
using Progress = std::function<bool(std::uint64_t done, std::uint64_t total)>;

}  // namespace somato
