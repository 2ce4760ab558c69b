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
/// the options and the point. With log vectors a value is made when it is first read: the solver
/// grows to the vertices that a search asks for, and no further.
class PointField {
 public:
  /// The surface must outlive the field. Fields may share the scratch memory of their path
  /// searches. Throws as `checkFieldOptions` does.
  PointField(Surface& surface, const FieldOptions& options,
             std::shared_ptr<FindPathWorkspace> paths = std::make_shared<FindPathWorkspace>());
  PointField(const PointField&) = delete;
  PointField& operator=(const PointField&) = delete;

  /// A near field is read only close to its point. Each of its values is that of one straight path
  /// between the point and the vertex, found on its own: by sight (sight.h), and where that finds
  /// none, by a path search (find_path.h). So a value depends on the surface, the point and the
  /// vertex alone, costs what lies between them, and takes no memory but its own. Beside hubs
  /// (hubs.h), where many values are read and each search would go round all of a hub, exact
  /// windows find all paths out of sight at once. Log vectors are taken as they are: so near they
  /// need no fit (estimators.h). With exact distances each path is
  /// compared with the shortest one by exact windows, at many times the cost. With graph distances,
  /// and the paper's method, a near field is like any other.
  void setPoint(const SurfacePoint& point, bool isNear = false);
  /// A field that is read only near a place, and of which only distances up to `most` are wanted:
  /// with windows it costs the region between the point and the place, not all that is as near as
  /// the place is. Values of longer distances are upper bounds.
  void setPointFor(const SurfacePoint& point, const SurfacePoint& place, double most);
  const SurfacePoint& point() const { return point_; }
  bool isNear() const { return isNear_; }

  /// Whether the value of a near field at a vertex is that of a path by sight.
  bool sees(int vertex) const {
    return sightFrom(surface_.geometry(), sights_, vertex).has_value();
  }

  /// Gives back the memory of a whole field's solver. Values that were read stay; the next one that
  /// was not starts the solver anew, and is the same.
  void rest();
  /// About how many bytes that is.
  int64_t bytesOfSolver() const;

  /// The order in which the set (field_set.h) saw its fields in use, from 1; 0 for never.
  int lastUse() const { return lastUse_; }
  void setLastUse(int use) { lastUse_ = use; }

  /// Reading a value on another component than the point's throws Error kUnreachable.
  ControlField& field() { return field_; }

 private:
  /// A solver's log vector, which the stencils of several vertices read.
  struct LogEntry {
    Vec2 vector = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());  ///< until it is known
  };

  void makePaperField();
  void makeLogField(const std::optional<PathAim>& aim = std::nullopt);
  void startSolver(const std::optional<PathAim>& aim = std::nullopt);
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
  // These belong to near fields.
  SightSources sights_;
  std::shared_ptr<FindPathWorkspace> paths_;
  SurfacePath path_;
  std::unique_ptr<DistanceSolver> aroundHubs_;  ///< exact; made when a value beside a hub is read
  bool isAroundHubs_ = false;                   ///< whether it starts at the point
  // These estimate the log vectors of all other fields, and are made with the first of them.
  Estimator estimator_ = Estimator::kLinear1;
  std::unique_ptr<DistanceSolver> solver_;
  bool isAimed_ = false;
  bool hasMidpoints_ = false;
  StencilTable* stencils_ = nullptr;
  std::optional<PagedArray<LogEntry, 4>> logVectors_;
};

/// The fields of points, as a blend takes them.
Array<ControlField*> controlFields(const Array<PointField*>& points);

}  // namespace karcher
