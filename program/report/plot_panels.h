#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flags/command_line.h"
#include "maps/pictures/map_panels.h"
#include "som/map_and_rows.h"

namespace somato::program {

/// The panels that `som plot` draws, and how.
struct PlotChoice {
  std::vector<std::string> panels;  ///< In the order in which they are drawn.
  std::size_t components = 12;
  PlaneSorting sorting = PlaneSorting::kColumns;
  PlaneScale scale = PlaneScale::kOwn;
  bool size_by_hits = false;
  std::string clusters;  ///< METHOD or METHOD:NUMBER; empty: none.
  std::optional<std::pair<std::size_t, std::size_t>> trajectory;  ///< Rows, from 1; none: all.
};

/// The flags of panels, read by read_plot_choice().
std::vector<Flag> plot_panel_flags();

/// Errors (kUsage): an unknown name, or a panel that needs data, labels or another flag that the
/// command line lacks.
Result<PlotChoice> read_plot_choice(const Arguments& arguments);

/// The panels. Panels that the command line does not name are left out if their data are missing.
/// Errors: those of the file; kUsage if clusters or rows do not fit the map or the data.
Result<std::vector<Panel>> make_plot_panels(const MapAndRows& both, bool has_data,
                                            const PlotChoice& choice);

}  // namespace somato::program
