#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "distance/find_path.h"
#include "distance/paged_array.h"
#include "distance/sight.h"
#include "rcm/control_field.h"
#include "rcm/field_options.h"

namespace karcher {

/// A control point with its solver and its field. The field's values depend only on the surface,
/// the options and the point. With log vectors the first read of a value computes it, and the
/// solver grows only to the vertices that searches need.
class PointField {
 public:
  /// The surface must outlive the field. Fields may share the scratch memory of their path
  /// searches. Throws as `checkFieldOptions` does.
  PointField(Surface& surface, const FieldOptions& options,
             std::shared_ptr<FindPathWorkspace> paths = std::make_shared<FindPathWorkspace>());
  PointField(const PointField&) = delete;
  PointField& operator=(const PointField&) = delete;

  /// Moves the field to a point. A near field is for reads close to its point. For each vertex, a
  /// search finds one straight path to the point: by sight (sight.h) or else by find_path.h. So a
  /// value depends only on the surface, the point and the vertex. It costs only the work between
  /// the point and the vertex, and needs no memory of a solver.
  ///
  /// Beside hubs (hubs.h) callers read many values, and each search would go round the whole hub.
  /// So there a single search by exact windows finds all paths that are not by sight. The log
  /// vectors of a near field need no fit (estimators.h). With exact distances the search compares
  /// each path with the shortest path by exact windows, which takes many times longer. With graph
  /// distances, and with the paper's method, a near field is like any other.
  void setPoint(const SurfacePoint& point, bool isNear = false);
  /// Moves the field to a point, for callers that read the field only near `place` and for
  /// distances up to `most`. Windows then cover only the region between the point and the place,
  /// instead of the whole disk up to the place. Longer distances are upper bounds.
  void setPointFor(const SurfacePoint& point, const SurfacePoint& place, double most);
  const SurfacePoint& point() const { return point_; }
  bool isNear() const { return isNear_; }

  /// Whether a near field takes its value at a vertex from a path by sight.
  bool sees(int vertex) const {
    return sightFrom(surface_.geometry(), sights_, vertex).has_value();
  }

  /// Releases the memory of a whole field's solver, but keeps the values read so far. The next read
  /// of another value starts the solver anew, with the same result.
  void rest();
  /// The approximate memory of a whole field's solver, in bytes; 0 while it rests.
  int64_t bytesOfSolver() const;

  /// The number of the field's last use. The field's set (field_set.h) counts uses from 1; 0 means
  /// never used.
  int lastUse() const { return lastUse_; }
  void setLastUse(int use) { lastUse_ = use; }

  /// The field. A read on another component than the point's throws Error kUnreachable.
  ControlField& field() { return field_; }

 private:
  /// A solver's log vector, which the stencils of several vertices read.
  struct LogEntry {
    /// NaN until it is known
    Vec2 vector = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  };

  void makePaperField();
  void makeLogField(const std::optional<PathAim>& aim = std::nullopt);
  void startSolver(const std::optional<PathAim>& aim = std::nullopt);
  template <class Work>
  auto restIfThrown(const Work& work);
  void makeNearField();
  FieldValue nearValue(int vertex);
  FieldValue valueBesideHub(int vertex);
  FieldValue estimate(int vertex);
  Vec2 estimateMidpoint(int halfedge);
  double distanceAt(int vertex);
  PathAim aimAt(const SurfacePoint& place, double most) const;
  const Vec2& logVectorAt(int vertex);

  Surface& surface_;
  FieldOptions options_;
  SurfacePoint point_;
  bool isNear_ = false;
  int lastUse_ = 0;
  ControlField field_;
  // The following members, up to `isAroundHubs_`, belong to near fields.
  SightSources sights_;
  std::shared_ptr<FindPathWorkspace> paths_;
  SurfacePath path_;
  /// the exact solver; the first read beside a hub creates it
  std::unique_ptr<DistanceSolver> aroundHubs_;
  bool isAroundHubs_ = false;  ///< whether the source of aroundHubs_ is the point
  // The following members estimate the log vectors of fields that are not near. The first such
  // field creates them.
  Estimator estimator_ = Estimator::kLinear1;
  std::unique_ptr<DistanceSolver> solver_;
  bool isAimed_ = false;
  bool hasMidpoints_ = false;
  StencilTable* stencils_ = nullptr;
  std::optional<PagedArray<LogEntry, 4>> logVectors_;
};

/// The fields of points, as pointers for a FieldBlend.
Array<ControlField*> controlFields(const Array<PointField*>& points);

}  // namespace karcher
