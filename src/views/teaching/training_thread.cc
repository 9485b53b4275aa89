#include "views/teaching/training_thread.h"

#include <fmt/format.h>

#include <exception>
#include <utility>

#include "views/session/view_json.h"

namespace somato::live {
namespace {

Json training_json(const std::string& system, const TrainingSnapshot& look) {
  Json winners = Json::array();
  for (std::size_t i = 0; i < look.winners.size(); ++i) {
    winners.push_back({{"sample", i}, {"winner", look.winners[i]}, {"class", look.classes[i]}});
  }
  return {{"system", system},
          {"module", look.module},
          {"step", look.step},
          {"steps", look.steps},
          {"radius", look.radius},
          {"learning_rate", look.learning_rate},
          {"winners", std::move(winners)},
          {"u_matrix", look.u_matrix},
          {"done", look.done}};
}

}  // namespace

void TrainingThread::start(ViewSystem system, std::shared_ptr<const Recording> recording,
                           std::uint64_t seed, Done done) {
  stop();
  stopping_ = false;
  thread_ = std::thread([this, seed, system = std::move(system), recording = std::move(recording),
                         done = std::move(done)] { done(train(system, *recording, seed)); });
}

// An internal error must not end the program.
Result<std::shared_ptr<const SystemModel>> TrainingThread::train(const ViewSystem& system,
                                                                 const Recording& recording,
                                                                 std::uint64_t seed) {
  try {
    const auto observer = [&](const TrainingSnapshot& look) { return show(system.name, look); };
    return train_visibly(system, recording, seed, observer, [&] { return !stopping_; });
  } catch (const std::exception& error) {
    return fail(ErrorKind::kData, fmt::format("the training failed: {}", error.what()));
  }
}

void TrainingThread::request_stop() {
  {
    const std::scoped_lock lock(mutex_);
    stopping_ = true;
  }
  stop_requested_.notify_all();
}

void TrainingThread::stop() {
  request_stop();
  if (thread_.joinable()) thread_.join();
}

void TrainingThread::pause() {
  std::unique_lock lock(mutex_);
  stop_requested_.wait_for(lock, pause_, [this] { return stopping_.load(); });
}

// A snapshot of the map is shown with a pause; the progress of other modules is reported ten times
// per second.
bool TrainingThread::show(const std::string& system, const TrainingSnapshot& look) {
  constexpr auto kSeldom = std::chrono::milliseconds(100);
  const auto now = std::chrono::steady_clock::now();
  if (!look.winners.empty() || now - shown_at_ >= kSeldom) {
    shown_at_ = now;
    hub_.publish(EventKind::kTraining, json_text(training_json(system, look)));
    if (!look.winners.empty()) pause();
  }
  return !stopping_;
}

}  // namespace somato::live
