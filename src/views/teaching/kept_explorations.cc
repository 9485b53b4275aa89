#include "views/teaching/kept_explorations.h"

#include <utility>

#include "recordings/explorations/growing_channel.h"

namespace somato::live {
namespace {

// Memory that was reserved for further frames is released.
std::size_t shrink(Exploration& exploration) {
  std::size_t bytes = 0;
  for (Channel& channel : exploration.channels) {
    channel.frames.shrink_to_fit();
    channel.times.shrink_to_fit();
    bytes += bytes_of(channel);
  }
  return bytes;
}

}  // namespace

KeptExplorations::KeptExplorations(ViewSource& source)
    : source_(source),
      saves_(source.file != nullptr),
      kept_(source.recording.explorations.size()) {}

// A file that failed cannot be written any more.
Result<void> KeptExplorations::checked(Result<void> saved) {
  if (!saved && saved.error().kind == ErrorKind::kSystem) saves_ = false;
  if (!saved) draft_.reset();
  return saved;
}

Result<void> KeptExplorations::count_saved(Result<void> saved) {
  draft_.reset();
  if (!saved) ++unsaved_;
  return checked(std::move(saved));
}

void KeptExplorations::begin_next(const BodyDescription& body, std::vector<Label> labels) {
  if (source_.file == nullptr) return;
  if (!saves_) saves_ = source_.file->begin_again().value_or(false);
  if (saves_) draft_.emplace(*source_.file).begin(body, std::move(labels));
}

// After an error the rest of the exploration is not saved before its end.
Result<void> KeptExplorations::append_to_next(const BodyState& state) {
  return draft_ ? checked(draft_->append(state)) : Result<void>();
}

Result<void> KeptExplorations::add(Exploration exploration, std::shared_ptr<KeptScene> scene) {
  auto& explorations = source_.recording.explorations;
  Recording single{{std::move(exploration)}};
  const Exploration& first = explorations.empty() ? single.explorations[0] : explorations.front();
  auto valid =
      validate(single).and_then([&] { return check_alike(single.explorations[0], first); });
  if (!valid) {
    discard_next();
    return valid;
  }
  explorations.push_back(std::move(single.explorations[0]));
  const std::size_t bytes = shrink(explorations.back()) + (scene ? scene->bytes() : 0);
  kept_.push_back({std::move(scene), {}, bytes});
  bytes_ += bytes;
  return {};
}

Result<void> KeptExplorations::save_last() {
  if (source_.file == nullptr) return {};
  if (!saves_) {
    ++unsaved_;
    return {};
  }
  SOMATO_TRY_VOID(count_saved(source_.file->add(source_.recording.explorations.back())));
  kept_.back().number_in_file = source_.file->count() - 1;
  return {};
}

Result<void> KeptExplorations::add_unkept() {
  ++source_.first;
  names_.forget_before(first());
  if (source_.file == nullptr) return {};
  if (saves_) return count_saved(source_.file->keep_draft());
  ++unsaved_;
  return {};
}

std::size_t KeptExplorations::first_within(std::size_t most) const {
  std::size_t bytes = bytes_;
  std::size_t dropped = 0;
  for (; bytes > most && dropped + 1 < kept_.size(); ++dropped) bytes -= kept_[dropped].bytes;
  return first() + dropped;
}

void KeptExplorations::drop_before(std::size_t first) {
  if (first <= source_.first) return;
  const auto dropped = static_cast<std::ptrdiff_t>(first - source_.first);
  for (std::ptrdiff_t i = 0; i < dropped; ++i) {
    bytes_ -= kept_[static_cast<std::size_t>(i)].bytes;
  }
  auto& explorations = source_.recording.explorations;
  explorations.erase(explorations.begin(), explorations.begin() + dropped);
  kept_.erase(kept_.begin(), kept_.begin() + dropped);
  names_.forget_before(first);
  source_.first = first;
}

Result<void> KeptExplorations::name_in_file(std::size_t index, const Label& given) {
  const auto number = index < count() ? at(index).number_in_file : source_.file->count();
  if (number) return checked(source_.file->name(*number, given));
  return fail(ErrorKind::kUsage, "this exploration is not in the file of this session");
}

// A session whose file has failed continues, with names.
Result<void> KeptExplorations::name(std::size_t index, const Label& given) {
  const Result<void> named = saves_ ? name_in_file(index, given) : Result<void>();
  const bool is_refused = !named && named.error().kind != ErrorKind::kSystem;
  if (!is_refused) names_.give(index, given);
  return named;
}

// An error of the file comes again with the next exploration.
void KeptExplorations::discard_next() {
  draft_.reset();
  names_.forget(count());
  if (saves_) (void)source_.file->drop_draft();
}

}  // namespace somato::live
