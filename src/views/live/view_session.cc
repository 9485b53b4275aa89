#include "views/live/view_session.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <thread>
#include <utility>
#include <variant>

#include "views/http/downloads.h"
#include "views/http/event_hub.h"
#include "views/live/inquiries.h"
#include "views/live/player.h"
#include "views/replay/task_queue.h"
#include "views/session/viewed_system.h"
#include "views/teaching/preparation.h"
#include "views/teaching/training_thread.h"

namespace somato {

using live::TaskQueue;

class ViewSession::Impl {
 public:
  Impl(ViewSource source, const ViewSettings& settings)
      : player_(std::move(source), settings, hub_, queue_),
        training_(hub_, std::chrono::duration<double>(settings.training_pause)),
        on_thread_(settings.on_thread) {
    hub_.on_change([this] {
      queue_.post([this] {
        player_.on_viewers(hub_.viewers());
        player_.publish_state();
      });
    });
  }

  // Requests after this point receive the initial state.
  void start() {
    player_.begin();
    prepare();
    thread_ = std::thread([this] {
      if (on_thread_) on_thread_();
      player_.run();
    });
  }

  void stop() {
    hub_.close();
    queue_.close();
    if (thread_.joinable()) thread_.join();
    training_.stop();
    preparation_.stop();
  }

  // Waits until it has been done: the player looks after tasks with every frame.
  Result<void> command(std::string_view json) {
    auto command = live::parse_view_command(json);
    if (!command) return fail(std::move(command.error()));
    return run_task<void>([this, command = std::move(*command)] {
      auto handled = handle(command);
      player_.publish_state();
      return handled;
    });
  }

  bool post(std::function<void()> task) { return queue_.post(std::move(task)); }

  // Long computations run in the calling thread.
  Result<std::string> neuron(const std::string& map, std::size_t neuron) {
    return inquired_system().and_then(
        [&](const live::InquiredSystem& system) { return inquiries_.neuron(system, map, neuron); });
  }
  Result<std::string> taxel(std::size_t element) {
    return inquired_system().and_then(
        [&](const live::InquiredSystem& system) { return inquiries_.taxel(system, element); });
  }

  Result<std::string> state() {
    return run_task<std::string>([this]() -> Result<std::string> { return player_.state_text(); });
  }

  Result<std::string> strips() {
    return run_task<std::optional<live::Strips>>([this] { return player_.strips(); })
        .map([](const auto& strips) { return strips ? live::strips_text(*strips) : "null"; });
  }

  Result<std::string> recording_file() {
    using Shared = std::shared_ptr<const Recording>;
    return run_task<Shared>([this]() -> Result<Shared> {
             if (!player_.source().recording.explorations.empty()) return explored();
             return fail(ErrorKind::kUsage, "there is no exploration to save yet");
           })
        .and_then([](const Shared& recording) { return live::recording_bytes(*recording); });
  }
  Result<std::string> system_file() {
    return inquired_system().and_then(
        [](const live::InquiredSystem& system) { return live::system_bytes(*system.model); });
  }

  live::EventHub& hub() { return hub_; }
  const Recording& recording() const { return player_.source().recording; }
  Losses losses() const { return player_.losses(); }
  std::shared_ptr<const SystemModel> system() const {
    const ViewSystem* system = player_.system();
    return system == nullptr ? nullptr : system->trained;
  }

 private:
  static constexpr auto kPatience = std::chrono::seconds(5);

  // Has the player's thread do something, and waits until it has.
  template <typename T>
  Result<T> run_task(std::function<Result<T>()> task) {
    auto answer = std::make_shared<std::promise<Result<T>>>();
    auto result = answer->get_future();
    auto forgotten = std::make_shared<std::atomic<bool>>(false);
    const bool posted = queue_.post([answer, forgotten, task = std::move(task)] {
      if (!*forgotten) answer->set_value(result_of(task));
    });
    if (!posted || result.wait_for(kPatience) != std::future_status::ready) {
      *forgotten = true;
      return fail(ErrorKind::kUsage, "the view is busy or closing");
    }
    return result.get();
  }

  // An internal error must not end the program.
  template <typename T>
  static Result<T> result_of(const std::function<Result<T>()>& task) {
    try {
      return task();
    } catch (const std::exception& error) {
      return fail(ErrorKind::kData, fmt::format("internal error: {}", error.what()));
    }
  }

  Result<live::InquiredSystem> inquired_system() {
    return run_task<live::InquiredSystem>([this]() -> Result<live::InquiredSystem> {
      const ViewSystem* system = player_.system();
      if (system != nullptr && system->trained) {
        return live::InquiredSystem{system->trained, explored(), player_.source().first};
      }
      return fail(ErrorKind::kUsage, "no trained system is selected");
    });
  }

  Result<void> handle(const live::ViewCommand& command) {
    if (std::holds_alternative<live::TrainCommand>(command)) return train();
    if (std::holds_alternative<live::NameCommand>(command) ||
        std::holds_alternative<live::UndoNameCommand>(command)) {
      explored_.reset();
    }
    if (std::holds_alternative<live::StopTrainingCommand>(command)) {
      training_.request_stop();
      preparation_.request_stop();
      return {};
    }
    return player_.handle(command);
  }

