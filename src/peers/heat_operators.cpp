#include "peers/heat_operators.h"

namespace karcher {
namespace {

IntrinsicTriangulation chosenTriangulation(const Geometry& geometry, bool delaunay) {
  IntrinsicTriangulation triangulation = meshTriangulation(geometry);
  if (delaunay) makeDelaunay(triangulation);
  return triangulation;
}

}  // namespace

HeatOperators::HeatOperators(const Geometry& geometry, const HeatOptions& options)
    : triangulation_(chosenTriangulation(geometry, options.delaunay)) {
  if (!(options.timeFactor > 0) || !std::isfinite(options.timeFactor)) {
    throw Error(ErrorCode::kBadArgument, "the time factor of the heat flow is " +
                                             std::to_string(options.timeFactor) +
                                             ", but it must be positive and finite");
  }
  collectEdges();
  sumMass();
  groupHalfedges();
  chooseHeldVertices();
  double length = 0;
  for (const HeatEdge& edge : edges_) length += std::abs(edge.atTail);
  const double meanEdge = length / edges_.count();
  time_ = options.timeFactor * meanEdge * meanEdge;
}

void HeatOperators::collectEdges() {
  for (int h = 0; h < triangulation_.tail.count(); ++h) {
    const int twin = triangulation_.twin[h];
    if (twin >= 0 && twin < h) continue;
    double cotangents = oppositeCotangent(triangulation_, h);
    if (twin >= 0) cotangents += oppositeCotangent(triangulation_, twin);
    edges_.push_back({triangulation_.tail[h], triangulation_.head(h), cotangents / 2,
                      vectorAtTail(triangulation_, h), vectorAtHead(triangulation_, h)});
  }
}

void HeatOperators::sumMass() {
  mass_.assign(static_cast<size_t>(vertexCount()), 0);
  for (int f = 0; f < triangulation_.faceCount(); ++f) {
    const double third = doubleArea(triangulation_, f) / 6;
    for (int h = 3 * f; h < 3 * f + 3; ++h) mass_[triangulation_.tail[h]] += third;
  }
}

void HeatOperators::groupHalfedges() {
  firstHalfedge_.assign(static_cast<size_t>(vertexCount()) + 1, 0);
  for (const int v : triangulation_.tail) ++firstHalfedge_[v + 1];
  for (int v = 0; v < vertexCount(); ++v) firstHalfedge_[v + 1] += firstHalfedge_[v];
  halfedges_.resize(triangulation_.tail.size());
  Array<int> place = firstHalfedge_;
  for (int h = 0; h < triangulation_.tail.count(); ++h) {
    halfedges_[place[triangulation_.tail[h]]++] = h;
  }
}

void HeatOperators::chooseHeldVertices() {
  const Array<int> component = componentOfVertices(*geometry().mesh);
  for (int v = 0; v < vertexCount(); ++v) {
    if (component[v] == heldVertices_.count()) heldVertices_.push_back(v);
  }
}

std::span<const int> HeatOperators::halfedgesFrom(int vertex) const {
  const int first = firstHalfedge_[vertex];
  return {halfedges_.data() + first, static_cast<size_t>(firstHalfedge_[vertex + 1] - first)};
}

Eigen::SparseMatrix<double> HeatOperators::scalarMatrix(double massFactor,
                                                        double laplacianFactor) const {
  Array<Eigen::Triplet<double>> entries;
  entries.reserve(edges_.size() * 3 + mass_.size());
  for (int v = 0; v < vertexCount(); ++v) entries.emplace_back(v, v, massFactor * mass_[v]);
  for (const HeatEdge& edge : edges_) {
    if (edge.tail == edge.head) continue;
    const double weight = laplacianFactor * edge.weight;
    entries.emplace_back(edge.tail, edge.tail, weight);
    entries.emplace_back(edge.head, edge.head, weight);
    entries.emplace_back(std::max(edge.tail, edge.head), std::min(edge.tail, edge.head), -weight);
  }
  Eigen::SparseMatrix<double> matrix(vertexCount(), vertexCount());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

const SparseFactor<double>& HeatOperators::scalarHeat() const {
  if (!scalarHeat_) scalarHeat_.emplace(scalarMatrix(1, time_), "the heat flow of functions");
  return *scalarHeat_;
}

const SparseFactor<Complex>& HeatOperators::vectorHeat() const {
  if (vectorHeat_) return *vectorHeat_;
  Array<Eigen::Triplet<Complex>> entries;
  entries.reserve(edges_.size() * 3 + mass_.size());
  for (int v = 0; v < vertexCount(); ++v) entries.emplace_back(v, v, mass_[v]);
  for (const HeatEdge& edge : edges_) {
    const double weight = time_ * edge.weight;
    // Transport along the edge multiplies a vector in the head's frame by this rotation and gives a
    // vector in the tail's frame.
    const Complex toTail =
        -edge.atTail / edge.atHead * (std::abs(edge.atHead) / std::abs(edge.atTail));
    entries.emplace_back(edge.tail, edge.tail, weight);
    entries.emplace_back(edge.head, edge.head, weight);
    if (edge.tail == edge.head) {
      entries.emplace_back(edge.tail, edge.tail, -2 * weight * toTail.real());
    } else if (edge.tail > edge.head) {
      entries.emplace_back(edge.tail, edge.head, -weight * toTail);
    } else {
      entries.emplace_back(edge.head, edge.tail, -weight * std::conj(toTail));
    }
  }
  Eigen::SparseMatrix<Complex> matrix(vertexCount(), vertexCount());
  matrix.setFromTriplets(entries.begin(), entries.end());
  vectorHeat_.emplace(matrix, "the heat flow of vectors");
  return *vectorHeat_;
}

const SparseFactor<double>& HeatOperators::poisson() const {
  if (poisson_) return *poisson_;
  Array<uint8_t> held(mass_.size(), 0);
  for (const int v : heldVertices_) held[v] = 1;
  Eigen::SparseMatrix<double> matrix = scalarMatrix(0, 1);
  for (int v = 0; v < vertexCount(); ++v) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, v); entry; ++entry) {
      if (held[v] || held[entry.row()]) entry.valueRef() = entry.row() == v ? 1 : 0;
    }
  }
  poisson_.emplace(matrix, "the Laplacian");
  return *poisson_;
}

}  // namespace karcher
