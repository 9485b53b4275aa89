#include "views/live/naming.h"

#include <fmt/format.h>

#include <optional>

#include "views/session/viewed_system.h"

namespace somato::live {

// Names the exploration that is shown, or another one that is kept: on a slow line, the one that is
// meant may have ended meanwhile.
Result<void> Naming::name(const NameCommand& command) {
  const PlayedExploration* played = stage_.replay.played();
  if (played == nullptr) return not_now("there is no exploration to name");
  std::size_t index = played->index;
  if (command.id) {
    SOMATO_TRY(index, stage_.kept.index_of(*command.id));
  }
  if (index < stage_.kept.first()) return not_now("it is no longer kept (--page-memory)");
  if (index != played->index && index >= stage_.kept.count()) {
    return not_now("there is no such exploration");
  }
  auto named = stage_.kept.name(index, command.label);
  if (!named && named.error().kind != ErrorKind::kSystem) return named;
  if (index < stage_.kept.count() && command.label.name == stage_.chosen.answered_label())
    teach_given(index);
  return check_saved(named);
}

// Another page may have given another name meanwhile, or taken this one back.
Result<void> Naming::undo_name(const UndoNameCommand& command) {
  if (stage_.kept.names().last() == nullptr) return not_now("there is no name to undo");
  const GivenName last = *stage_.kept.names().last();
  if (stage_.kept.id(last.exploration) != command.id || last.label != command.label) {
    return not_now(fmt::format("the name that was given last is now {} = '{}' of exploration {}",
                               last.label.name, last.label.value, last.exploration + 1));
  }
  auto undone = stage_.kept.take_back_name();
  if (!undone && undone.error().kind != ErrorKind::kSystem) return undone;
  forget_taught(last);
  return check_saved(undone);
}

void Naming::forget_taught(const GivenName& name) {
  const bool was_taught = stage_.chosen.is_taught(name.exploration);
  stage_.chosen.take_back(name);
  if (!was_taught || name.label.name != stage_.chosen.answered_label()) return;
  for (const TaughtName& one : stage_.chosen.taught_names()) {
    if (one.exploration == name.exploration) return stage_.replay.tap().say_taught(one);
  }
  stage_.replay.tap().say_forgotten(name);
}

// A name is confirmed where it is on the disk, if the session has a file.
Result<void> Naming::check_saved(const Result<void>& saved) {
  report(saved);
  if (stage_.source.file == nullptr || stage_.kept.saves()) return {};
  return fail(ErrorKind::kSystem,
              "the change is in the session, but not on the disk: its file cannot be written");
}

void Naming::teach(std::size_t exploration, const std::string& name) {
  if (exploration >= stage_.kept.first()) {
    stage_.replay.tap().say_taught(stage_.chosen.teach(exploration, name));
  } else {
    stage_.replay.tap().say_taught(
        {exploration,
         name,
         {},
         "The frames of the exploration are no longer kept (--page-memory)."});
  }
  stage_.publish();
}

void Naming::teach_given(std::size_t exploration) {
  const auto label = stage_.chosen.answered_label();
  if (!label) return;
  if (const auto name = stage_.kept.names().given(exploration, *label)) teach(exploration, *name);
}

// Given by the receiver of the readings.
void Naming::take_name() {
  const auto name = stage_.replay.tap().take_name();
  const auto label = stage_.chosen.answered_label();
  if (!name || !label || stage_.replay.played() == nullptr) return;
  const std::size_t exploration = stage_.replay.played()->index;
  const auto named = stage_.kept.name(exploration, {*label, *name});
  if (!named && named.error().kind != ErrorKind::kSystem) {
    stage_.problem = sentence_of(named.error());
    return;
  }
  report(named);
  teach(exploration, *name);
}

// An unknown thing is named; the system's answer after that is shown for a while, too.
bool Naming::teach_demonstrated() {
  if (!stage_.chosen.answers_unknown()) return false;
  const PlayedExploration& played = *stage_.replay.played();
  Exploration named;
  named.labels = stage_.kept.names().labels(played.index, played.exploration->labels);
  const auto name = find_label(named, *stage_.chosen.answered_label());
  if (!name || stage_.chosen.is_taught(played.index)) return false;
  teach(played.index, *name);
  return true;
}

void Naming::report(const Result<void>& saved) {
  if (saved) return;
  stage_.problem = sentence_of(saved.error()) + " The session continues without its file.";
  stage_.replay.tap().say_unsaved(saved.error());
}

}  // namespace somato::live
