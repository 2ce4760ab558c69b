#include "regions/region.h"

#include <algorithm>
#include <string>

#include "mesh/disjoint_sets.h"
#include "mesh/error.h"
#include "mesh/rounding.h"
#include "mesh/sorted_numbers.h"

namespace karcher {
namespace {

/// The uses of an edge of the arrangement by a range of paths, summed up.
struct EdgeCount {
  int halfedge = 0;
  int change = 0;    ///< the change of the label from the right to the left of the half-edge
  PathUse earliest;  ///< the earliest use; its `path` is -1 if no path of the range uses the edge
};

bool isEarlier(const PathUse& a, const PathUse& b) {
  return a.path != b.path ? a.path < b.path : a.order < b.order;
}

/// Whether the labels on the two sides of an edge differ.
bool parts(const EdgeCount& count, FillRule rule) {
  return (rule == FillRule::kEvenOdd ? count.change % 2 : count.change) != 0;
}

/// The summed-up uses of the edge of use i. Advances `i` to the first use of the next edge.
EdgeCount countAt(const Arrangement& all, const PathRange& paths, int& i) {
  EdgeCount count;
  count.halfedge = all.uses[i].halfedge;
  count.earliest.path = -1;
  for (; i < all.uses.count() && all.uses[i].halfedge == count.halfedge; ++i) {
    const PathUse& use = all.uses[i];
    const int path = use.path - paths.first;
    if (path < 0 || path >= paths.count) continue;
    count.change += use.sign;
    if (count.earliest.path < 0 || isEarlier(use, count.earliest)) count.earliest = use;
  }
  return count;
}

/// A step over an edge of the arrangement into another cell.
struct Step {
  int from;
  int to;
  int change;
};

/// The steps over all edges with a path, in both directions, sorted by the cell from which they
/// lead.
struct Steps {
  Array<int> start;
  Array<Step> steps;
  /// The uses of the edges whose two sides have different labels, as the paths run.
  Array<PathUse> parting;
};

Steps stepsOf(const Arrangement& all, const PathRange& paths, FillRule rule) {
  Array<Step> found;
  Steps result;
  for (int i = 0; i < all.uses.count();) {
    const EdgeCount count = countAt(all, paths, i);
    const int h = count.halfedge;
    if (all.twin[h] < 0) continue;
    const int left = all.cell(h);
    const int right = all.cell(all.twin[h]);
    found.push_back({right, left, count.change});
    found.push_back({left, right, -count.change});
    if (parts(count, rule)) result.parting.push_back(count.earliest);
  }
  std::sort(result.parting.begin(), result.parting.end(), isEarlier);
  result.start.assign(static_cast<size_t>(all.cellCount()) + 1, 0);
  for (const Step& step : found) ++result.start[step.from + 1];
  for (int c = 0; c < all.cellCount(); ++c) result.start[c + 1] += result.start[c];
  result.steps.resize(found.size());
  Array<int> next = result.start;
  for (const Step& step : found) result.steps[next[step.from]++] = step;
  return result;
}

[[noreturn]] void refuseOpen(const PathRange& paths) {
  const std::string sentence =
      paths.count == 1
          ? "the curve does not bound a region: its left side is reached from its right "
            "side without crossing it"
          : "the " + std::to_string(paths.count) +
                " curves do not bound a region together: the left side of one is "
                "reached from its right side without crossing any";
  refuse(sentence + ", around an end or a handle of the surface");
}

/// Decides which cells of a component of the surface are outside, and writes to `region` whether
/// each of its cells is inside.
void chooseSide(const Arrangement& all, const Array<int>& cells, const Array<int>& labels,
                std::optional<int> inside, Region& region) {
  struct LabelArea {
    int label;
    double area;
  };
  Array<LabelArea> areas;
  Array<int> order = cells;
  sortNumbers(order, [&](int a, int b) { return labels[a] < labels[b]; });
  for (const int cell : order) {
    if (areas.empty() || areas.back().label != labels[cell]) areas.push_back({labels[cell], 0});
    areas.back().area += all.cellArea[cell];
  }
  // Of labels with equal areas up to rounding, the smallest is outside: it belongs to cells right
  // of the curves (with kEvenOdd, right of their first place).
  const LabelArea* outside = nullptr;
  for (const LabelArea& one : areas) {
    if (inside && one.label == labels[*inside]) continue;
    if (outside == nullptr || one.area > outside->area * (1 + kChainRounding)) outside = &one;
  }
  // If all cells have the label of `inside`, for example with a curve along the boundary, no cell
  // is outside.
  for (const int cell : cells) {
    region[cell] = outside == nullptr || labels[cell] != outside->label ? 1 : 0;
  }
}

}  // namespace

Region enclosed(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                std::optional<int> inside) {
  const Steps all = stepsOf(arrangement, paths, rule);
  const size_t count = static_cast<size_t>(arrangement.cellCount());
  Array<int> labels(count, 0);
  Array<uint8_t> isLabelled(count, 0);
  Region region(count, 0);
  // Label 0 belongs to the cell right of a component's first path.
  Array<int> starts;
  for (const PathUse& use : all.parting) {
    const int h = use.halfedge;
    starts.push_back(arrangement.cell(use.sign > 0 ? arrangement.twin[h] : h));
  }
  for (int cell = 0; cell < arrangement.cellCount(); ++cell) starts.push_back(cell);
  for (const int first : starts) {
    if (isLabelled[first] != 0) continue;
    isLabelled[first] = 1;
    Array<int> cells{first};
    for (int i = 0; i < cells.count(); ++i) {
      for (int k = all.start[cells[i]]; k < all.start[cells[i] + 1]; ++k) {
        const Step& step = all.steps[k];
        int label = labels[step.from] + step.change;
        if (rule == FillRule::kEvenOdd) label = ((label % 2) + 2) % 2;
        if (isLabelled[step.to] == 0) {
          isLabelled[step.to] = 1;
          labels[step.to] = label;
          cells.push_back(step.to);
        } else if (labels[step.to] != label) {
          refuseOpen(paths);
        }
      }
    }
    const bool isHere = inside && std::find(cells.begin(), cells.end(), *inside) != cells.end();
    chooseSide(arrangement, cells, labels, isHere ? inside : std::nullopt, region);
  }
  return region;
}

std::optional<int> cellBeside(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                              PathSide side) {
  // Edges inside the surface take precedence over edges of its boundary, beyond which no cell
  // exists.
  PathUse first{-1, 0, 0, 0};
  bool isInside = false;
  for (int i = 0; i < arrangement.uses.count();) {
    const EdgeCount count = countAt(arrangement, paths, i);
    const PathUse& use = count.earliest;
    if (use.path != paths.first || !parts(count, rule)) continue;
    const bool isHere = arrangement.twin[use.halfedge] >= 0;
    const bool isBetter = isHere == isInside ? use.order < first.order : isHere;
    if (first.halfedge >= 0 && !isBetter) continue;
    first = use;
    isInside = isHere;
  }
  int h = first.halfedge;
  if (h >= 0 && (first.sign > 0) != (side == PathSide::kLeft)) h = arrangement.twin[h];
  if (h < 0) return std::nullopt;
  return arrangement.cell(h);
}

Region enclosedBeside(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                      PathSide side) {
  return enclosed(arrangement, paths, rule, cellBeside(arrangement, paths, rule, side));
}

Region combined(const Region& a, const Region& b, Boolean how) {
  Region result(a.size(), 0);
  for (int c = 0; c < a.count(); ++c) {
    const bool inA = a[c] != 0;
    const bool inB = b[c] != 0;
    bool isIn = false;
    switch (how) {
      case Boolean::kUnion:
        isIn = inA || inB;
        break;
      case Boolean::kIntersection:
        isIn = inA && inB;
        break;
      case Boolean::kDifference:
        isIn = inA && !inB;
        break;
      case Boolean::kExclusion:
        isIn = inA != inB;
        break;
    }
    result[c] = isIn ? 1 : 0;
  }
  return result;
}

double areaOf(const Arrangement& arrangement, const Region& region) {
  double area = 0;
  for (int c = 0; c < region.count(); ++c) {
    if (region[c] != 0) area += arrangement.cellArea[c];
  }
  return area;
}

namespace {

bool isBorder(const Arrangement& all, const Region& region, int h) {
  return region[all.cell(h)] != 0 && (all.twin[h] < 0 || region[all.cell(all.twin[h])] == 0);
}

/// The next half-edge of a region's boundary after h: the first one on a turn around the head of h,
/// through the region.
int nextBorder(const Arrangement& all, const Region& region, int h) {
  int next = all.next[h];
  // This turns around the vertex at most once, since the reverse of h is on the boundary.
  while (!isBorder(all, region, next)) next = all.next[all.twin[next]];
  return next;
}

}  // namespace

Array<Array<int>> boundaryOf(const Arrangement& arrangement, const Region& region) {
  Array<uint8_t> isTaken(static_cast<size_t>(arrangement.halfedgeCount()), 0);
  Array<Array<int>> loops;
  for (int first = 0; first < arrangement.halfedgeCount(); ++first) {
    if (isTaken[first] != 0 || !isBorder(arrangement, region, first)) continue;
    Array<int> loop;
    for (int h = first; isTaken[h] == 0; h = nextBorder(arrangement, region, h)) {
      isTaken[h] = 1;
      loop.push_back(h);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

SurfacePath pathOf(const Geometry& geometry, const Arrangement& arrangement,
                   const Array<int>& loop) {
  const TriangleMesh& mesh = *geometry.mesh;
  SurfacePath path;
  path.lengths.push_back(0);
  for (const int h : loop) {
    path.points.push_back(
        vertexInFace(mesh, arrangement, arrangement.face(h), arrangement.tail[h]));
    path.lengths.push_back(path.lengths.back() + lengthOf(geometry, arrangement, h));
  }
  path.points.push_back(path.points.front());
  return path;
}

}  // namespace karcher
