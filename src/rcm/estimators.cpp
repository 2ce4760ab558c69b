#include "rcm/estimators.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "rcm/hubs.h"

namespace karcher {
namespace {

using Neighbour = StencilNeighbour;

/// Adds the transport along one edge, from `from` to the neighbour `vertex`. Does nothing if the
/// index of this neighbour is below `begin`, since such neighbours lie in finished rings. The
/// `place` and `rotation` of a neighbour are sums until `findRings` averages them.
void carry(Array<Neighbour>& ring, int begin, Array<int>& ways, const Neighbour& from, int vertex,
           double length, double directionThere, double directionBack) {
  const auto known = std::find_if(ring.begin(), ring.end(),
                                  [&](const Neighbour& n) { return n.vertex == vertex; });
  const int number = static_cast<int>(known - ring.begin());
  if (number < begin) return;
  if (known == ring.end()) {
    ring.push_back({vertex, Vec2::Zero(), Vec2::Zero()});
    ways.push_back(0);
  }
  const Vec2 step = length * unitVector(directionThere);
  const Vec2 turn = unitVector(directionThere + kPi - directionBack);
  ring[number].place += from.place + rotate(from.rotation, step);
  ring[number].rotation += rotate(from.rotation, turn);
  ++ways[number - begin];
}

/// Writes to `ring` the vertex itself and then its neighbours, ring by ring. A neighbour's place is
/// the mean of the transports along all edges from the previous ring, so that it does not depend on
/// the numbering of the mesh. Rings do not extend past a hub. (The estimate at a hub is its own log
/// vector.) Stencils through a hub would mix paths around all its sides, and have a total size that
/// grows with the square of the number of its edges.
void findRings(const Geometry& geometry, int vertex, int rings, Array<Neighbour>& ring,
               Array<int>& ways) {
  const TriangleMesh& mesh = *geometry.mesh;
  ring.clear();
  ring.push_back({vertex, Vec2::Zero(), Vec2(1, 0)});
  int begin = 0;
  for (int r = 0; r < rings; ++r) {
    const int end = ring.count();
    ways.clear();
    for (; begin < end; ++begin) {
      const Neighbour from = ring[begin];
      if (r > 0 && isHub(mesh, from.vertex)) continue;
      const double scale = geometry.angleScale[from.vertex];
      for (const int h : outgoingHalfedges(mesh, from.vertex)) {
        const int to = mesh.head(h);
        const int onward = next(h);
        carry(ring, end, ways, from, to, geometry.edgeLength[h], scale * geometry.cumulatedAngle[h],
              geometry.angleScale[to] *
                  (geometry.cumulatedAngle[onward] + geometry.cornerAngle[onward]));
        const int back = previous(h);
        if (mesh.twin[back] < 0) {
          const int last = mesh.tail(back);
          carry(ring, end, ways, from, last, geometry.edgeLength[back],
                scale * (geometry.cumulatedAngle[h] + geometry.cornerAngle[h]),
                geometry.angleScale[last] * geometry.cumulatedAngle[back]);
        }
      }
    }
    for (int i = end; i < ring.count(); ++i) {
      ring[i].place /= ways[i - end];
      ring[i].rotation.normalize();
    }
  }
}

/// The share of the vertex's own log vector in an estimate (Stencil). Boundary vertices have no
/// angle defect to compare.
double logVectorShareOf(const Geometry& geometry, int vertex) {
  constexpr double kEven = 0.003;
  const TriangleMesh& mesh = *geometry.mesh;
  double sum = 0;
  double squares = 0;
  int count = 0;
  const auto add = [&](int v) {
    if (mesh.onBoundary[v]) return;
    const double defect = 2 * kPi - geometry.totalAngle[v];
    sum += defect;
    squares += defect * defect;
    ++count;
  };
  add(vertex);
  for (const int h : outgoingHalfedges(mesh, vertex)) {
    add(mesh.head(h));
  }
  if (count == 0) return 0;
  const double mean = sum / count;
  const double variance = std::max(0.0, squares / count - mean * mean);
  return variance / (variance + mean * mean + kEven * kEven);
}

/// A linear map that gives the neighbours' positions unit covariance about the vertex.
Eigen::Matrix2d whitening(const Array<Neighbour>& ring) {
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const Neighbour& n : ring) covariance += n.place * n.place.transpose();
  covariance /= ring.count() - 1;
  const Eigen::Matrix2d lower = covariance.llt().matrixL();
  return lower.inverse();
}

/// The weights of the linear fit, which averages noise over its whole ring.
double wideGaussian(const Vec2& white) { return std::exp(-white.squaredNorm() / 2); }

/// The weights of the quadratic fit. They are so narrow that the second ring determines only what
/// the first ring cannot. So the fit stays closer to the polyhedron's own distances near the
/// vertex.
double narrowGaussian(const Vec2& white) { return std::exp(-2 * white.squaredNorm()); }

/// Writes the terms of log vectors. If the ring does not determine the fit, writes only the term of
/// the vertex's own log vector.
void linearTerms(const Array<Neighbour>& ring, double share, Array<StencilTerm>& terms) {
  const Eigen::Matrix2d toWhite = whitening(ring);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  for (const Neighbour& n : ring) {
    const Vec2 z = toWhite * n.place;
    const Eigen::Vector3d row(1, z.x(), z.y());
    normal += wideGaussian(z) * row * row.transpose();
  }
  const Eigen::Vector3d c = normal.ldlt().solve(Eigen::Vector3d(1, 0, 0));
  if (!c.allFinite()) {
    terms.push_back({1, 0, ring[0].vertex});
    return;
  }
  const size_t first = terms.size();
  for (const Neighbour& n : ring) {
    const Vec2 z = toWhite * n.place;
    const double weight = wideGaussian(z) * (c[0] + c[1] * z.x() + c[2] * z.y());
    const Vec2 coefficient = (1 - share) * weight * n.rotation;
    terms.push_back({coefficient.x(), coefficient.y(), n.vertex});
  }
  terms[first].x += share;
}

/// Writes the term of the vertex's own log vector, then terms of differences of squared distances.
/// Returns false if the ring does not determine the fit.
bool quadraticTerms(const Array<Neighbour>& ring, double share, Array<StencilTerm>& terms) {
  using Vector5 = Eigen::Matrix<double, 5, 1>;
  using Matrix5 = Eigen::Matrix<double, 5, 5>;
  constexpr int kFewest = 8;
  if (ring.count() < kFewest) return false;
  const Eigen::Matrix2d toWhite = whitening(ring);
  const auto row = [&](const Vec2& z) {
    return Vector5(z.x(), z.y(), z.x() * z.x() / 2, z.x() * z.y(), z.y() * z.y() / 2);
  };
  Matrix5 normal = Matrix5::Zero();
  for (int i = 1; i < ring.count(); ++i) {
    const Vec2 z = toWhite * ring[i].place;
    normal += narrowGaussian(z) * row(z) * row(z).transpose();
  }
  const Eigen::LDLT<Matrix5> factor(normal);
  const Vector5 pivots = factor.vectorD();
  constexpr double kWorstCondition = 1e-4;
  if (!(pivots.minCoeff() > kWorstCondition * pivots.maxCoeff())) return false;
  terms.push_back({share, 0, ring[0].vertex});
  for (int i = 1; i < ring.count(); ++i) {
    const Vec2 z = toWhite * ring[i].place;
    const Vector5 fit = (1 - share) * factor.solve(narrowGaussian(z) * row(z));
    const Vec2 coefficient = toWhite.transpose() * fit.head<2>();
    terms.push_back({coefficient.x(), coefficient.y(), ring[i].vertex});
  }
  return true;
}

}  // namespace

