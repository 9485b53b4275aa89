#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "views/replay/replay.h"
#include "views/session/view_source.h"
#include "views/teaching/teachers.h"

namespace somato::live {

/// The system of a view that reads what is played, with the names that it was taught. Used by the
/// thread of the player.
class ChosenSystem {
 public:
  /// Begins with the system of the source, if it has one, which reads from the first use(). Source
  /// and replay must outlive it.
  ChosenSystem(ViewSource& source, Replay& replay);

  /// The system, or nullptr; its number in the source.
  const ViewSystem* system() const;
  std::optional<std::size_t> number() const { return number_; }

  /// Chooses another system. Errors (kUsage): there is none of that name.
  Result<void> choose(const std::string& name);

  /// The replay is read by the system as it is now.
  void use();

  /// The system of that name was trained, without the names that it had been taught.
  void take_trained(const std::string& name, const std::shared_ptr<const SystemModel>& model);

  /// Whether the system learns names: it gives one answer for each exploration.
  bool teaches() const;

  /// The label that the system answers, or nothing if it does not learn names.
  std::optional<std::string> answered_label() const;

  /// Teaches the name of an exploration to a system that learns names.
  const TaughtName& teach(std::size_t exploration, const std::string& name);

  /// See Teachers.
  void take_back(const GivenName& name);

  std::vector<TaughtName> taught_names() const;
  bool is_taught(std::size_t exploration) const;

  /// Whether the system's last answer is that it does not know what was explored.
  bool answers_unknown() const;

  /// See Teachers.
  void settle_before(std::size_t kept) { teachers_.settle_before(kept); }

  /// All systems return to what they were before they were taught.
  void forget();

 private:
  ViewSource& source_;
  Replay& replay_;
  std::optional<std::size_t> number_;
  Teachers teachers_;
};

}  // namespace somato::live
