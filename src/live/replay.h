#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "live/showing.h"
#include "live/task_queue.h"
#include "live/timeline.h"
#include "somato/bodies/scene.h"
#include "somato/recording/recording.h"

namespace somato::live {

/// Shows the moments of an exploration that was recorded, to and fro. Used by one thread.
class Replay {
 public:
  /// `queue` is looked at while the system follows a long way.
  Replay(Showing& showing, TaskQueue& queue) : showing_(showing), queue_(queue) {}

  /// Begins an exploration, the one with that index, at its first moment; it must live until
  /// another begins, or end(). `scene` may be nullptr.
  void begin(std::size_t index, const Exploration& exploration, std::shared_ptr<ScenePlayer> scene);

  /// Shows nothing any more.
  void end();

  /// Shows a moment, or the one that is shown once more. It may be a long way there: what the
  /// system remembers depends on every moment before. Then is_behind() holds afterwards.
  void show(std::size_t moment);
  void show_again();

  /// Goes on with a way that was long, for a while.
  bool is_behind() const { return wanted_.has_value(); }
  void catch_up();

  /// Leaves it at the moment that is shown.
  void give_up() { wanted_.reset(); }

  /// Has the system, another one, follow from the first moment.
  void follow_anew();

  /// The exploration's index and itself; nothing without one.
  std::optional<std::size_t> index() const { return index_; }
  const Exploration* exploration() const { return exploration_; }

  const Timeline& timeline() const { return timeline_; }

  /// The moment to come.
  std::size_t next() const { return next_; }
  bool is_over() const { return next_ >= timeline_.moments(); }

  /// Seconds from the moment that is shown to the next one.
  double pause() const;

 private:
  bool follow_to(std::size_t moment);
  void tell(std::size_t moment);

  Showing& showing_;
  TaskQueue& queue_;
  std::optional<std::size_t> index_;
  const Exploration* exploration_ = nullptr;
  std::shared_ptr<ScenePlayer> scene_;
  Timeline timeline_;
  std::size_t next_ = 0;
  std::size_t followed_ = 0;           // moments
  std::optional<std::size_t> wanted_;  // the moment to be shown once all before is followed
  bool following_ = false;
};

}  // namespace somato::live
