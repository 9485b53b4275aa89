#include "views/teaching/teachers.h"

#include <algorithm>

namespace somato::live {

bool Teachers::can_teach(std::size_t system) const {
  const auto& trained = source_.systems[system].trained;
  return source_.teaches && trained && trained->answer;
}

const TaughtName& Teachers::teach(std::size_t system, std::size_t exploration,
                                  const std::string& name) {
  ViewSystem& taught = source_.systems[system];
  Teacher& teacher = teachers_.try_emplace(system, taught.trained).first->second;
  const TaughtName& learned = teacher.teach(source_.recording, exploration, name, source_.first);
  taught.trained = teacher.model();
  return learned;
}

void Teachers::take_back(const GivenName& name) {
  for (auto& [system, teacher] : teachers_) {
    ViewSystem& taught = source_.systems[system];
    if (taught.trained->answer->label != name.label.name || !is_taught(system, name.exploration)) {
      continue;
    }
    if (name.before) {
      teacher.teach(source_.recording, name.exploration, *name.before, source_.first);
    } else {
      teacher.take_back(source_.recording, name.exploration, source_.first);
    }
    taught.trained = teacher.model();
  }
}

const std::vector<TaughtName>& Teachers::names(std::size_t system) const {
  static const std::vector<TaughtName> none;
  const auto teacher = teachers_.find(system);
  return teacher == teachers_.end() ? none : teacher->second.names();
}

bool Teachers::is_taught(std::size_t system, std::size_t exploration) const {
  const auto& taught = names(system);
  return std::any_of(taught.begin(), taught.end(),
                     [&](const TaughtName& one) { return one.exploration == exploration; });
}

void Teachers::settle_before(std::size_t kept) {
  for (auto& [system, teacher] : teachers_) {
    teacher.settle_before(kept, source_.recording, source_.first);
  }
}

void Teachers::forget() {
  for (auto& [system, teacher] : teachers_) {
    teacher.forget();
    source_.systems[system].trained = teacher.model();
  }
}

}  // namespace somato::live
