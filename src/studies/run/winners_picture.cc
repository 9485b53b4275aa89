#include "studies/run/winners_picture.h"

#include <fmt/format.h>

#include "somato/drawing/map_picture.h"

namespace somato {

std::string winners_picture(const StudyDescription& description, const StudyOutcome& outcome) {
  LabelPanel panel;
  panel.title = "Winners by " + description.study.label;
  panel.grid = outcome.map().grid();
  panel.class_names = outcome.classes.names;
  panel.winners = outcome.winners;
  panel.classes = outcome.classes.of_sample;
  const std::string caption = fmt::format("{} explorations, all used for training; seed {}.",
                                          outcome.winners.size(), description.study.first_seed);
  return draw_picture(description.study.name, caption, {panel});
}

}  // namespace somato
