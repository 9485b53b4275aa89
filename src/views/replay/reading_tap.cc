#include "views/replay/reading_tap.h"

#include <utility>

namespace somato::live {

void ReadingTap::begin(const PlayedExploration& played) {
  if (!is_open() || (played.has_ended && index_ == played.index)) return;
  index_ = played.index;
  has_grown_ = !played.has_ended;
  is_whole_ = false;
  said_ = 0;
  check(sink_.on_begin(*played.exploration));
}

void ReadingTap::say(const PlayedExploration& played, std::size_t moments, LiveReader& reader) {
  const bool is_new = !(has_grown_ && played.has_ended) && moments > said_;
  const bool is_end = played.has_ended && moments == played.timeline->moments() && !is_whole_;
  if (!is_open() || index_ != played.index || !(is_new || is_end)) return;
  const Reading* reading = reader.read(true);
  if (reader.error()) return finish(fail(*reader.error()));
  if (reader.model() == nullptr) return finish(fail(ErrorKind::kData, reader.problem()));
  if (is_new) note(moments, played.timeline->time(moments - 1));
  const SaidReading said{played.index, said_, time_, *reader.model(), reading};
  if (is_new) check(sink_.on_moment(said));
  if (is_end) end(said, played);
}

void ReadingTap::note(std::size_t moments, double time) {
  if (moments == 1) begun_ = time;
  time_ = time - begun_;
  said_ = moments;
}

void ReadingTap::end(const SaidReading& said, const PlayedExploration& played) {
  is_whole_ = true;
  ++ended_;
  if (!is_open()) return;
  check(sink_.on_end(said, *played.exploration));
  if (is_open() && sink_.name_of) name_ = sink_.name_of(said);
}

void ReadingTap::say_taught(const TaughtName& name) {
  if (is_open() && sink_.on_taught) check(sink_.on_taught(name));
}

void ReadingTap::say_forgotten(const GivenName& name) {
  if (is_open() && sink_.on_forgotten) check(sink_.on_forgotten(name));
}

void ReadingTap::say_failure(const Error& error) const {
  if (is_open()) sink_.on_failure(error);
}

void ReadingTap::say_unsaved(const Error& error) const {
  if (is_open() && sink_.on_unsaved) sink_.on_unsaved(error);
}

void ReadingTap::finish(const Result<void>& outcome) {
  if (!is_open()) return;
  std::exchange(sink_.on_done, nullptr)(outcome);
}

void ReadingTap::check(const Result<void>& taken) {
  if (!taken) finish(taken);
}

}  // namespace somato::live
