#pragma once

#include <memory>
#include <string>
#include <utility>

#include "bindings/wire.h"
#include "mesh/face_tree.h"
#include "rcm/mean.h"

namespace karcher::bindings {

/// A mesh that JavaScript owns.
class MeshHandle {
 public:
  explicit MeshHandle(ImportedMesh imported);
  MeshHandle(const MeshHandle&) = delete;
  MeshHandle& operator=(const MeshHandle&) = delete;

  Surface& surface() { return surface_; }
  const TriangleMesh& mesh() const { return surface_.mesh(); }
  const Geometry& geometry() const { return surface_.geometry(); }
  const Numbering& numbering() const { return numbering_; }
  /// The field sets of the mesh's curves and centers of mass.
  const std::shared_ptr<FieldSets>& fieldSets() const { return fieldSets_; }

  /// Keeps the marks of the mesh's OBJ file.
  void setMarks(ObjMarks marks) { marks_ = std::move(marks); }
  /// {parts, partOf, materials, materialOf, colors, notRead}, as in types.ts. Only a mesh from an
  /// OBJ file has parts.
  val marks() const;

  /// Sets the curvature bound of the smooth surface that the mesh approximates.
  void setSmooth(const std::optional<CurvatureBound>& bound) { smooth_ = bound; }

  val info();
  int inputVertices() const { return numbering_.engineVertex.count(); }
  val positions() const;
  val triangles() const;
  /// {areFaces, boundary}, as `EngineKept` of karcher-engine.d.mts describes them.
  val kept() const;
  /// {corners, copies, parts}, as `EngineFans` of karcher-engine.d.mts describes them.
  val fans() const;
  /// The mesh refined by `levels` steps of Loop subdivision.
  std::unique_ptr<MeshHandle> subdivided(int levels) const;
  /// The same points on the refined mesh. Each point keeps its barycentric place in its original
  /// triangle, which the refinement has divided.
  val carried(const val& points, int levels) const;

  val checkedPoint(const val& point) const;
  val position(const val& point) const;
  /// The positions of points: x, y and z of each point, one after the other.
  val positionsOf(const val& points) const;
  /// The normal of the point's face.
  val normal(const val& point) const;
  /// The unit vectors along the first edge of the point's face and at right angles to it, and the
  /// normal.
  val frame(const val& point) const;
  /// {faceOf, turnedOver}: the face in whose plane each vertex has its vectors, -1 for a dropped
  /// vertex; and 1 for each face that the import turned over.
  val planes() const;
  /// {point, distance}; `place` is a Float64Array of three numbers.
  val nearestPoint(const val& place);
  /// {end, remaining, stop, path}; `direction` is a Float64Array of three numbers, in space.
  val straightest(const val& from, const val& direction, double length) const;
  val shortestPath(const val& from, const val& to) const;

  // Vectors and directions are in space, three numbers each. A zero vector stands for no direction.
  /// {vectors, directions}
  val logMap(const val& from, const val& points, const val& directions) const;
  /// The log vectors of all vertices of the caller; NaN for vertices that are unreachable or beyond
  /// the radius.
  val logMapOfVertices(const val& from, double radius);
  /// {points, directions, remaining}
  val expMap(const val& from, const val& vectors, const val& directions) const;
  val mirror(const val& line, const val& points, const val& directions) const;
  /// The vectors after transport along the log map's path to its end.
  val transport(const val& from, const val& to, const val& vectors) const;
  /// The vectors after transport along a line, from its first point to its last.
  val transportAlong(const val& line, const val& vectors) const;
  /// {points, lengths}: the points of a line at the given lengths from its start, then `count`
  /// evenly spaced points. `length` is the line's length; 0 stands for the sum of its chords.
  val pointsAlong(const val& line, const val& lengths, double length, int count) const;

