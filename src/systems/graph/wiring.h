#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/matrix.h"

namespace somato {

/// The connections of modules, and the order in which they can run.
class Wiring {
 public:
  /// `inputs[i]` lists the inputs of module i; `delays[i]` states whether its output does not
  /// depend on its present input.
  Wiring(const std::vector<std::vector<std::size_t>>& inputs, const std::vector<bool>& delays);

  /// Whether there is a way of at least one connection.
  bool reaches(std::size_t from, std::size_t to) const { return reaches_(from, to) != 0; }

  /// The modules in groups: those of a loop together, all others separately; a group follows its
  /// inputs, and within a group, without the delays, so does a module.
  const std::vector<std::vector<std::size_t>>& groups() const { return groups_; }

  /// Whether the modules of the group form a loop.
  bool is_loop(const std::vector<std::size_t>& group) const {
    return reaches(group.front(), group.front());
  }

  /// A loop without a delay, in the order of its connections, or nothing.
  const std::vector<std::size_t>& endless_loop() const { return endless_loop_; }

 private:
  void find_reaches(const std::vector<std::vector<std::size_t>>& inputs);
  void find_groups(const std::vector<std::vector<std::size_t>>& inputs);
  void order_group(std::vector<std::size_t>& group,
                   const std::vector<std::vector<std::size_t>>& inputs,
                   const std::vector<bool>& delays);

  Matrix<char> reaches_;
  std::vector<std::vector<std::size_t>> groups_;
  std::vector<std::size_t> endless_loop_;
};

}  // namespace somato
