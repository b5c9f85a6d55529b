#pragma once
/// A lab beside an editor: compiled, checked and drawn whenever a file of it is saved.

#include "labs/runner/commands.h"

namespace sightline::labs {

/// Keys: n the next lab, h a hint, l the list, c check again, q the end. Ends with q, Ctrl-C, or where standard input
/// ends; without a terminal it goes on until it is ended.
int watch_lab(const Workshop& workshop, const Request& request);

}  // namespace sightline::labs
