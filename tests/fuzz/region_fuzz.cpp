#include "fuzz/region_fuzz.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <utility>

#include "fuzz/counted_sides.h"
#include "generators/gallery.h"
#include "generators/plane.h"
#include "generators/random_points.h"
#include "generators/region_drawings.h"
#include "generators/sphere.h"
#include "generators/torus.h"
#include "intrinsic/straightest.h"
#include "measures/gauss_bonnet.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "regions/region.h"

namespace karcher {
namespace {

constexpr int kPoints = 100;

/// The mesh without the faces around some vertices, no two of them neighbors.
TriangleSoup pierced(const TriangleMesh& mesh, int holes, uint64_t seed) {
  Random random(seed);
  Array<uint8_t> isNear(static_cast<size_t>(mesh.vertexCount()), 0);
  Array<uint8_t> isGone(static_cast<size_t>(mesh.faceCount()), 0);
  for (int found = 0, trial = 0; found < holes && trial < 1000; ++trial) {
    const int vertex = random.index(mesh.vertexCount());
    bool isFree = isNear[vertex] == 0 && mesh.onBoundary[vertex] == 0;
    for (const int h : outgoingHalfedges(mesh, vertex))
      isFree = isFree && isNear[mesh.head(h)] == 0;
    if (!isFree) continue;
    ++found;
    for (const int h : outgoingHalfedges(mesh, vertex)) {
      isGone[faceOf(h)] = 1;
      isNear[mesh.head(h)] = 1;
    }
  }
  TriangleSoup soup;
  soup.positions = mesh.positions;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    if (isGone[f] == 0) soup.triangles.push_back(mesh.faces[f]);
  }
  return soup;
}

class Drawings {
 public:
  Drawings(const RegionSurface& surface, Random& random)
      : surface_(surface), geometry_(surface.geometry), mesh_(surface.mesh), random_(random) {}

  Array<SurfacePath> paths;
  Array<uint8_t> isOpen;  ///< whether each path ends where there is no rim

  void draw() {
    const int count = 1 + random_.index(5);
    while (paths.count() < count) {
      const int kind = random_.index(10);
      if (kind < 4) {
        add(polygon(), false);
      } else if (kind == 4) {
        add(alongEdges(), false);
      } else if (kind == 5 && !paths.empty()) {
        add(withStretch(), false);
      } else if (kind == 6 && !paths.empty()) {
        add(copied(), isOpen.back() != 0);
      } else if (kind == 7 && !surface_.rim.empty()) {
        add(fromRimToRim(), false);
      } else if (kind == 8 && random_.index(3) == 0) {
        add(chain(geometry_, {randomPoint(mesh_, random_), randomPoint(mesh_, random_)}, false),
            true);
      } else if (kind == 9) {
        add(chain(geometry_, randomPlaces(3), true), false);
      }
    }
  }

 private:
  void add(SurfacePath path, bool open) {
    if (path.points.count() < 2) return;
    if (random_.index(4) == 0) reverse(path);
    paths.push_back(std::move(path));
    isOpen.push_back(open ? 1 : 0);
  }

  Array<SurfacePoint> randomPlaces(int count) {
    Array<SurfacePoint> points;
    while (points.count() < count) points.push_back(randomPlace(mesh_, random_));
    return points;
  }

  /// A place anywhere, or a point of a drawn path.
  SurfacePoint anyPlace() {
    if (paths.empty() || random_.index(3) > 0) return randomPlace(mesh_, random_);
    const Array<SurfacePoint>& points = paths[random_.index(paths.count())].points;
    return points[random_.index(points.count())];
  }

  SurfacePath polygon() {
    const SurfacePoint middle = anyPlace();
    // The size ranges from within a face to much of the surface.
    const double size = geometry_.diagonal * std::pow(10, random_.uniform(-2.5, -0.4));
    Array<SurfacePoint> points;
    const int corners = 3 + random_.index(5);
    const bool inOrder = random_.index(2) == 0;
    while (points.count() < corners) {
      const double turn =
          inOrder ? points.count() / static_cast<double>(corners) : random_.uniform();
      const Vec2 way = size * random_.uniform(0.3, 1) * unitVector(2 * kPi * turn);
      points.push_back(traceStraightest(geometry_, middle, way).path.end());
      if (random_.index(12) == 0) points.push_back(anyPlace());
      // At times the path repeats a stretch.
      if (random_.index(10) == 0) points.push_back(points[random_.index(points.count())]);
    }
    return chain(geometry_, points, true);
  }

