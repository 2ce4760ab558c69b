#include "peers/embedding.h"

#include <algorithm>
#include <string>

#include "mesh/error.h"
#include "peers/heat_operators.h"
#include "peers/multidimensional_scaling.h"

namespace karcher {
namespace {

using Positions = Eigen::Matrix<double, Eigen::Dynamic, kEmbeddingDimensions>;

/// Landmarks with their distances from one another.
class Landmarks {
 public:
  Landmarks(int vertexCount, const DistancesFromVertex& distancesFrom)
      : distancesFrom_(distancesFrom), nearest_(static_cast<size_t>(vertexCount), kInfinity) {}

  int count() const { return vertices_.count(); }
  int vertex(int i) const { return vertices_[i]; }
  /// The distance between landmark i and an earlier one.
  double distance(int i, int earlier) const { return distances_[i][earlier]; }
  bool contains(int v) const { return nearest_[v] == 0; }

  void add(int v) {
    const Array<double> distances = distancesFrom_(v);
    check(v, distances);
    Array<double>& row = distances_.emplace_back();
    for (const int w : vertices_) row.push_back(distances[w]);
    vertices_.push_back(v);
    for (int w = 0; w < nearest_.count(); ++w) nearest_[w] = std::min(nearest_[w], distances[w]);
    nearest_[v] = 0;
  }

  int farthestVertex() const {
    return static_cast<int>(std::max_element(nearest_.begin(), nearest_.end()) - nearest_.begin());
  }

 private:
  void check(int v, const Array<double>& distances) const {
    if (distances.size() != nearest_.size()) {
      throw Error(ErrorCode::kBadArgument, "there are " + std::to_string(distances.size()) +
                                               " distances for " + std::to_string(nearest_.size()) +
                                               " vertices");
    }
    for (int w = 0; w < distances.count(); ++w) {
      if (std::isfinite(distances[w])) continue;
      throw Error(ErrorCode::kUnreachable,
                  "an embedding needs a mesh in one piece: vertex " + std::to_string(w) +
                      " cannot be reached from vertex " + std::to_string(v));
    }
  }

  const DistancesFromVertex& distancesFrom_;
  Array<int> vertices_;
  Array<Array<double>> distances_;
  Array<double> nearest_;
};

Landmarks spreadLandmarks(int vertexCount, int wanted, const DistancesFromVertex& distancesFrom) {
  Landmarks landmarks(vertexCount, distancesFrom);
  landmarks.add(0);
  while (landmarks.count() < std::min(wanted, vertexCount)) {
    landmarks.add(landmarks.farthestVertex());
  }
  return landmarks;
}

Scaling scaleLandmarks(const Landmarks& landmarks) {
  Eigen::MatrixXd distances = Eigen::MatrixXd::Zero(landmarks.count(), landmarks.count());
  for (int i = 0; i < landmarks.count(); ++i) {
    for (int j = 0; j < i; ++j) distances(i, j) = distances(j, i) = landmarks.distance(i, j);
  }
  ScalingOptions options;
  options.dimensions = kEmbeddingDimensions;
  return scaleDistances(distances, options);
}

/// For given positions of the landmarks, the positions of all vertices that minimize the sum of
/// squared Laplacians.
class LeastSquaresMesh {
 public:
  explicit LeastSquaresMesh(const Geometry& geometry) {
    HeatOptions options;
    options.delaunay = true;
    const HeatOperators operators(geometry, options);
    const Eigen::SparseMatrix<double> lower = operators.laplacian();
    const Eigen::SparseMatrix<double> laplacian = lower.selfadjointView<Eigen::Lower>();
    Eigen::VectorXd inverseMass(laplacian.rows());
    for (int v = 0; v < laplacian.rows(); ++v) inverseMass[v] = 1 / operators.mass()[v];
    energy_ = laplacian * inverseMass.asDiagonal() * laplacian;
  }

  Positions fit(const Landmarks& landmarks, const Positions& places) const {
    const auto count = static_cast<int>(energy_.rows());
    Array<int> fixed(static_cast<size_t>(count), -1);
    for (int i = 0; i < landmarks.count(); ++i) fixed[landmarks.vertex(i)] = i;
    Array<int> row(fixed.size(), -1);
    int rows = 0;
    for (int v = 0; v < count; ++v) {
      if (fixed[v] < 0) row[v] = rows++;
    }
    Positions result(count, kEmbeddingDimensions);
    Columns<double, kEmbeddingDimensions> right =
        Columns<double, kEmbeddingDimensions>::Zero(rows, kEmbeddingDimensions);
    Array<Eigen::Triplet<double>> entries;
    for (int v = 0; v < count; ++v) {
      if (fixed[v] >= 0) result.row(v) = places.row(fixed[v]);
      for (Eigen::SparseMatrix<double>::InnerIterator entry(energy_, v); entry; ++entry) {
        const auto w = static_cast<int>(entry.row());
        if (row[w] < 0) continue;
        if (fixed[v] >= 0) {
          right.row(row[w]) -= entry.value() * places.row(fixed[v]);
        } else if (w >= v) {
          entries.emplace_back(row[w], row[v], entry.value());
        }
      }
    }
    if (rows == 0) return result;
    Eigen::SparseMatrix<double> matrix(rows, rows);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const SparseFactor<double> factor(matrix, "the least-squares mesh");
    right = factor.solve<kEmbeddingDimensions>(right);
    for (int v = 0; v < count; ++v) {
      if (row[v] >= 0) result.row(v) = right.row(row[v]);
    }
    return result;
  }

