#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "curves/trace/segment.h"
#include "peers/affine_heat.h"
#include "peers/descent.h"
#include "peers/log_map_mean.h"
#include "peers/weighted_averages.h"

/// Curves by every method that is compared, our own and the paper's among them, behind the same
/// steps: prepare the mesh, trace a curve, move a point. All take the same weights and start each
/// search at the same points (`Seeds`), so that times and results can be set side by side. The
/// paper's method and ours start again where they fail (`restarts`), as they do in the engine.
namespace karcher {

enum class ComparedMethod {
  kFields,            ///< Mancinelli and Puppo's method, or ours (FieldOptions)
  kVectorHeat,        ///< vector_heat.h
  kAffineHeat,        ///< affine_heat.h
  kWeightedAverages,  ///< weighted_averages.h
  kDescent,           ///< descent.h: two points only
};

/// Where the searches of a curve start.
enum class Seeds {
  /// As the engine's (traceSegment): both ends of a segment at the control point of the largest
  /// weight, other samples at the last one that converged.
  kHeaviest,
  /// As in the program of the paper's authors: the first sample at the geodesic de Boor point
  /// (repeatedAverage), as are those after it until one is found; then each at the last one that
  /// was, through all segments, and never again.
  kAuthors,
};

struct ComparedOptions {
  ComparedMethod method = ComparedMethod::kFields;
  FieldOptions field;  ///< of kFields
  Seeds seeds = Seeds::kHeaviest;
  bool delaunay = false;  ///< of the heat methods: on the intrinsic Delaunay triangulation
  AffineVariant variant = AffineVariant::kLocal;
  EmbeddingOptions embedding;                ///< of kWeightedAverages,
  Solver landmarkDistances = Solver::kFast;  ///< kFast or kExact
  /// Called before the distances of each landmark; may throw to give up.
  std::function<void(int landmarks)> progress;
};

/// What a method computes of a mesh once, for all curves on it.
class PreparedMethod {
 public:
  /// The surface must outlive the method. Throws Error as the method does: kNoEmbedding,
  /// kDegenerateFace, kUnreachable, kBadArgument.
  PreparedMethod(Surface& surface, const ComparedOptions& options);
  PreparedMethod(const PreparedMethod&) = delete;
  PreparedMethod& operator=(const PreparedMethod&) = delete;

  Surface& surface() { return surface_; }
  const ComparedOptions& options() const { return options_; }
  LogMapFromVertex logMaps() const;
  const WeightedAverages& averages() const { return *averages_; }

 private:
  void factorise();
  void embed();

  Surface& surface_;
  ComparedOptions options_;
  std::unique_ptr<HeatOperators> operators_;
  std::unique_ptr<WeightedAverages> averages_;
};

/// Segment j is the center of mass of the control points first[j] to first[j] + table.points - 1,
/// with a sample for each row of the table.
struct ComparedPlan {
  Array<SurfacePoint> points;
  Array<int> first;
  WeightTable table;
};

class ComparedCurve {
 public:
  /// The method must outlive the curve. Throws Error: kBadIndex (a segment without points),
  /// kBadWeights (a row that does not sum to 1), kUnreachable (several components), kBadArgument
  /// (descent of more than two points).
  ComparedCurve(PreparedMethod& method, ComparedPlan plan);

  /// Replaces a control point: its segments are to be traced again. Throws Error kBadIndex.
  void movePoint(int i, const SurfacePoint& point);

  /// Where the searches for a segment's ends start, instead of at the control point of the largest
  /// weight.
  void startAt(const SurfacePoint& start) { start_ = start; }

  /// The next step of what is left: the field of one point, or up to `samples` samples of a
  /// segment. True when nothing is left. Throws Error as the method does.
  bool advance(int samples);

  int segmentCount() const { return segments_.count(); }
  int samplesLeft() const;
  /// Samples that a method's own authors would not have accepted either: for the heat methods those
  /// beyond their library's tolerance (LogMapMean::metLibraryRule), for others those that did not
  /// converge.
  int lostByOwnRule() const;
  /// Of the heat methods; null for others.
  const LogMapMean* logMaps() const { return mean_.get(); }
  const Array<CurveSample>& samples(int segment) const { return segments_[segment]; }

 private:
  void check() const;
  bool makeNextField();
  void traceOn(int segment, int samples);
  CenterOfMass center(int segment, Weights weights, const SurfacePoint& start);
  CenterOfMass centerAgain(int segment, Weights weights, bool isEnd, CenterOfMass found);
  bool isLostByOwnRule(const CenterOfMass& found) const;
  SurfacePoint startOf(int segment, int sample) const;
  bool needsSeed(bool isEnd) const;

  PreparedMethod& method_;
  ComparedPlan plan_;
  std::optional<SurfacePoint> start_;
  Array<Array<CurveSample>> segments_;  ///< as far as they are traced
  Array<int> lostByOwnRule_;            ///< a segment
  Array<uint8_t> moved_;                ///< points whose field is to be made
  SurfacePoint last_;                   ///< where the next search starts
  bool hasFound_ = false;               ///< whether that is a sample that converged
  Array<std::unique_ptr<PointField>> fields_;
  std::optional<FieldBlend> blend_;  ///< of the segment that is traced
  std::unique_ptr<LogMapMean> mean_;
  DescentPath path_;
};

}  // namespace karcher
