#pragma once

#include "mesh/triangle_soup.h"

namespace karcher {

/// A closed surface of genus 3: three tori in a row, smoothly joined. If `triangles` is at least
/// 500, the surface has between 2/3 and 3/2 of this number.
TriangleSoup genusThree(int triangles);

}  // namespace karcher
