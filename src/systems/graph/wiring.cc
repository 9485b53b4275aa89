#include "systems/graph/wiring.h"

#include <algorithm>

#include "base/core/contains.h"

namespace somato {
namespace {

using Inputs = std::vector<std::vector<std::size_t>>;

// Walks from listener to speaker among `left`, each of which listens to another of them, until a
// module comes twice.
std::vector<std::size_t> find_loop(const std::vector<std::size_t>& left, const Inputs& inputs) {
  std::vector<std::size_t> way{left.front()};
  for (;;) {
    const std::vector<std::size_t>& predecessors = inputs[way.back()];
    const std::size_t next =
        *std::find_if(predecessors.begin(), predecessors.end(),
                      [&](std::size_t module) { return contains(left, module); });
    const auto before = std::find(way.begin(), way.end(), next);
    if (before == way.end()) {
      way.push_back(next);
      continue;
    }
    std::vector<std::size_t> loop(before, way.end());
    std::reverse(loop.begin(), loop.end());
    return loop;
  }
}

}  // namespace

Wiring::Wiring(const Inputs& inputs, const std::vector<bool>& delays)
    : reaches_(inputs.size(), inputs.size()) {
  find_reaches(inputs);
  find_groups(inputs);
  for (std::vector<std::size_t>& group : groups_) order_group(group, inputs, delays);
}

// Warshall's closure.
void Wiring::find_reaches(const Inputs& inputs) {
  for (std::size_t to = 0; to < inputs.size(); ++to) {
    for (const std::size_t from : inputs[to]) reaches_(from, to) = 1;
  }
  for (std::size_t by = 0; by < inputs.size(); ++by) {
    for (std::size_t from = 0; from < inputs.size(); ++from) {
      if (reaches_(from, by) == 0) continue;
      for (std::size_t to = 0; to < inputs.size(); ++to) reaches_(from, to) |= reaches_(by, to);
    }
  }
}

void Wiring::find_groups(const Inputs& inputs) {
  std::vector<bool> done(inputs.size(), false);
  const auto same_group = [&](std::size_t a, std::size_t b) {
    return a == b || (reaches(a, b) && reaches(b, a));
  };
  const auto is_ready = [&](std::size_t module) {
    for (std::size_t from = 0; from < inputs.size(); ++from) {
      if (reaches(from, module) && !done[from] && !same_group(from, module)) return false;
    }
    return true;
  };
  for (std::size_t found = 0; found < inputs.size();) {
    for (std::size_t module = 0; module < inputs.size(); ++module) {
      if (done[module] || !is_ready(module)) continue;
      std::vector<std::size_t> group;
      for (std::size_t other = 0; other < inputs.size(); ++other) {
        if (same_group(module, other)) group.push_back(other);
      }
      for (const std::size_t member : group) done[member] = true;
      found += group.size();
      groups_.push_back(std::move(group));
    }
  }
}

void Wiring::order_group(std::vector<std::size_t>& group, const Inputs& inputs,
                         const std::vector<bool>& delays) {
  if (!is_loop(group)) return;
  std::vector<std::size_t> ordered;
  std::vector<std::size_t> left = group;
  const auto is_ready = [&](std::size_t module) {
    return delays[module] || std::none_of(inputs[module].begin(), inputs[module].end(),
                                          [&](std::size_t input) { return contains(left, input); });
  };
  while (!left.empty()) {
    const auto next = std::find_if(left.begin(), left.end(), is_ready);
    if (next == left.end()) {
      if (endless_loop_.empty()) endless_loop_ = find_loop(left, inputs);
      return;
    }
    ordered.push_back(*next);
    left.erase(next);
  }
  group = std::move(ordered);
}

}  // namespace somato
