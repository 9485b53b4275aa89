#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "recordings/explorations/given_names.h"
#include "views/session/view_source.h"
#include "views/teaching/teacher.h"

namespace somato::live {

/// The names that the systems of a view learn. A trained system of the source is replaced when it
/// has learned. Used by one thread.
class Teachers {
 public:
  /// `source` must outlive it.
  explicit Teachers(ViewSource& source) : source_(source) {}

  /// Whether a system is trained and learns names.
  bool can_teach(std::size_t system) const;

  /// Teaches a system that can be taught the name of an exploration of the recording.
  const TaughtName& teach(std::size_t system, std::size_t exploration, const std::string& name);

  /// A label was taken back: the systems that were taught it by this exploration learn the value
  /// that it had been given before, or forget it.
  void take_back(const GivenName& name);

  /// The names that a system was taught.
  const std::vector<TaughtName>& names(std::size_t system) const;
  bool is_taught(std::size_t system, std::size_t exploration) const;

  /// The explorations of the recording before `kept` will no longer be kept.
  void settle_before(std::size_t kept);

  /// A system was trained again: what it had been taught is of no interest.
  void drop(std::size_t system) { teachers_.erase(system); }

  /// All systems return to what they were before they were taught.
  void forget();

 private:
  ViewSource& source_;
  std::map<std::size_t, Teacher> teachers_;  // by the number of the system
};

}  // namespace somato::live
