#pragma once

#include "mesh/triangle_soup.h"

namespace karcher {

/// A closed surface of genus 3: three tori in a row, smoothly joined. It has between 2/3 and 3/2 of
/// `triangles` triangles if that is at least 500.
TriangleSoup genusThree(int triangles);

}  // namespace karcher
