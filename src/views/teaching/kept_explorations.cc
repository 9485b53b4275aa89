#include "views/teaching/kept_explorations.h"

#include <algorithm>
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
      counts_(source.names, source.each),
      kept_(source.recording.explorations.size()) {
  for (std::size_t i = first(); i < count(); ++i) count_own(i, (*this)[i].labels);
  next_id_ = first();
  for (Kept& one : kept_) one.id = next_id_++;
}

Result<std::size_t> KeptExplorations::index_of(std::size_t id) const {
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& one) { return one.id == id; });
  if (found != kept_.end()) return first() + static_cast<std::size_t>(found - kept_.begin());
  if (id == next_id_) return count();
  if (id > next_id_) return fail(ErrorKind::kUsage, "there is no such exploration");
  return fail(ErrorKind::kUsage,
              "this exploration was discarded, or is no longer kept (--page-memory)");
}

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
  next_labels_ = labels;
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
  count_own(count(), single.explorations[0].labels);
  explorations.push_back(std::move(single.explorations[0]));
  const std::size_t bytes = shrink(explorations.back()) + (scene ? scene->bytes() : 0);
  kept_.push_back({next_id_++, std::move(scene), {}, bytes});
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
  count_own(count(), next_labels_);
  ++source_.first;
  ++next_id_;
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
  if (is_refused) return named;
  recount(index, given.name, [&] { names_.give(index, given); });
  return named;
}

// A file has no label that is not given any more: it gets its former value.
Result<void> KeptExplorations::take_back_name() {
  const GivenName last = *names_.last();
  const std::string& label = last.label.name;
  const Label former{label, last.before.value_or(own_value(last.exploration, label))};
  const Result<void> saved = saves_ ? name_in_file(last.exploration, former) : Result<void>();
  if (!saved && saved.error().kind != ErrorKind::kSystem) return saved;
  recount(last.exploration, label, [&] { names_.take_back(); });
  return saved;
}

// Labels that were given are counted already.
void KeptExplorations::count_own(std::size_t index, const std::vector<Label>& labels) {
  for (const Label& own : labels) {
    if (!names_.given(index, own.name)) counts_.add(own);
  }
}

std::string KeptExplorations::own_value(std::size_t index, const std::string& label) const {
  const auto& labels = index < count() ? (*this)[index].labels : next_labels_;
  const auto own = std::find_if(labels.begin(), labels.end(),
                                [&](const Label& one) { return one.name == label; });
  return own == labels.end() ? "unknown" : own->value;
}

// The next exploration counts if it was given a name.
std::string KeptExplorations::counted_value(std::size_t index, const std::string& label) const {
  const auto given = names_.given(index, label);
  if (given || index == count()) return given.value_or("unknown");
  return own_value(index, label);
}

// The new name is counted first, so that the same name keeps its place.
template <typename Change>
void KeptExplorations::recount(std::size_t index, const std::string& label, const Change& change) {
  const std::string before = counted_value(index, label);
  change();
  counts_.add({label, counted_value(index, label)});
  counts_.remove({label, before});
}

// An error of the file comes again with the next exploration.
void KeptExplorations::discard_next() {
  ++next_id_;
  draft_.reset();
  for (const Label& label : names_.labels(count(), {})) {
    if (names_.given(count(), label.name)) counts_.remove(label);
  }
  names_.forget(count());
  if (saves_) (void)source_.file->drop_draft();
}

}  // namespace somato::live
