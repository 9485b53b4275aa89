#pragma once

#include <cstddef>
#include <vector>

namespace somato {

/// The values at `places`, in that order; places are below the number of values.
template <typename T>
std::vector<T> values_at(const std::vector<T>& values, const std::vector<std::size_t>& places) {
  std::vector<T> chosen;
  chosen.reserve(places.size());
  for (const std::size_t place : places) chosen.push_back(values[place]);
  return chosen;
}

}  // namespace somato