 private:
  Eigen::SparseMatrix<double> energy_;
};

/// The place of landmark i among the earlier landmarks, by majorization as in `scaleDistances`. The
/// iteration starts at `place`, the landmark's place in the least-squares mesh.
EmbeddedPoint placeAmong(const Landmarks& landmarks, int i, const Positions& places,
                         EmbeddedPoint place) {
  constexpr int kIterations = 50;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    EmbeddedPoint sum = EmbeddedPoint::Zero();
    double weights = 0;
    for (int j = 0; j < i; ++j) {
      const double wanted = landmarks.distance(i, j);
      const EmbeddedPoint away = place - places.row(j).transpose();
      const double distance = away.norm();
      const double weight = 1 / (wanted * wanted);
      sum += weight * (place - away);
      if (distance > 0) sum += weight * wanted / distance * away;
      weights += weight;
    }
    place = sum / weights;
  }
  return place;
}

Array<int> foldedFaces(const TriangleMesh& mesh, const Embedding& embedding) {
  Array<int> folded;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    if (isFolded(mesh, embedding.positions, embedding.planes, f)) folded.push_back(f);
  }
  return folded;
}

/// New landmarks: one corner of each folded face, and at most kMostAtOnce. Omits faces that share a
/// corner with an earlier one.
Array<int> newLandmarks(const TriangleMesh& mesh, const Array<int>& folded,
                        const Landmarks& landmarks) {
  constexpr int kMostAtOnce = 100;
  Array<uint8_t> taken(mesh.positions.size(), 0);
  Array<int> chosen;
  for (const int f : folded) {
    if (chosen.count() == kMostAtOnce) break;
    const Triangle& face = mesh.faces[f];
    if (taken[face[0]] || taken[face[1]] || taken[face[2]]) continue;
    for (const int v : face) {
      if (landmarks.contains(v)) continue;
      chosen.push_back(v);
      break;
    }
    for (const int v : face) taken[v] = 1;
  }
  return chosen;
}

void setPositions(const Geometry& geometry, const Positions& positions, Embedding& embedding) {
  embedding.positions.clear();
  for (int v = 0; v < positions.rows(); ++v) {
    embedding.positions.emplace_back(positions.row(v).transpose());
  }
  embedding.planes = tangentPlanes(geometry, embedding.positions);
}

void reject(const std::string& why) {
  throw Error(ErrorCode::kNoEmbedding,
              "no acceptable embedding of the mesh in 8 dimensions was found: " + why);
}

}  // namespace

Embedding embedSurface(const Geometry& geometry, const DistancesFromVertex& distancesFrom,
                       const EmbeddingOptions& options) {
  if (options.landmarks < 4) {
    throw Error(ErrorCode::kBadArgument, "an embedding needs at least 4 landmarks, not " +
                                             std::to_string(options.landmarks));
  }
  const TriangleMesh& mesh = *geometry.mesh;
  Landmarks landmarks = spreadLandmarks(mesh.vertexCount(), options.landmarks, distancesFrom);
  const Scaling scaling = scaleLandmarks(landmarks);
  Embedding embedding;
  embedding.stress = scaling.stress;
  if (embedding.stress > options.mostStress) {
    reject("distances between landmarks are off by " + std::to_string(embedding.stress) +
           " of their length (root mean square), more than " + std::to_string(options.mostStress));
  }
  Positions places = scaling.positions;
  const LeastSquaresMesh smooth(geometry);
  Positions positions = smooth.fit(landmarks, places);
  setPositions(geometry, positions, embedding);
  Array<int> folded = foldedFaces(mesh, embedding);
  for (int round = 0; round < options.mostRefinements && !folded.empty(); ++round) {
    const Array<int> added = newLandmarks(mesh, folded, landmarks);
    if (added.empty()) break;
    for (const int v : added) {
      landmarks.add(v);
      const int i = landmarks.count() - 1;
      places.conservativeResize(i + 1, Eigen::NoChange);
      places.row(i) = placeAmong(landmarks, i, places, positions.row(v).transpose()).transpose();
    }
    positions = smooth.fit(landmarks, places);
    setPositions(geometry, positions, embedding);
    folded = foldedFaces(mesh, embedding);
  }
  embedding.landmarks = landmarks.count();
  embedding.foldedFaces = folded.count();
  if (embedding.foldedFaces > options.mostFolded * mesh.faceCount()) {
    reject(std::to_string(embedding.foldedFaces) + " of its " + std::to_string(mesh.faceCount()) +
           " faces are folded over");
  }
  return embedding;
}

}  // namespace karcher
