#pragma once

#include <algorithm>
#include <vector>

namespace somato {

template <typename T>
bool contains(const std::vector<T>& all, const T& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

}  // namespace somato
