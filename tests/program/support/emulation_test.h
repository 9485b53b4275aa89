#pragma once

#include <csignal>
#include <functional>
#include <string>

#include "hardware/buses/bus_kind.h"
#include "program/support/program_test.h"

namespace somato {

/// The names of all kinds of servo buses.
inline Words names_of_buses() {
  Words names;
  for (const auto& choice : Choices<devices::BusKind>::all()) names.push_back(choice.second);
  return names;
}

/// Runs the program together with one of its emulations, whose time passes only while the program
/// waits for it: no result depends on the speed of the machine.
class EmulationTest : public ProgramTest {
 protected:
  /// Runs `work` while 'somato emulate' runs with these flags and has written d.toml, then ends the
  /// emulation by `signal`.
  ProgramRun with_emulation(const Words& flags, const std::function<void()>& work,
                            int signal = SIGINT) const {
    Words words{"emulate", "--clock", "host", "-o", "d.toml"};
    words.insert(words.end(), flags.begin(), flags.end());
    ProgramWorld world;
    world.interrupt_at = "Press Ctrl-C to end";
    world.interrupt_with = signal;
    world.before_interrupt = [&](const std::string& /*said*/) { work(); };
    return run(words, world);
  }
};

}  // namespace somato
