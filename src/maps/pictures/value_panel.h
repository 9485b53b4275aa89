#pragma once

#include "maps/pictures/panel_frame.h"
#include "maps/svg/colour_bar.h"
#include "somato/drawing/map_picture.h"

namespace somato {

/// The frame of a panel; throws InvalidArgument for what draw_picture() rules out.
PanelFrame frame_of(const ValuePanel& panel);

/// Draws a panel in its frame.
void draw_panel(SvgWriter& svg, const PanelFrame& frame, const ValuePanel& panel);

/// The colour bar of a panel, below its map.
void draw_bar(SvgWriter& svg, const PanelFrame& frame, const ValueRange& range);

}  // namespace somato
