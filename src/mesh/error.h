#pragma once

#include <stdexcept>
#include <string>

namespace karcher {

/// The kind of a failure.
enum class ErrorCode {
  kBadFile,            ///< the file is not a valid OBJ file, or has no faces
  kBadIndex,           ///< a face or a point names a vertex or face that does not exist
  kNotFinite,          ///< a coordinate, weight or distance is NaN or infinite
  kDegenerateFace,     ///< a face has a repeated corner or no area
  kNonManifoldEdge,    ///< an edge has more than two faces, or two in the same direction
  kNonManifoldVertex,  ///< the faces around a vertex form more than one fan
  kNotOrientable,      ///< the surface has only one side
  kBadPoint,           ///< barycentric weights are negative or do not sum to 1
  kBadWeights,         ///< the number or the sum of weights is wrong
  kTooFewPoints,       ///< the kind of curve needs more control points
  kBadArgument,        ///< any other argument is outside its range
  kUnreachable,        ///< points lie on different components
  kBoundary,           ///< a geodesic meets the boundary where it must not
  kRadiusTooLarge,     ///< a circle is wider than its component
  kNoEmbedding,        ///< the mesh has no acceptable embedding, for weighted averages
};

/// The name of a code, for callers in other languages, such as "nonManifoldEdge".
const char* errorCodeName(ErrorCode code);

/// A number as text for a sentence, with at most `digits` digits, such as 0.25 or 1e-07.
std::string inSentence(double value, int digits = 6);

/// A number as text, with at least six digits and enough digits to identify the double, such as
/// 3.000000000001.
std::string inFull(double value);

/// A failure of the engine: a code, and a sentence that names the object and the limit.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

/// Throws kBadArgument with this sentence.
[[noreturn]] void refuse(const std::string& sentence);

}  // namespace karcher