  /// The boundary of some adjacent faces: along edges, and along the rim.
  SurfacePath alongEdges() {
    Array<uint8_t> isIn(static_cast<size_t>(mesh_.faceCount()), 0);
    Array<int> faces{random_.index(mesh_.faceCount())};
    isIn[faces[0]] = 1;
    const int count = 1 + random_.index(60);
    for (int i = 0; i < faces.count() && faces.count() < count; ++i) {
      for (int h = 3 * faces[i]; h < 3 * faces[i] + 3; ++h) {
        const int twin = mesh_.twin[h];
        if (twin < 0 || random_.index(4) == 0 || isIn[faceOf(twin)] != 0) continue;
        isIn[faceOf(twin)] = 1;
        faces.push_back(faceOf(twin));
      }
    }
    const auto isBorder = [&](int h) {
      return isIn[faceOf(h)] != 0 && (mesh_.twin[h] < 0 || isIn[faceOf(mesh_.twin[h])] == 0);
    };
    int first = -1;
    for (const int f : faces) {
      for (int h = 3 * f; h < 3 * f + 3; ++h) first = isBorder(h) ? h : first;
    }
    Array<SurfacePoint> points;
    int h = first;
    do {
      if (h < 0) return {};
      points.push_back(vertexPoint(mesh_, mesh_.tail(h)));
      h = next(h);
      while (!isBorder(h)) h = next(mesh_.twin[h]);
    } while (h != first);
    points.push_back(points.front());
    return pathThrough(mesh_, std::move(points));
  }

  /// A stretch of another path, closed in another way.
  SurfacePath withStretch() {
    const SurfacePath& other = paths[random_.index(paths.count())];
    SurfacePath path;
    appendPart(mesh_, other, random_.uniform() * other.length(), random_.uniform() * other.length(),
               path);
    const SurfacePath back =
        chain(geometry_, {path.points.back(), anyPlace(), path.points.front()}, false);
    Array<SurfacePoint> points = path.points;
    points.insert(points.end(), back.points.begin(), back.points.end());
    return pathThrough(mesh_, std::move(points));
  }

  /// The last path, moved by slightly less or more than the distance of merging.
  SurfacePath copied() {
    SurfacePath path = paths.back();
    const double size = kTogether * std::pow(10, random_.uniform(-6, 2));
    if (random_.index(3) == 0) return path;
    for (int i = 1; i < path.points.count() - 1; ++i) {
      SurfacePoint& point = path.points[i];
      if (locate(mesh_, point).simplex != Simplex::kFace) continue;
      Vec3 bary = point.bary;
      for (double& weight : bary) weight = std::max(0.0, weight + size * random_.uniform(-1, 1));
      point = clampedPoint(point.face, bary / bary.sum());
    }
    return path;
  }

  SurfacePath fromRimToRim() {
    const auto onRim = [&] {
      const double part = random_.index(4) == 0 ? 0 : random_.uniform();
      return edgePoint(surface_.rim[random_.index(surface_.rim.count())], part);
    };
    Array<SurfacePoint> points = randomPlaces(1 + random_.index(3));
    points.insert(points.begin(), onRim());
    points.push_back(onRim());
    return chain(geometry_, points, false);
  }

  const RegionSurface& surface_;
  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  Random& random_;
};

class Fuzz {
 public:
  Fuzz(const RegionSurface& surface, uint64_t seed, RegionTally& tally)
      : surface_(surface),
        geometry_(surface.geometry),
        mesh_(surface.mesh),
        seed_(seed),
        random_(seed),
        tally_(tally),
        drawings_(surface, random_) {}

  void run() {
    try {
      drawings_.draw();
      ++tally_.drawings;
      tally_.paths += drawings_.paths.count();
      all_ = arrange(geometry_, drawings_.paths);
      tally_.cells += all_.cellCount();
      checkCells();
      const CountedSides counted(geometry_, drawings_.paths, random_);
      placePoints(counted);
      for (int i = 0; i < drawings_.paths.count(); ++i) checkSet(counted, {i, 1});
      if (drawings_.paths.count() > 1) checkSet(counted, {0, drawings_.paths.count()});
      checkBooleans();
    } catch (const std::exception& error) {
      fault(error.what());
    }
  }