  // `field` is an argument for `fieldOptionsFromJs`.
  /// The distance of each vertex from the nearest of the points `from`; NaN for vertices that are
  /// unreachable or beyond the radius.
  val distance(const val& from, const val& field, double radius);
  bool hasRingGraph(int rings) const { return surface_.hasRingGraph(rings); }
  /// Builds the data that fields with these options share. They include the ring graph of the
  /// solver `graph`, unless a GraphBuilderHandle has already built it step by step.
  void prepareFields(const val& field);
  /// `start` is a point, or an empty array if the engine is to choose the start. The result has a
  /// `certificate` if `certifies` is true.
  val centerOfMass(const val& points, const val& weights, const val& start, bool normalize,
                   bool looksForOthers, bool certifies, const val& field);
  /// {point, position, energy, status}: arrays with the values of one row of weights after the
  /// other.
  val centersOfMass(const val& points, const val& rows, const val& start, bool normalize,
                    bool isChecked, const val& field);
  /// {weights, isMinimum}; `given` is empty for equal weights.
  val weightsOf(const val& point, const val& points, const val& given, bool nonNegative,
                const val& field);
  /// `distances` holds one field after another. Each field has a distance for each vertex of the
  /// caller.
  val centerOfMassOfDistances(const val& distances, const val& weights, const val& start,
                              bool normalize);
  val circle(const val& center, double radius, const val& arcs, int samples, int levels,
             const val& field, double tolerance);
  /// `direction` is as for `straightest`.
  val ellipse(const val& center, double along, double across, const val& direction, const val& arcs,
              int samples, int levels, const val& field);
  /// A list of paths (path.h): exact isolines, or piecewise linear isolines of the solver's
  /// distances.
  val isolines(const val& center, double radius, bool exact, const val& field);
  /// A list of paths. `side` is 1 for the left, -1 for the right, 0 for both; `corners` is the
  /// number of a CornerShape.
  val offset(const val& outlines, const val& distances, int side, int corners,
             double miterLimit) const;
  /// The distances of points from the nearest of the outlines; NaN for unreachable points.
  val distanceFromPaths(const val& outlines, const val& points) const;
  /// A list of {area, perimeter, boundary, share, triangles, sides}. If `combine` is "none", the
  /// list has such an object for each shape, with `isLeft`; else it has a single object. `counts`
  /// has the number of outlines of each shape. `insides` has an array for each shape. The array
  /// holds the four numbers of a point inside, or one number for the inner side of the first
  /// outline (1 for the left, 0 for the right), or nothing.
  val regions(const val& outlines, const val& counts, const val& insides, const std::string& rule,
              const std::string& combine) const;
  /// A list of {positions, triangles, faces}, one for each cell. `report` takes the completed
  /// fraction and returns whether to continue.
  val cut(const val& outlines, const val& report) const;

 private:
  Vec2 directionInFace(int face, const val& direction) const;
  /// The distance of each vertex of the engine, or kInfinity for unreachable vertices. Distances
  /// beyond the radius may not be final.
  Array<double> distancesFromPoints(const Array<SurfacePoint>& sources, const val& field,
                                    double radius);
  /// For each vertex of the caller, the engine's vertex there with the least of these distances; -1
  /// for a dropped vertex.
  Array<int> nearestVertices(const Array<double>& distances) const;
  MeanOptions meanOptions(const val& start, bool normalize) const;
  val meanToJs(const Mean& mean) const;
  Array<double> engineDistances(const Array<double>& distances, size_t field) const;

  Numbering numbering_;
  Array<Vec3> droppedPositions_;
  Array<Repair> repairs_;
  ObjMarks marks_;
  Surface surface_;
  std::optional<CurvatureBound> smooth_;
  std::optional<FaceTree> faceTree_;  ///< the tree, built on first use
  std::shared_ptr<FieldSets> fieldSets_;
  /// The set of the fields of the last center of mass.
  std::shared_ptr<FieldSet> fields_;
};

/// `bytes` is a Uint8Array with the content of an OBJ file. `parts` holds the numbers of the wanted
/// parts, or is null for all parts. `weld` is ImportOptions::weld.
std::unique_ptr<MeshHandle> meshFromObj(const val& bytes, const val& parts, bool repair,
                                        double weld);
/// `positions` is a Float64Array, `triangles` an Int32Array, with three numbers for each item.
std::unique_ptr<MeshHandle> meshFromArrays(const val& positions, const val& triangles, bool repair,
                                           double weld);
/// A mesh of polygons. `corners` has the vertices of one polygon after the other, `sizes` the
/// number of corners of each polygon.
std::unique_ptr<MeshHandle> meshFromPolygons(const val& positions, const val& corners,
                                             const val& sizes, bool repair, double weld);
/// A built-in shape, by its name in the JavaScript API.
std::unique_ptr<MeshHandle> builtInShape(const std::string& name, int triangles);

}  // namespace karcher::bindings
