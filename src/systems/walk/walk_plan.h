#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "somato/graph/system.h"

namespace somato {

/// The outputs of requested modules that a walk stores.
enum class Outputs {
  kLatest,  ///< That of the current frame, or the value of the exploration.
  kAll,     ///< Those of all frames, for Walk::take().
};

/// The modules that a walk runs, their order and time.
class WalkPlan {
 public:
  /// A module or a loop.
  struct Part {
    std::vector<std::size_t> modules;
    std::optional<std::size_t> outer_input;  ///< One of the modules that it depends on, if any.
    bool advances = false;                   ///< With every frame; otherwise when the walk settles.
    bool takes_frames = false;
    std::size_t group = 0;  ///< Parts of a group advance together.
  };

  /// The state of a module in the plan.
  struct Role {
    bool is_walked = false;
    bool is_kept = false;      ///< All its outputs are requested, or required by another module.
    bool delays_loop = false;  ///< Its input runs after it.
    std::size_t group = 0;
  };

  WalkPlan(const System& system, const std::vector<std::size_t>& wanted, Outputs outputs,
           const std::function<bool(std::size_t)>& is_known);

  /// In the order in which they run.
  const std::vector<Part>& parts() const { return parts_; }

  const Role& operator[](std::size_t module) const { return roles_[module]; }

  /// The number of groups that advance with the frames; they are numbered from 0.
  std::size_t streams() const { return clocks_.size(); }

  bool is_known(std::size_t module) const { return known_[module]; }

  /// Whether settling runs modules on all frames.
  bool is_costly() const;

 private:
  void add(const std::vector<std::size_t>& modules);
  bool advances(const Part& part) const;
  std::size_t stream_of(const Part& part);
  void keep_inputs_of(const Part& part);

  const System& system_;
  std::vector<bool> known_;
  std::vector<Role> roles_;
  std::vector<Part> parts_;
  std::vector<std::string> clocks_;  // of the streams
};

}  // namespace somato