  // The explorations of a body grow meanwhile; a recording does not change.
  std::shared_ptr<const Recording> explored() {
    const ViewSource& source = player_.source();
    if (!source.explorer && player_.names().empty()) {
      return {std::shared_ptr<const Recording>(), &source.recording};
    }
    const std::size_t end = source.first + source.recording.explorations.size();
    std::shared_ptr<const Recording> explored = explored_.lock();
    if (explored && explored_end_ == end) return explored;
    explored =
        std::make_shared<const Recording>(player_.names().apply(source.recording, source.first));
    explored_ = explored;
    explored_end_ = end;
    return explored;
  }

  // The explorations before the view are included.
  std::shared_ptr<const Recording> to_learn_from() {
    if (!prepared_) return explored();
    auto all = std::make_shared<Recording>(*prepared_);
    for (const Exploration& one : explored()->explorations) all->explorations.push_back(one);
    return all;
  }

  // Until it is done, no other system can be trained.
  void prepare() {
    const PriorExplorations& explorations = player_.source().prior_explorations;
    const ViewSystem* system = player_.system();
    if (explorations.rounds == 0 || system == nullptr || system->trained) return;
    is_training_ = true;
    player_.show_training(true);
    preparation_.start(*system, explorations, player_.source().seed,
                       [this, name = system->name](const Result<live::Prepared>& prepared) {
                         queue_.post([this, name, prepared] { end_preparation(name, prepared); });
                       });
  }

  void end_preparation(const std::string& name, const Result<live::Prepared>& prepared) {
    if (!prepared) return end_training(name, fail(prepared.error()));
    prepared_ = prepared->recording;
    if (prepared->is_last) return end_training(name, prepared->model);
    player_.take_trained(name, prepared->model);
    player_.publish_state();
  }

  Result<void> train() {
    const ViewSystem* system = player_.system();
    if (system == nullptr) return fail(ErrorKind::kUsage, "select a system first");
    if (system->description.modules.empty()) {
      return fail(ErrorKind::kUsage, "this system is already trained");
    }
    if (is_training_) return fail(ErrorKind::kUsage, "a system is already being trained");
    if (player_.source().recording.explorations.empty() && !prepared_) {
      return fail(ErrorKind::kUsage, "no explorations to learn from yet");
    }
    player_.show_problem({});
    is_training_ = true;
    player_.show_training(true);
    training_.start(*system, to_learn_from(), player_.source().seed,
                    [this, name = system->name](const auto& trained) {
                      queue_.post([this, name, trained] { end_training(name, trained); });
                    });
    return {};
  }

  void end_training(const std::string& name,
                    const Result<std::shared_ptr<const SystemModel>>& trained) {
    if (trained) {
      player_.take_trained(name, *trained);
    } else if (trained.error().kind != ErrorKind::kInterrupted) {
      player_.show_problem(live::sentence_of(trained.error()));
    }
    is_training_ = false;
    player_.show_training(false);
  }

  live::EventHub hub_;
  TaskQueue queue_;
  live::Player player_;
  live::TrainingThread training_;
  live::Preparation preparation_;
  live::Inquiries inquiries_{[this] { return hub_.is_closed(); }};
  // Only for the player's thread.
  bool is_training_ = false;
  std::weak_ptr<const Recording> explored_;    // while it is used: it is a copy
  std::size_t explored_end_ = 0;               // the index after its last exploration
  std::shared_ptr<const Recording> prepared_;  // explored before the view
  std::function<void()> on_thread_;
  std::thread thread_;
};

ViewSession::ViewSession(ViewSource source, const ViewSettings& settings)
    : impl_(std::make_unique<Impl>(std::move(source), settings)) {}

ViewSession::~ViewSession() {
  stop();
}

void ViewSession::start() {
  impl_->start();
}

void ViewSession::stop() {
  impl_->stop();
}

const Recording& ViewSession::recording() const {
  return impl_->recording();
}

std::shared_ptr<const SystemModel> ViewSession::system() const {
  return impl_->system();
}

Losses ViewSession::losses() const {
  return impl_->losses();
}

Result<void> ViewSession::command(std::string_view json) {
  return impl_->command(json);
}

bool ViewSession::post(std::function<void()> task) {
  return impl_->post(std::move(task));
}

Result<std::string> ViewSession::state() {
  return impl_->state();
}

Result<std::string> ViewSession::neuron(const std::string& map, std::size_t neuron) {
  return impl_->neuron(map, neuron);
}

Result<std::string> ViewSession::taxel(std::size_t element) {
  return impl_->taxel(element);
}

Result<std::string> ViewSession::strips() {
  return impl_->strips();
}

Result<std::string> ViewSession::recording_file() {
  return impl_->recording_file();
}

Result<std::string> ViewSession::system_file() {
  return impl_->system_file();
}

live::EventHub& ViewSession::hub() {
  return impl_->hub();
}

}  // namespace somato
