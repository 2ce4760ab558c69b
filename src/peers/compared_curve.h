#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "curves/trace/segment.h"
#include "peers/affine_heat.h"
#include "peers/descent.h"
#include "peers/log_map_mean.h"
#include "peers/weighted_averages.h"

/// Curves by every compared method, including our own and the paper's, in the same steps: prepare
/// the mesh, trace a curve, move a point. All use the same weights, and with the same `Seeds` they
/// start their searches by the same rule, so that times and results are comparable. The paper's
/// method and ours restart after failures (`findRestarts`), as in the engine.
namespace karcher {

enum class ComparedMethod {
  kFields,            ///< Mancinelli and Puppo's method, or ours (FieldOptions)
  kVectorHeat,        ///< the method of vector_heat.h
  kAffineHeat,        ///< the method of affine_heat.h
  kWeightedAverages,  ///< the method of weighted_averages.h
  kDescent,           ///< the method of descent.h, for two points only
};

/// The starts of a curve's searches.
enum class Seeds {
  /// The starts of the engine (traceSegment): searches for the ends of a segment start at the
  /// control point of the largest weight, searches for other samples at the last sample that
  /// converged.
  kHeaviest,
  /// The starts of the program of the paper's authors. Samples start at the geodesic de Boor point
  /// (repeatedAverage) until a search finds a center. After that, the samples of all segments start
  /// at the last center. There are no restarts.
  kAuthors,
};

struct ComparedOptions {
  ComparedMethod method = ComparedMethod::kFields;
  FieldOptions field;  ///< the options of kFields
  Seeds seeds = Seeds::kHeaviest;
  /// for the heat methods, whether to use the intrinsic Delaunay triangulation
  bool delaunay = false;
  AffineVariant variant = AffineVariant::kLocal;
  EmbeddingOptions embedding;  ///< the options of kWeightedAverages
  /// the solver of landmarks' distances, kFast or kExact
  Solver landmarkDistances = Solver::kFast;
  /// A function that the method calls before the distances of each landmark, and that may throw to
  /// cancel.
  std::function<void(int landmarks)> progress;
  std::function<double()> clock;  ///< the clock of log maps (LogMapMeanOptions)
};

/// The data that a method computes once for a mesh and all curves on it.
class PreparedMethod {
 public:
  /// The surface must outlive the method. Some methods throw Error: kNoEmbedding, kDegenerateFace,
  /// kUnreachable, kBadArgument.
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

/// Segment j has a sample for each row of the table: the center of mass of the control points
/// first[j] to first[j] + table.points - 1, with the row's weights.
struct ComparedPlan {
  Array<SurfacePoint> points;
  Array<int> first;
  WeightTable table;
};

class ComparedCurve {
 public:
  /// The method must outlive the curve. Throws Error: kBadIndex (a segment whose points do not
  /// exist), kBadWeights (a row that does not sum to 1), kUnreachable (several components),
  /// kBadArgument (descent of more than two points).
  ComparedCurve(PreparedMethod& method, ComparedPlan plan);

  /// Replaces a control point, whose segments then need a new trace. Throws Error kBadIndex.
  void movePoint(int i, const SurfacePoint& point);

  /// Sets the start of searches that would otherwise start at a control point or a de Boor point
  /// (`Seeds`).
  void startAt(const SurfacePoint& start) { start_ = start; }

  /// Does the next step: the field of one point, or up to `samples` samples of a segment. Returns
  /// true when all samples are done. Throws what the method throws.
  bool advance(int samples);

  int segmentCount() const { return segments_.count(); }
  int samplesLeft() const;
  /// The number of samples that the method's own authors would not accept. For the heat methods,
  /// these samples miss the tolerance of the authors' library (LogMapMean::metLibraryRule); for
  /// other methods, they did not converge.
  int lostByOwnRule() const;
  /// The mean of the heat methods; null for others.
  const LogMapMean* logMaps() const { return mean_.get(); }
  const Array<CurveSample>& samples(int segment) const { return segments_[segment]; }

 private:
  void check() const;
  bool makeNextField();
  void traceOn(int segment, int samples);
  SearchEnd center(int segment, Weights weights, const SurfacePoint& start);
  SearchEnd centerAgain(int segment, Weights weights, bool isEnd, SearchEnd found);
  bool isLostByOwnRule(const SearchEnd& found) const;
  SurfacePoint startOf(int segment, int sample) const;
  bool needsSeed(bool isEnd) const;

  PreparedMethod& method_;
  ComparedPlan plan_;
  std::optional<SurfacePoint> start_;
  Array<Array<CurveSample>> segments_;  ///< the traced part of the segments
  Array<int> lostByOwnRule_;            ///< the number of lost samples of each segment
  Array<uint8_t> moved_;                ///< the points whose fields are missing
  SurfacePoint last_;                   ///< the start of the next search
  bool hasFound_ = false;               ///< whether a search converged since the last move
  Array<std::unique_ptr<PointField>> fields_;
  std::optional<FieldBlend> blend_;  ///< the blend of the current segment
  std::unique_ptr<LogMapMean> mean_;
  DescentPath path_;
};

}  // namespace karcher
