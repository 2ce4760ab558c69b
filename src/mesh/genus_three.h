#pragma once

#include "mesh/triangle_soup.h"

namespace karcher {

/// A closed surface of genus 3: three tori in a row, smoothly joined. About `triangles` triangles,
/// between 2/3 and 3/2 of it from 500 on.
TriangleSoup genusThree(int triangles);

}  // namespace karcher
