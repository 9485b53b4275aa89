#pragma once

#include <cstdint>
#include <memory>
#include <span>

namespace somato::program {

/// Switches servos off whatever happens to the program: a signal that ends it (a second Ctrl-C, a
/// fault, the end of the session) first writes these bytes to the descriptor of their line. Empty
/// bytes: no servos are on.
void switch_off_at_the_end(int descriptor, std::span<const std::uint8_t> relax_bytes);

/// While it lives, the space bar and the escape key on the terminal have the effect of Ctrl-C. Does
/// nothing if the input is not a terminal.
std::shared_ptr<void> watch_stop_key();

}  // namespace somato::program
