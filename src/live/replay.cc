#include "live/replay.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace somato::live {
namespace {

constexpr double kLongestPause = 1.0;  // s, between two moments: nothing was recorded there
constexpr auto kSlice = std::chrono::milliseconds(20);          // between two looks at the queue
constexpr auto kMostFollowed = std::chrono::milliseconds(250);  // that a command waits for

// True as long as this lives.
class Raised {
 public:
  explicit Raised(bool& flag) : flag_(flag) { flag_ = true; }
  Raised(const Raised&) = delete;
  Raised(Raised&&) = delete;
  Raised& operator=(const Raised&) = delete;
  Raised& operator=(Raised&&) = delete;
  ~Raised() { flag_ = false; }

 private:
  bool& flag_;
};

}  // namespace

void Replay::begin(std::size_t index, const Exploration& exploration,
                   std::shared_ptr<ScenePlayer> scene) {
  index_ = index;
  exploration_ = &exploration;
  scene_ = std::move(scene);
  timeline_ = Timeline(exploration);
  next_ = 0;
  followed_ = 0;
  wanted_.reset();
  showing_.narrator.start();
  showing_.scene(scene_ ? &scene_->scene() : nullptr);
}

void Replay::end() {
  index_.reset();
  exploration_ = nullptr;
  timeline_ = {};
  next_ = 0;
  wanted_.reset();
}

// Whoever follows already goes there instead of where it was going.
void Replay::show(std::size_t moment) {
  if (timeline_.moments() == 0) return;
  wanted_ = moment;
  next_ = moment + 1;
  if (!following_) catch_up();
}

void Replay::show_again() {
  if (exploration_ != nullptr) show(next_ == 0 ? 0 : next_ - 1);
}

void Replay::follow_anew() {
  followed_ = 0;
  show_again();
}

// Tasks are done in between, which may want another moment or exploration.
void Replay::catch_up() {
  const auto until = Pace::Clock::now() + kMostFollowed;
  const Raised following(following_);
  while (wanted_ && Pace::Clock::now() < until) {
    if (follow_to(*wanted_)) {
      tell(*std::exchange(wanted_, std::nullopt));
    } else if (queue_.wait(Pace::Clock::now()) == TaskQueue::Woken::kClosed) {
      give_up();
    }
  }
}

// Returns whether it is there.
bool Replay::follow_to(std::size_t moment) {
  if (moment + 1 < followed_) {
    showing_.narrator.start();
    followed_ = 0;
  }
  const auto until = Pace::Clock::now() + kSlice;
  std::vector<std::size_t> come(exploration_->channels.size());
  do {
    if (followed_ > moment) return true;
    for (std::size_t i = 0; i < come.size(); ++i) come[i] = timeline_.frames(i, followed_);
    showing_.narrator.follow(*exploration_, come);
    ++followed_;
  } while (Pace::Clock::now() < until);
  return followed_ > moment;
}

void Replay::tell(std::size_t moment) {
  ShownMoment shown{*index_,
                    moment,
                    timeline_.moments(),
                    timeline_.time(moment),
                    moment + 1 == timeline_.moments(),
                    {},
                    {}};
  std::size_t frame = 0;
  for (std::size_t i = 0; i < exploration_->channels.size(); ++i) {
    const Channel& channel = exploration_->channels[i];
    const std::size_t come = timeline_.frames(i, moment);
    frame = std::max(frame, come);
    shown.channels.emplace_back(channel.name, shown_values(channel, timeline_.rate(i), come));
  }
  if (scene_) shown.poses = scene_->poses(*exploration_, frame - 1);
  showing_.frame(shown, [&] { return cut_at(*exploration_, timeline_, moment); });
}

double Replay::pause() const {
  const double before = next_ == 0 ? 0.0 : timeline_.time(next_ - 1);
  return std::clamp(timeline_.time(next_) - before, 0.0, kLongestPause);
}

}  // namespace somato::live
