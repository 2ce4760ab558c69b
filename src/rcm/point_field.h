#pragma once

#include <limits>
#include <memory>

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
  /// Solvers that no field uses at present.
  using SpareSolvers = Array<std::unique_ptr<DistanceSolver>>;

  /// The surface must outlive the field. Fields of the same surface and options may share spare
  /// solvers. Throws as `checkFieldOptions` does.
  PointField(Surface& surface, const FieldOptions& options,
             std::shared_ptr<SpareSolvers> spare = std::make_shared<SpareSolvers>());
  PointField(const PointField&) = delete;
  PointField& operator=(const PointField&) = delete;

  /// A box means that the point is near, and that the field is read only in the box. Values are
  /// then those of paths to the vertices that are straight, or bent at saddles, each found on its
  /// own (sight.h). Where none is
  /// found, the solver grows, and keeps to paths in the box wherever those outside change nothing.
  /// Log vectors are taken as they are: so near they need no fit (estimators.h). A vertex's value
  /// then depends on the box, too, but not on what was read before. A solver that cannot keep to a
  /// box ignores it.
  void setPoint(const SurfacePoint& point, const std::optional<OrientedBox>& box = std::nullopt);
  const SurfacePoint& point() const { return point_; }
  const std::optional<OrientedBox>& box() const { return box_; }

  /// Reading a value on another component than the point's throws Error kUnreachable.
  ControlField& field() { return field_; }

 private:
  /// A solver's log vector, which the stencils of several vertices read.
  struct LogEntry {
    Vec2 vector = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());  ///< until it is known
  };

  void makePaperField();
  void makeLogField();
  FieldValue estimate(int vertex);
  Vec2 estimateMidpoint(int halfedge);
  DistanceSolver& solverFor(int vertex);
  bool knows(DistanceSolver& solver, const OrientedBox& box, int vertex) const;
  DistanceSolver& made(std::unique_ptr<DistanceSolver>& solver,
                       const std::optional<OrientedBox>& box);
  double distanceAt(int vertex);
  const Vec2& logVectorAt(int vertex);

  Surface& surface_;
  FieldOptions options_;
  Estimator estimator_;
  SurfacePoint point_;
  ControlField field_;
  /// Kept for log vectors, which are made as they are read.
  std::unique_ptr<DistanceSolver> solver_;
  std::optional<OrientedBox> box_;
  bool isKept_ = false;     ///< the solver to the box
  bool isGrowing_ = false;  ///< the solver from the point
  SightSource sights_;      ///< the point, where the solver is kept
  /// For what lies outside the box or depends on that, kept to a wider one, and for what lies
  /// outside that or depends on that, going everywhere; taken when they are needed.
  std::unique_ptr<DistanceSolver> wide_;
  std::unique_ptr<DistanceSolver> whole_;
  std::shared_ptr<SpareSolvers> spare_;
  StencilTable* stencils_ = nullptr;
  PagedArray<LogEntry, 4> logVectors_;
  Array<double> squaredDistances_;
  Array<Vec2> gradients_;
};

/// The fields of points, as a blend takes them.
Array<ControlField*> controlFields(const Array<PointField*>& points);

/// A field from a caller's own distances, one a vertex, by the paper's gradient (Eq. 3). The result
/// holds all it needs but the surface's frames. Throws Error kBadArgument (not one a vertex) or
/// kNotFinite (NaN or negative).
ControlField fieldFromDistances(Surface& surface, const Array<double>& distances);

}  // namespace karcher
