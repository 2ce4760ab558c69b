#include "peers/affine_heat.h"

namespace karcher {
namespace {

Columns<double, 1> heatFrom(const HeatOperators& operators, int vertex) {
  Columns<double, 1> heat = Columns<double, 1>::Zero(operators.vertexCount());
  heat[vertex] = 1;
  return operators.scalarHeat().solve<1>(heat);
}

/// The source of the vector heat. At each vertex, it sums the translations along the edges, each
/// weighted by the scalar heat that flows in over the edge.
Columns<Complex, 1> translations(const HeatOperators& operators, const Columns<double, 1>& heat) {
  Columns<Complex, 1> source = Columns<Complex, 1>::Zero(operators.vertexCount());
  for (const HeatEdge& edge : operators.edges()) {
    const double flow = operators.time() * edge.weight;
    source[edge.tail] -= flow * heat[edge.head] * edge.atTail;
    source[edge.head] -= flow * heat[edge.tail] * edge.atHead;
  }
  return source;
}

LogMap localLogMap(const HeatOperators& operators, int vertex) {
  const Columns<double, 1> heat = heatFrom(operators, vertex);
  Columns<Complex, 2> vectors = Columns<Complex, 2>::Zero(operators.vertexCount(), 2);
  vectors.col(0) = translations(operators, heat);
  vectors(vertex, 1) = 1;
  vectors = operators.vectorHeat().solve<2>(vectors);
  LogMap logs(static_cast<size_t>(operators.vertexCount()), noLogarithm());
  for (int v = 0; v < operators.vertexCount(); ++v) {
    const Vec2 xAxis = heatDirection(vectors(v, 1));
    if (std::abs(heat[v]) < kLeastHeat || xAxis.isZero(0)) continue;
    logs[v] = rotateBack(xAxis, toVec2(vectors(v, 0) / heat[v]));
  }
  return logs;
}

LogMap adaptiveLogMap(const HeatOperators& operators, int vertex) {
  const int count = operators.vertexCount();
  const Columns<double, 1> heat = heatFrom(operators, vertex);
  Columns<Complex, 1> transported = Columns<Complex, 1>::Zero(count);
  transported[vertex] = 1;
  transported = operators.vectorHeat().solve<1>(transported);
  Array<Vec2> xAxis;
  for (int v = 0; v < count; ++v) xAxis.push_back(heatDirection(transported[v]));
  Columns<double, 2> sources = Columns<double, 2>::Zero(count, 2);
  for (const HeatEdge& edge : operators.edges()) {
    const double flow = operators.time() * edge.weight;
    const Vec2 onward = rotateBack(xAxis[edge.tail], toVec2(edge.atTail));
    const Vec2 back = rotateBack(xAxis[edge.head], toVec2(edge.atHead));
    sources.row(edge.tail) -= flow * heat[edge.head] * onward.transpose();
    sources.row(edge.head) -= flow * heat[edge.tail] * back.transpose();
  }
  sources = operators.scalarHeat().solve<2>(sources);
  LogMap logs(static_cast<size_t>(count), noLogarithm());
  for (int v = 0; v < count; ++v) {
    if (std::abs(heat[v]) >= kLeastHeat) logs[v] = sources.row(v).transpose() / heat[v];
  }
  return logs;
}

}  // namespace

LogMap affineHeatLogMap(const HeatOperators& operators, int vertex, AffineVariant variant) {
  return variant == AffineVariant::kLocal ? localLogMap(operators, vertex)
                                          : adaptiveLogMap(operators, vertex);
}

}  // namespace karcher
