#include "views/teaching/kept_explorations.h"

#include <utility>

namespace somato::live {

KeptExplorations::KeptExplorations(Recording& recording, GrowingRecording* file)
    : recording_(recording), file_(file), scenes_(count()), numbers_(count()) {}

void KeptExplorations::begin_next(const BodyDescription& body, std::vector<Label> labels) {
  if (file_ == nullptr) return;
  draft_.emplace(*file_).begin(body, std::move(labels));
}

// After an error the rest of the exploration is not saved before its end.
Result<void> KeptExplorations::append_to_next(const BodyState& state) {
  if (!draft_) return {};
  auto appended = draft_->append(state);
  if (!appended) draft_.reset();
  return appended;
}

Result<void> KeptExplorations::add(Exploration exploration, std::shared_ptr<ScenePlayer> scene) {
  Recording single{{std::move(exploration)}};
  const Exploration& first =
      count() == 0 ? single.explorations[0] : recording_.explorations.front();
  auto valid =
      validate(single).and_then([&] { return check_alike(single.explorations[0], first); });
  if (!valid) {
    discard_next();
    return valid;
  }
  recording_.explorations.push_back(std::move(single.explorations[0]));
  scenes_.push_back(std::move(scene));
  numbers_.emplace_back();
  return {};
}

Result<void> KeptExplorations::save_last() {
  draft_.reset();
  if (file_ == nullptr) return {};
  SOMATO_TRY_VOID(file_->add(recording_.explorations.back()));
  numbers_.back() = file_->count() - 1;
  return {};
}

std::optional<std::size_t> KeptExplorations::number_in_file(std::size_t index) const {
  return index < count() ? numbers_[index] : file_->count();
}

Result<void> KeptExplorations::name(std::size_t index, const Label& given) {
  const auto number = file_ != nullptr ? number_in_file(index) : std::nullopt;
  if (file_ != nullptr && !number) {
    return fail(ErrorKind::kUsage, "this exploration is not in the file of this session");
  }
  names_.give(index, given);
  return number ? file_->name(*number, given) : Result<void>();
}

// An error of the file comes again with the next exploration.
void KeptExplorations::discard_next() {
  draft_.reset();
  names_.forget(count());
  if (file_ != nullptr) (void)file_->drop_draft();
}

}  // namespace somato::live
