#pragma once

#include "maps/pictures/panel_frame.h"
#include "somato/drawing/map_picture.h"

namespace somato {

/// The frame of a panel; throws InvalidArgument for what draw_picture() rules out.
PanelFrame frame_of(const EdgePanel& panel);

/// Draws a panel in its frame.
void draw_panel(SvgWriter& svg, const PanelFrame& frame, const EdgePanel& panel);

}  // namespace somato
