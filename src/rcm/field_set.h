#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>

#include "rcm/point_field.h"

namespace karcher {

/// The fields of points on one surface, by point. Centers of mass and curves that share a set share
/// the field of a point. A field's values depend only on the surface, the options and the point, so
/// that no result depends on the fields that a set holds.
///
/// A field without a holder is spare. The set finds a spare field by its point until it moves the
/// field to a new point. So a drag moves spare fields and creates none.
class FieldSet {
 public:
  /// The surface must outlive the set. Throws what `checkFieldOptions` throws.
  FieldSet(Surface& surface, const FieldOptions& options);
  FieldSet(const FieldSet&) = delete;
  FieldSet& operator=(const FieldSet&) = delete;

  const FieldOptions& options() const { return options_; }
  Surface& surface() const { return surface_; }

  /// The field of a point, near or not (point_field.h). If the point has no field yet, the set
  /// moves a spare field there or, without a spare field, creates a new one.
  std::shared_ptr<PointField> at(const SurfacePoint& point, bool isNear = false);

  /// The existing field of a point, or null.
  std::shared_ptr<PointField> find(const SurfacePoint& point, bool isNear = false) const;

  /// Frees spare fields until at most `kept` spare fields remain.
  void dropSpare(int kept = 0);

  /// Frees spare fields until there are no more spare fields than fields with holders.
  void trim();

  /// The limit for the bytes that the solvers of all fields hold. Above this limit, unused fields
  /// rest.
  static constexpr int64_t kMostBytes = int64_t{1} << 29;

  /// Marks a field as part of the current use, such as the work on one curve.
  void use(PointField& field) const { field.setLastUse(uses_); }

  /// Ends the current use. While the solvers of all fields hold more than `most` bytes, fields that
  /// are not part of this use rest (PointField::rest), the longest unused field first.
  void restUnused(int64_t most = kMostBytes);

  /// The number of fields.
  int count() const { return fields_.count(); }

  /// The number of fields created or moved to another point so far.
  int made() const { return made_; }

 private:
  struct Key {
    SurfacePoint point;
    bool isNear;
    bool operator==(const Key& other) const {
      return point.face == other.point.face && point.bary == other.point.bary &&
             isNear == other.isNear;
    }
  };
  struct Hash {
    size_t operator()(const Key& key) const;
  };
  static Key keyOf(const PointField& field) { return {field.point(), field.isNear()}; }

  /// Updates the map for a field that has moved to a place in `fields_`.
  void renumber(int place);

  /// The place of the next spare field in cyclic order; -1 if no field is spare.
  int findSpare();

  Surface& surface_;
  FieldOptions options_;
  Array<std::shared_ptr<PointField>> fields_;
  std::shared_ptr<FindPathWorkspace> paths_ = std::make_shared<FindPathWorkspace>();
  std::unordered_map<Key, int, Hash> placeOf_;
  int next_ = 0;  ///< the place where the search for a spare field continues
  int made_ = 0;
  int uses_ = 1;
};

/// A pointer to the same set, for a curve. The end of the pointer's last copy trims the set, since
/// the curve's fields, which may be many, are then spare.
std::shared_ptr<FieldSet> trimmedAfter(std::shared_ptr<FieldSet> set);

/// The field sets of one surface, one for each combination of options in use.
class FieldSets {
 public:
  /// The surface must outlive the object.
  explicit FieldSets(Surface& surface) : surface_(surface) {}

  Surface& surface() const { return surface_; }

  /// The field set for these options. It exists as long as a caller holds it. Throws what
  /// `checkFieldOptions` throws.
  std::shared_ptr<FieldSet> of(const FieldOptions& options);

 private:
  Surface& surface_;
  Array<std::weak_ptr<FieldSet>> sets_;
};

}  // namespace karcher
