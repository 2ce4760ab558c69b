#include "peers/vector_heat.h"

namespace karcher {
namespace {

/// The outward directions in one corner, on a small circle about its vertex. They are given as
/// coefficients of the hat functions at the far ends of the corner's two sides. Each coefficient is
/// an integral over the directions in the corner. The integrand is the hat's slope in a direction,
/// times this direction. The x axis is the corner's first side.
struct CornerBall {
  Complex first;   ///< the coefficient of the hat at the end of the first side
  Complex second;  ///< the coefficient of the hat at the end of the second side
};

CornerBall cornerBall(const IntrinsicTriangulation& triangulation, int h) {
  const double angle = cornerAngle(triangulation, h);
  const double area = doubleArea(triangulation, faceOf(h));
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  // Each hat rises from 0 on the corner's other side to 1 at the hat's own vertex. These are the
  // heights of the two vertices over those sides.
  const double firstHeight = area / triangulation.length[previous(h)];
  const double secondHeight = area / triangulation.length[h];
  return {Complex(angle * sine, sine - angle * cosine) / (2 * firstHeight),
          Complex(sine * sine, angle - sine * cosine) / (2 * secondHeight)};
}

void addOutwardBall(const HeatOperators& operators, int vertex, Columns<Complex, 2>& heat) {
  const IntrinsicTriangulation& triangulation = operators.triangulation();
  for (const int h : operators.halfedgesFrom(vertex)) {
    const int last = previous(h);
    const CornerBall ball = cornerBall(triangulation, h);
    const Complex along = std::polar(1.0, std::arg(vectorAtTail(triangulation, h)));
    // The directions in which the two sides arrive at their far ends.
    const Complex arrivingFirst = -std::polar(1.0, std::arg(vectorAtHead(triangulation, h)));
    const Complex arrivingSecond = -std::polar(1.0, std::arg(vectorAtTail(triangulation, last)));
    const Complex secondSide = std::polar(1.0, cornerAngle(triangulation, h));
    heat(triangulation.head(h), 0) += ball.first * arrivingFirst;
    heat(triangulation.tail[last], 0) += ball.second / secondSide * arrivingSecond;
    heat(vertex, 0) -= (ball.first + ball.second) * along;
  }
}

}  // namespace

LogMap vectorHeatLogMap(const HeatOperators& operators, int vertex) {
  const int count = operators.vertexCount();
  Columns<Complex, 2> heat = Columns<Complex, 2>::Zero(count, 2);
  addOutwardBall(operators, vertex, heat);
  heat(vertex, 1) = 1;
  heat = operators.vectorHeat().solve<2>(heat);

  Array<Vec2> radial(static_cast<size_t>(count));
  for (int v = 0; v < count; ++v) radial[v] = heatDirection(heat(v, 0));
  radial[vertex] = Vec2::Zero();
  Columns<double, 1> divergence = Columns<double, 1>::Zero(count);
  for (const HeatEdge& edge : operators.edges()) {
    const double rise =
        radial[edge.tail].dot(toVec2(edge.atTail)) - radial[edge.head].dot(toVec2(edge.atHead));
    divergence[edge.tail] -= edge.weight / 2 * rise;
    divergence[edge.head] += edge.weight / 2 * rise;
  }
  for (const int v : operators.heldVertices()) divergence[v] = 0;
  const Columns<double, 1> distance = operators.poisson().solve<1>(divergence);

  LogMap logs(static_cast<size_t>(count));
  for (int v = 0; v < count; ++v) {
    const Vec2 xAxis = heatDirection(heat(v, 1));
    const bool reached = !radial[v].isZero(0) && !xAxis.isZero(0);
    logs[v] = reached ? Vec2((distance[v] - distance[vertex]) * rotateBack(xAxis, radial[v]))
                      : noLogarithm();
  }
  logs[vertex] = Vec2::Zero();
  return logs;
}

Vec2 cornerRotation(const Geometry& geometry, const SurfacePoint& point, int k) {
  const int h = 3 * point.face + k;
  const PointLocation location = locate(*geometry.mesh, point);
  double direction = geometry.cumulatedAngle[h];
  Vec2 inFace = halfedgeInFace(geometry, h) / geometry.edgeLength[h];
  const int last = previous(h);
  if (location.simplex == Simplex::kEdge && location.halfedge == last) {
    direction += geometry.cornerAngle[h];
    inFace = -halfedgeInFace(geometry, last) / geometry.edgeLength[last];
  }
  const double scale = geometry.angleScale[geometry.mesh->tail(h)];
  return rotateBack(unitVector(scale * direction), inFace);
}

}  // namespace karcher
