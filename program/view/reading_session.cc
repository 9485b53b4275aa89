#include "view/reading_session.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <utility>

#include "study/system_fit.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"
#include "view/reading_lines.h"

namespace somato::program {

live::ReadingSink ReadingSession::sink() {
  live::ReadingSink sink;
  sink.on_begin = [this](const Exploration& exploration) { return begin(exploration); };
  sink.on_moment = [this](const live::SaidReading& said) {
    return output_.write(moment_line(said));
  };
  sink.on_end = [this](const live::SaidReading& said, const Exploration& exploration) {
    return output_.write(final_line(said, exploration));
  };
  if (takes_names_) {
    sink.name_of = [this](const live::SaidReading& said) { return name_of(said); };
  }
  sink.on_taught = [this](const live::TaughtName& name) { return note_taught(name); };
  sink.on_forgotten = [this](const GivenName& name) { return note_forgotten(name); };
  sink.on_failure = [this](const Error& failure) { report(failure); };
  sink.on_unsaved = [this](const Error& error) { report_unsaved(error); };
  sink.on_done = [this](const Result<void>& outcome) { end(outcome); };
  return sink;
}

// Explorations of one body have the same channels.
Result<void> ReadingSession::begin(const Exploration& exploration) {
  if (std::exchange(is_checked_, true)) return {};
  return check_body_fit(model_->system, exploration, place_);
}

// A line that was typed during the exploration is its name.
std::optional<std::string> ReadingSession::name_of(const live::SaidReading& said) {
  const bool is_new =
      said.reading != nullptr && said.reading->novelty && is_unknown(*said.reading->novelty);
  if (!is_new || !waits_) return names_.take();
  return names_.ask(fmt::format("Exploration {} is unknown. Type its name, or press Enter: ",
                                said.exploration + 1));
}

Result<void> ReadingSession::note_taught(const live::TaughtName& name) {
  if (name.problem.empty()) {
    taught_.insert(name.exploration);
  } else {
    taught_.erase(name.exploration);
    std::fputs(fmt::format("somato: exploration {}: the name '{}' was not learned: {}\n",
                           name.exploration + 1, printable(name.name), printable(name.problem))
                   .c_str(),
               stderr);
  }
  return output_.write(taught_line(name));
}

Result<void> ReadingSession::note_forgotten(const GivenName& name) {
  taught_.erase(name.exploration);
  return output_.write(forgotten_line(name));
}

void ReadingSession::report(const Error& failure) {
  ++failures_;
  last_failure_ = failure.kind;
  std::fputs(fmt::format("somato: {}\n", printable(to_string(failure))).c_str(), stderr);
}

void ReadingSession::report_unsaved(const Error& error) {
  is_unsaved_ = true;
  std::fputs(fmt::format("somato: {}\nThe recording ends here; the readings continue.\n",
                         printable(to_string(error)))
                 .c_str(),
             stderr);
}

void ReadingSession::end(const Result<void>& outcome) {
  const std::scoped_lock lock(mutex_);
  done_ = outcome;
  changed_.notify_all();
}

// A signal cannot wake a thread that waits.
void ReadingSession::wait(bool stays_open, const std::function<void()>& meanwhile) {
  std::unique_lock lock(mutex_);
  while (!stop_requested() && !is_over(stays_open)) {
    lock.unlock();
    meanwhile();
    lock.lock();
    if (is_over(stays_open)) return;
    changed_.wait_for(lock, std::chrono::milliseconds(50));
  }
}

bool ReadingSession::is_over(bool stays_open) const {
  return done_ && (!stays_open || !*done_);
}

Result<void> ReadingSession::outcome() const {
  if (output_.is_closed()) return {};
  if (!done_ || (!*done_ && done_->error().kind == ErrorKind::kInterrupted)) {
    return fail(ErrorKind::kInterrupted, "stopped before all explorations were read");
  }
  if (*done_ && failures_ == 0 && is_unsaved_) {
    return fail(ErrorKind::kIncomplete, "explorations could not be saved");
  }
  if (!*done_ || failures_ == 0) return *done_;
  const bool has_ended = last_failure_ == ErrorKind::kUnavailable;
  return fail(has_ended ? ErrorKind::kUnavailable : ErrorKind::kIncomplete,
              fmt::format("{} failed and have no reading", counted(failures_, "exploration")));
}

}  // namespace somato::program
