#pragma once

#include "distance/window.h"

/// Joining of windows that wait at an edge and belong to one front: see window_distance.h.
namespace karcher {

/// Joins windows that touch, and removes those that lie in others. Distances along the edge change
/// by at most `mostChange`, and the rays at the ends of a joint window do not turn inwards.
/// Requires at least one window.
void joinWindows(double mostChange, Array<Window>& windows);

}  // namespace karcher
