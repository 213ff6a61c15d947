#pragma once

namespace clapotis {

/// Whether a window can be opened. Asked before SFML is touched, because SFML ends the process when there is
/// no display. A DISPLAY that is set but answers to nobody counts as none. Links against no display library.
bool display_available();

}  // namespace clapotis