 private:
  struct Placed {
    SurfacePoint point;
    int cell;
    Array<int> labels;
  };

  void fault(const std::string& what) {
    std::ostringstream text;
    text << surface_.name << ", seed " << seed_ << ": " << what;
    tally_.faults.push_back(text.str());
  }

  void checkCells() {
    const double whole = surfaceArea(geometry_);
    double sum = 0;
    for (int c = 0; c < all_.cellCount(); ++c) {
      if (all_.cellArea[c] < -1e-13 * whole) fault("the area of a cell is negative");
      sum += all_.cellArea[c];
    }
    tally_.largestAreaError = std::max(tally_.largestAreaError, std::abs(sum - whole) / whole);
    if (std::abs(sum - whole) > 1e-10 * whole) fault("the areas of cells are not the surface's");
    const size_t cells = static_cast<size_t>(all_.cellCount());
    checkBonnet(Region(cells, 1));
    const int step = 1 + all_.cellCount() / 16;
    for (int c = random_.index(step); c < all_.cellCount(); c += step) {
      Region one(cells, 0);
      one[c] = 1;
      checkBonnet(one);
    }
  }

  void checkBonnet(const Region& region) {
    const GaussBonnet both = gaussBonnet(geometry_, all_, region);
    const double error = std::abs(both.curvature - 2 * kPi * both.euler);
    tally_.largestBonnetError = std::max(tally_.largestBonnetError, error);
    if (!(error <= 1e-9)) fault("curvature and turns of a region miss the theorem");
  }

  /// Places a third of the points in faces that paths cross.
  void placePoints(const CountedSides& counted) {
    for (int trial = 0; points_.count() < kPoints; ++trial) {
      if (trial == 100 * kPoints) return fault("points are all too near to paths");
      SurfacePoint point = randomPoint(mesh_, random_);
      if (points_.count() % 3 == 0) {
        const SurfacePath& path = drawings_.paths[random_.index(drawings_.paths.count())];
        point.face = path.points[random_.index(path.points.count())].face;
      }
      std::optional<Array<int>> labels = counted.labels(point);
      if (!labels) continue;
      const int cell = all_.cellOfPiece[pieceHolding(mesh_, all_, point)];
      points_.push_back({point, cell, std::move(*labels)});
    }
    tally_.points += kPoints;
  }

  std::optional<Region> regionOf(const PathRange& range, FillRule rule, std::optional<int> inside) {
    try {
      return enclosed(all_, range, rule, inside);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::kBadArgument) throw;
      return std::nullopt;
    }
  }

  void checkSet(const CountedSides& counted, const PathRange& range) {
    bool hasEnd = false;
    for (int i = range.first; i < range.first + range.count; ++i) {
      hasEnd = hasEnd || drawings_.isOpen[i] != 0;
    }
    for (const FillRule rule : {FillRule::kEvenOdd, FillRule::kNonZero}) {
      const bool byParity = rule == FillRule::kEvenOdd;
      const std::optional<Region> region = regionOf(range, rule, std::nullopt);
      if (!hasEnd && region.has_value() != counted.bound(range.first, range.count, byParity)) {
        fault("whether paths bound is not what ways round the surface say");
      }
      if (hasEnd && range.count == 1 && region) fault("a path that ends bounds");
      ++(region ? tally_.regions : tally_.unbounded);
      if (!region) continue;
      checkBonnet(*region);
      checkPoints(range, byParity, *region, nullptr);
      checkSides(range, rule);
      if (points_.empty()) continue;
      const Placed& inside = points_[random_.index(points_.count())];
      checkPoints(range, byParity, *regionOf(range, rule, inside.cell), &inside);
      regions_.push_back(*region);
    }
  }

  /// Checks that by parity the inside on one side is the outside on the other.
  void checkSides(const PathRange& range, FillRule rule) {
    const std::optional<int> cell = cellBeside(all_, range, rule, PathSide::kLeft);
    if (!cell || !cellBeside(all_, range, rule, PathSide::kRight)) return;
    const Region left = enclosedBeside(all_, range, rule, PathSide::kLeft);
    const Region right = enclosedBeside(all_, range, rule, PathSide::kRight);
    if (left[*cell] == 0) fault("what lies left is not inside");
    if (rule == FillRule::kNonZero) return;
    for (int c = 0; c < all_.cellCount(); ++c) {
      if (left[c] == right[c]) return fault("a cell is on both sides or on none");
    }
  }

