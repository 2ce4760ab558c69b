#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <variant>

#include "distance/exact_distance.h"
#include "distance/fast_distance.h"
#include "distance/graph_distance.h"
#include "rcm/control_field.h"
#include "rcm/surface.h"

namespace karcher {

/// How the field of a control point is made.
enum class Method {
  kKarcher,  ///< log vectors: the directions in which shortest paths arrive
  kPaper,    ///< gradients of squared distances (Mancinelli, Puppo, Eq. 3)
};

/// How distances are found, and with log vectors which estimator (estimators.h) smooths them.
enum class Solver {
  kFast,   ///< virtual sources; kLinear1
  kExact,  ///< windows; kQuadratic2, and log vectors at the middles of edges as well
  kGraph,  ///< arcs of the k-ring graph; kLinear1
};

struct FieldOptions {
  Method method = Method::kKarcher;
  Solver solver = Solver::kFast;
  int rings = 6;  ///< of the graph, 1 to 10
};

/// Throws Error kBadArgument for a combination that does not exist.
void checkFieldOptions(const FieldOptions& options);

/// The solver of some field options (distance_solver.h).
using AnyDistanceSolver =
    std::variant<std::unique_ptr<FastDistance>, std::unique_ptr<ExactDistance>,
                 std::unique_ptr<GraphDistance>>;

/// A control point with its solver and its field. The field's values depend on the surface, the
/// options and the point alone. With log vectors they are made as they are read: the solver grows
/// to the vertices that a search asks for, and no further.
class PointField {
 public:
  /// The surface must outlive the field.
  PointField(Surface& surface, const FieldOptions& options);
  PointField(const PointField&) = delete;
  PointField& operator=(const PointField&) = delete;

  void setPoint(const SurfacePoint& point);
  const SurfacePoint& point() const { return point_; }
  ControlField& field() { return field_; }

 private:
  void makePaperField();
  void makeLogField();
  template <class DistanceSolver>
  FieldValue estimate(DistanceSolver& solver, const Stencil& stencil, int vertex);
  Vec2 estimateMiddle(ExactDistance& solver, int h);
  template <class DistanceSolver>
  void growTo(DistanceSolver& solver, int vertex) const;
  template <class DistanceSolver>
  const Vec2& logVectorAt(DistanceSolver& solver, int vertex);

  Surface& surface_;
  FieldOptions options_;
  SurfacePoint point_;
  Vec3 position_ = Vec3::Zero();
  ControlField field_;
  /// A solver's log vector, which the stencils of several vertices read.
  struct LogEntry {
    Vec2 vector = Vec2::Constant(std::numeric_limits<double>::quiet_NaN());  ///< until it is known
  };

  /// Kept for log vectors, which are made as they are read.
  std::optional<AnyDistanceSolver> solver_;
  PagedArray<LogEntry, 6> logVectors_;
  Array<double> squaredDistances_;
  Array<Vec2> gradients_;
};

/// The fields of points, as a blend takes them.
Array<ControlField*> controlFields(const Array<PointField*>& points);

/// The vertices within `radius` of a field's point, by the field: what a benchmark then reads.
Array<int> verticesWithin(Surface& surface, PointField& field, double radius);

/// A field from a caller's own distances, one a vertex, by the paper's gradient (Eq. 3). The result
/// holds all it needs but the surface's frames. Throws Error kBadArgument (not one a vertex) or
/// kNotFinite (NaN or negative).
ControlField fieldFromDistances(Surface& surface, const Array<double>& distances);

}  // namespace karcher