StencilTable::StencilTable(const Geometry& geometry, Estimator estimator)
    : geometry_(geometry), estimator_(estimator), places_(geometry.mesh->vertexCount()) {}

Stencil StencilTable::at(int vertex) {
  Place& place = places_.touch(vertex);
  if (place.begin < 0) {
    const int64_t begin = static_cast<int64_t>(terms_.size());
    const double share = isHub(*geometry_.mesh, vertex) ? 1 : logVectorShareOf(geometry_, vertex);
    bool quadratic = false;
    if (share < 1) {
      findRings(geometry_, vertex, estimator_ == Estimator::kLinear1 ? 1 : 2, ring_, ways_);
      quadratic = estimator_ == Estimator::kQuadratic2 && quadraticTerms(ring_, share, terms_);
      if (!quadratic) linearTerms(ring_, share, terms_);
    } else {
      terms_.push_back({1, 0, vertex});
    }
    place.count = static_cast<int>(static_cast<int64_t>(terms_.size()) - begin);
    place.ofVectors = quadratic ? 1 : place.count;
    place.logVectorShare = share;
    place.begin = begin;
  }
  const StencilTerm* begin = terms_.data() + place.begin;
  return {begin, begin + place.ofVectors, begin + place.count, place.logVectorShare};
}

}  // namespace karcher
