#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "rcm/point_field.h"

namespace karcher {

/// The fields of points on one surface, by point. Centers of mass and curves share a set: where one
/// of them has the field of a point already, the others get that one. A field's values depend on
/// the surface, the options and the point alone, so that no answer depends on what a set holds.
///
/// A field that nobody holds is spare. It is still found by its point, until a new point needs its
/// memory: a drag makes no fields but moves spare ones.
class FieldSet {
 public:
  /// The surface must outlive the set. Throws what `checkFieldOptions` throws.
  FieldSet(Surface& surface, const FieldOptions& options);
  FieldSet(const FieldSet&) = delete;
  FieldSet& operator=(const FieldSet&) = delete;

  const FieldOptions& options() const { return options_; }
  Surface& surface() const { return surface_; }

  /// The field of a point: the one that is at it, else a spare one that is moved to it, else a new
  /// one.
  std::shared_ptr<PointField> at(const SurfacePoint& point);

  /// The field that is at a point, or none.
  std::shared_ptr<PointField> find(const SurfacePoint& point) const;

  /// Gives the memory of spare fields back.
  void dropSpare();

  /// How many fields there are.
  int count() const { return fields_.count(); }

  /// How many fields were made or moved to another point so far.
  int made() const { return made_; }

 private:
  struct Hash {
    size_t operator()(const SurfacePoint& point) const;
  };
  struct Same {
    bool operator()(const SurfacePoint& a, const SurfacePoint& b) const {
      return a.face == b.face && a.bary == b.bary;
    }
  };

  /// The place of a spare field, in turn; -1 if there is none.
  int findSpare();

  Surface& surface_;
  FieldOptions options_;
  Array<std::shared_ptr<PointField>> fields_;
  std::unordered_map<SurfacePoint, int, Hash, Same> placeOf_;
  int next_ = 0;  ///< where the search for a spare field goes on
  int made_ = 0;
};

}  // namespace karcher
