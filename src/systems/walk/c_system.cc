#include "somato/c/c_system.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/signal.h"
#include "somato/graph/further_learning.h"
#include "somato/graph/live_system.h"
#include "somato/graph/system_model.h"
#include "systems/walk/answer_reader.h"

// NOLINTNEXTLINE(readability-identifier-naming): the language of its header is C.
struct somato_system {
  explicit somato_system(somato::SystemModel loaded) : model(std::move(loaded)) {}

  somato::Result<void> follow();
  somato::Result<void> step(const float* const* values);
  somato::Result<somato_answer> answer();
  somato::Result<void> teach(const std::string& name);

  somato::SystemModel model;
  std::optional<somato::LiveSystem> live;
  std::optional<somato::AnswerReader> reader;
  somato::SomWorkspace workspace;
  std::vector<std::span<const float>> frame;  // of a step
  bool is_open = true;                        // whether an exploration can continue
  std::string message;
};

// Reads the model as it is now, from the beginning of an exploration.
somato::Result<void> somato_system::follow() {
  SOMATO_TRY(const auto map, somato::answering_map(model));
  if (model.answer->labels.labelled().empty()) {
    return somato::fail(somato::ErrorKind::kData, "no neuron of the map has a name", {},
                        "train the system with a label");
  }
  reader.reset();
  SOMATO_TRY(live, somato::LiveSystem::build(model.system, map));
  reader.emplace(model);
  frame.resize(live->channels().size());
  return {};
}

somato::Result<void> somato_system::step(const float* const* values) {
  somato::require(is_open, "an exploration has ended; somato_start() begins the next one");
  somato::require(values != nullptr, "a frame is NULL");
  for (std::size_t i = 0; i < frame.size(); ++i) {
    somato::require(values[i] != nullptr, "a channel of the frame is NULL");
    frame[i] = {values[i], live->elements()[i]};
    if (std::ranges::all_of(frame[i], [](float value) { return std::isfinite(value); })) continue;
    return somato::fail(somato::ErrorKind::kData, "a value is not a finite number",
                        "channel '" + live->channels()[i] + "'",
                        "give the last valid value, or leave the frame out");
  }
  is_open = false;  // until the frame has been processed
  SOMATO_TRY_VOID(live->step(frame));
  is_open = true;
  return {};
}

somato::Result<somato_answer> somato_system::answer() {
  somato::require(is_open, "an exploration has ended; somato_start() begins the next one");
  SOMATO_TRY(const auto input, live->input());
  const somato::InputAnswer given = reader->answer(input, workspace);
  return somato_answer{given.winner,
                       given.winner_distance,
                       given.nearest,
                       given.distance,
                       given.novelty.value_or(std::numeric_limits<double>::quiet_NaN()),
                       given.is_unknown() ? 1 : 0};
}

somato::Result<void> somato_system::teach(const std::string& name) {
  somato::require(is_open, "an exploration has ended; somato_start() begins the next one");
  SOMATO_TRY(const auto input, live->input());
  const somato::Signal kept = somato::Signal::copy_of(input);
  SOMATO_TRY_VOID(somato::teach(model, kept.view(), name));
  is_open = false;
  return follow();
}

namespace somato {
namespace {

somato_status status_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kUsage:
      return SOMATO_USAGE;
    case ErrorKind::kData:
      return SOMATO_DATA;
    default:
      return SOMATO_FAILED;
  }
}

// Runs `work`, which returns a Result<void>, and gives its message to `message`; throws nothing.
template <typename Work>
somato_status guarded(std::string& message, const Work& work) noexcept {
  const auto failed = [&](std::string_view what, somato_status status) {
    try {
      message = what;
    } catch (...) {
      message.clear();
    }
    return status;
  };
  try {
    message.clear();
    const Result<void> done = work();
    return done ? SOMATO_OK : failed(to_string(done.error()), status_of(done.error().kind));
  } catch (const InvalidArgument& error) {
    return failed(error.what(), SOMATO_USAGE);
  } catch (const std::exception& error) {
    return failed(error.what(), SOMATO_INTERNAL);
  } catch (...) {
    return failed("an unknown error", SOMATO_INTERNAL);
  }
}

// `text` with a final 0, cut to `size` bytes with it.
void copy_text(std::string_view text, char* out, std::size_t size) {
  if (size == 0) return;
  const std::size_t length = std::min(text.size(), size - 1);
  std::memcpy(out, text.data(), length);
  out[length] = '\0';
}

}  // namespace
}  // namespace somato

somato_system* somato_load(const char* path, char* message, size_t size) {
  std::unique_ptr<somato_system> system;
  std::string problem;
  const somato_status status = somato::guarded(problem, [&]() -> somato::Result<void> {
    somato::require(path != nullptr, "a path is NULL");
    SOMATO_TRY(auto model, somato::load_system(path));
    system = std::make_unique<somato_system>(std::move(model));
    return system->follow();
  });
  somato::copy_text(problem, message, size);
  return status == SOMATO_OK ? system.release() : nullptr;
}

void somato_free(somato_system* system) {
  delete system;
}

const char* somato_message(const somato_system* system) {
  return system->message.c_str();
}

size_t somato_channels(const somato_system* system) {
  return system->frame.size();
}

const char* somato_channel_name(const somato_system* system, size_t channel) {
  return channel < system->frame.size() ? system->live->channels()[channel].c_str() : nullptr;
}

size_t somato_channel_elements(const somato_system* system, size_t channel) {
  return channel < system->frame.size() ? system->live->elements()[channel] : 0;
}

const char* somato_class_name(const somato_system* system, size_t number) {
  const std::vector<std::string>& classes = system->model.answer->classes;
  return number < classes.size() ? classes[number].c_str() : nullptr;
}

somato_status somato_start(somato_system* system, double frame_rate) {
  return somato::guarded(system->message, [&]() -> somato::Result<void> {
    somato::require(frame_rate >= 0.0 && frame_rate < std::numeric_limits<double>::infinity(),
                    "a frame rate is a number from 0");
    somato::require(system->reader.has_value(), "the system could not be read after it learned");
    system->live->start(frame_rate);
    system->is_open = true;
    return {};
  });
}

somato_status somato_step(somato_system* system, const float* const* frame) {
  return somato::guarded(system->message, [&] { return system->step(frame); });
}

somato_status somato_read(somato_system* system, somato_answer* answer) {
  return somato::guarded(system->message, [&]() -> somato::Result<void> {
    SOMATO_TRY(*answer, system->answer());
    return {};
  });
}

somato_status somato_teach(somato_system* system, const char* name) {
  return somato::guarded(system->message, [&] {
    somato::require(name != nullptr, "a name is NULL");
    return system->teach(name);
  });
}

somato_status somato_save(somato_system* system, const char* path) {
  return somato::guarded(system->message, [&] {
    somato::require(path != nullptr, "a path is NULL");
    return somato::save_system(path, system->model);
  });
}