  int labelOf(const Placed& placed, const PathRange& range, bool byParity) const {
    int label = 0;
    for (int i = range.first; i < range.first + range.count; ++i) label += placed.labels[i];
    return byParity ? label & 1 : label;
  }

  /// Checks that points outside have one label, and points inside have others.
  void checkPoints(const PathRange& range, bool byParity, const Region& region,
                   const Placed* inside) {
    std::optional<int> outside;
    for (const Placed& placed : points_) {
      if (region[placed.cell] != 0) continue;
      const int label = labelOf(placed, range, byParity);
      if (outside.value_or(label) != label) return fault("two points outside differ in crossings");
      outside = label;
    }
    for (const Placed& placed : points_) {
      if (region[placed.cell] == 0) continue;
      if (outside == labelOf(placed, range, byParity)) return fault("a point outside is inside");
    }
    if (inside != nullptr && region[inside->cell] == 0) fault("a point that is clicked is outside");
  }

  void checkBooleans() {
    if (regions_.count() < 2) return;
    const Region& a = regions_.front();
    const Region& b = regions_.back();
    const auto area = [&](Boolean how) {
      const Region region = combined(a, b, how);
      checkBonnet(region);
      return areaOf(all_, region);
    };
    const double both = area(Boolean::kIntersection);
    const double first = areaOf(all_, a);
    const double second = areaOf(all_, b);
    const double rounding = 1e-10 * surfaceArea(geometry_);
    if (std::abs(area(Boolean::kUnion) - (first + second - both)) > rounding ||
        std::abs(area(Boolean::kDifference) - (first - both)) > rounding ||
        std::abs(area(Boolean::kExclusion) - (first + second - 2 * both)) > rounding) {
      fault("areas of booleans do not fit");
    }
  }

  const RegionSurface& surface_;
  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  uint64_t seed_;
  Random random_;
  RegionTally& tally_;
  Drawings drawings_;
  Arrangement all_;
  Array<Placed> points_;
  Array<Region> regions_;
};

}  // namespace

RegionSurface::RegionSurface(std::string itsName, TriangleMesh itsMesh)
    : name(std::move(itsName)), mesh(std::move(itsMesh)), geometry(buildGeometry(mesh)) {
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    if (mesh.twin[h] < 0) rim.push_back(h);
  }
}

Array<std::unique_ptr<RegionSurface>> regionSurfaces() {
  Array<std::unique_ptr<RegionSurface>> surfaces;
  const auto add = [&](const std::string& name, const TriangleSoup& soup) {
    surfaces.push_back(std::make_unique<RegionSurface>(name, importMesh(soup).mesh));
  };
  const std::pair<const char*, TriangleSoup> closed[] = {
      {"icosahedron", icosphere(1)},
      {"even sphere", makeShape(Shape::kSphere, 500)},
      {"random sphere", randomSphere(500, 2)},
      {"torus", irregularTorus(500, 1, 4)},
      {"stretched torus", irregularTorus(600, 8, 5)},
      {"knot", makeShape(Shape::kKnot, 800)},
      {"plate with two holes", plateWithHoles(5, 3)},
      {"genus 3", makeShape(Shape::kGenus3, 800)},
      {"plate with three holes", plateWithHoles(7, 3)}};
  for (const auto& [name, soup] : closed) {
    add(name, soup);
    const TriangleMesh& mesh = surfaces.back()->mesh;
    for (const int holes : {1, 4}) {
      add(std::string(name) + " with " + std::to_string(holes) + " rims",
          pierced(mesh, holes, 10 + static_cast<uint64_t>(holes)));
    }
  }
  add("plane", tessellatedPlane(PlaneTessellation::kRandomDelaunay, 300, 3));
  add("grid", tessellatedPlane(PlaneTessellation::kRegularGrid, 200, 3));
  add("stretched plane", tessellatedPlane(PlaneTessellation::kStretchedSheared, 400, 3));
  add("sheet", makeShape(Shape::kOpenSheet, 600));
  return surfaces;
}

void fuzzRegions(const RegionSurface& surface, uint64_t seed, RegionTally& tally) {
  Fuzz(surface, seed, tally).run();
}

}  // namespace karcher
