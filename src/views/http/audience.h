#pragma once

#include <cstddef>
#include <utility>

namespace somato::live {

/// The event with which something begins to play or to move.
enum class Beginning { kAtOnce, kWithFirstViewer, kByCommand };

/// The viewers of what plays: it may begin with the first one, and rest while there are none.
class Audience {
 public:
  enum class Change { kNone, kBegin, kRest, kContinue };

  /// `may_rest`: nothing plays without viewers.
  Audience(Beginning beginning, bool may_rest)
      : has_begun_(beginning == Beginning::kAtOnce),
        by_command_(beginning == Beginning::kByCommand),
        may_rest_(may_rest) {}

  bool has_begun() const { return has_begun_; }

  /// Whether only begin() lets it begin.
  bool awaits_command() const { return by_command_ && !has_begun_; }

  /// Has what a command began await another one, for example after a fault.
  void await_command() { has_begun_ = has_begun_ && !by_command_; }

  /// Whether it rests because there are no viewers.
  bool is_resting() const { return is_resting_; }

  /// The number of viewers has changed; `plays`: whether something plays now. It is to continue
  /// only if it played before the rest.
  Change set_viewers(std::size_t viewers, bool plays) {
    if (awaits_command()) return Change::kNone;
    if (viewers > 0 && !std::exchange(has_begun_, true)) return Change::kBegin;
    if (viewers > 0) {
      const bool rested = std::exchange(is_resting_, false);
      return rested && std::exchange(played_, false) ? Change::kContinue : Change::kNone;
    }
    if (!may_rest_ || !has_begun_) return Change::kNone;
    played_ = plays;
    is_resting_ = true;
    return Change::kRest;
  }

  /// A command decides what plays.
  void take_command() { is_resting_ = played_ = false; }

  /// It begins by a command; false if it had begun.
  bool begin() { return !std::exchange(has_begun_, true); }

 private:
  bool has_begun_;
  bool by_command_;
  bool may_rest_;
  bool is_resting_ = false;
  bool played_ = false;
};

}  // namespace somato::live
