// Uses the installed simulated bodies as a user would; exits with 0 when the answers are right.

#include <cstdio>

#include "somato/simulation/simulated_explorer.h"

int main() {
  const auto engine = somato::physics_engine();
  std::puts(engine.c_str());
  return engine.starts_with("MuJoCo ") ? 0 : 1;
}
