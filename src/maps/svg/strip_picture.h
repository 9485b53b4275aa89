#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace somato {

/// A part of a strip.
struct StripCell {
  std::string label{};            ///< Below it; empty for none.
  std::optional<double> share{};  ///< 0 to 1; nothing where nothing is known.
  std::string tooltip{};
};

/// A place on a strip that is marked.
struct StripMark {
  std::optional<double> place{};  ///< From 0, its left end, to 1; nothing: it is not on the strip.
  std::string text{};
};

/// A row of a panel: a quantity, and a share for each of its values or parts of its range.
struct Strip {
  std::string name{};
  std::string note{};                ///< Below the name, smaller.
  std::vector<StripCell> cells{};    ///< At least one, all of the same width.
  std::vector<std::string> edges{};  ///< For a range: the texts at the edges of its cells.
  StripMark mark{};
  std::string figure{};       ///< At the right.
  std::string figure_note{};  ///< Below the figure, smaller.
};

/// Strips about one statement.
struct StripPanel {
  std::string title{};
  std::string note{};
  std::vector<Strip> strips{};
};

/// The panels one below the other under a title and a caption (may be empty), as a standalone SVG
/// picture. Each cell has a bar as high as its share, in the colour of its share, with the share in
/// percent. Throws InvalidArgument without panels, for a strip without cells, for edges that are
/// not one more than the cells, and for a share or mark outside of 0 to 1.
std::string draw_strips(const std::string& title, const std::string& caption,
                        const std::vector<StripPanel>& panels);

}  // namespace somato
