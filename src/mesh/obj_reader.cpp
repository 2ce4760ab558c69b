#include "mesh/obj_reader.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>

#include "mesh/error.h"
#include "mesh/obj_lines.h"
#include "mesh/plain_streams.h"
#include "mesh/polygon_soup.h"
#include "mesh/positions.h"

// The macro renames the namespace, since a program that links this library may have its own
// tinyobjloader.
#define tinyobj karcherTinyobj
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#ifdef KARCHER_PLAIN_STREAMS
// Tinyobjloader takes its streams from plain_streams.h. That file already includes every header
// that tinyobjloader includes.
#define std karcher::plain
#endif
#include <tiny_obj_loader.h>
#undef std

namespace karcher {
namespace {

/// A stream that rewrites a checked file for tinyobjloader, which understands neither a backslash
/// at a line's end nor a comment after a number. The stream has only the lines that matter, joins
/// continued lines, and keeps only the vertex of each corner. It writes a vertex's color as a
/// normal (`vn`), since in the tinyobjloader of Debian 12 and 13 callbacks do not receive colors.
class PlainLines : public plain::streambuf {
 public:
  explicit PlainLines(std::string_view text) : text_(text) {}

 protected:
  int_type underflow() override {
    constexpr size_t kBlock = size_t{1} << 16;
    block_.clear();
    while (!text_.empty() && block_.size() < kBlock) addLine(takeObjLine(text_));
    setg(block_.data(), block_.data(), block_.data() + block_.size());
    return block_.empty() ? traits_type::eof() : traits_type::to_int_type(block_[0]);
  }

 private:
  void addLine(std::string_view line) {
    const std::string_view keyword = takeObjWord(line);
    if (keyword == "v") {
      add("v");
      addWords(line, 3);
      addColor(line);
    } else if (keyword == "f") {
      add("f");
      const size_t begin = block_.size();
      for (std::string_view corner = takeObjWord(line); !corner.empty();
           corner = takeObjWord(line)) {
        add(" ");
        add(corner.substr(0, corner.find('/')));
      }
      // Tinyobjloader does not report a face without corners, but the check has counted the face.
      // So it gets a corner.
      if (block_.size() == begin) add(" 0");
      add("\n");
    } else if (keyword == "o" || keyword == "g" || keyword == "usemtl") {
      constexpr size_t kLongestName = 200;
      add(keyword);
      add(" ");
      const size_t end = block_.size() + kLongestName;
      for (std::string_view word = takeObjWord(line); !word.empty(); word = takeObjWord(line)) {
        if (block_.back() != ' ') add(" ");
        add(word);
      }
      block_.resize(std::min(block_.size(), end));
      add("\n");
    }
  }

  void addColor(std::string_view line) {
    std::string_view words = line;
    for (int k = 0; k < 3; ++k) {
      if (!isDecimalNumber(takeObjWord(words))) return;
    }
    add("vn");
    addWords(line, 3);
  }

  void addWords(std::string_view& line, int count) {
    for (int k = 0; k < count; ++k) {
      add(" ");
      add(takeObjWord(line));
    }
    add("\n");
  }

  void add(std::string_view words) { block_ += words; }

  std::string_view text_;
  std::string block_;
};

/// Collects the contents of a checked file from the callbacks of tinyobjloader.
class Reading {
 public:
  Reading(const ObjLines& lines, const ObjOptions& options) : lines_(lines), options_(options) {
    faces.positions.reserve(static_cast<size_t>(lines.vertices));
    faces.corners.reserve(3 * static_cast<size_t>(lines.faces));
    faces.cornerCount.reserve(static_cast<size_t>(lines.faces));
  }

  void read(std::string_view text) {
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* self, double x, double y, double z, double) {
      of(self).faces.positions.emplace_back(x, y, z);
    };
    callbacks.normal_cb = [](void* self, double red, double green, double blue) {
      of(self).addColor({red, green, blue});
    };
    callbacks.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
      of(self).addFace(corners, count);
    };
    callbacks.object_cb = [](void* self, const char* name) { of(self).beginObject(name); };
    callbacks.group_cb = [](void* self, const char** names, int count) {
      of(self).beginGroup(names, count);
    };
    callbacks.usemtl_cb = [](void* self, const char* name, int) { of(self).takeMaterial(name); };
    PlainLines lines(text);
    plain::istream stream(&lines);
    tinyobj::LoadObjWithCallback(stream, callbacks, this);
    for (const NotFinite& bad : lines_.notFinite) {
      faces.positions[bad.vertex].setConstant(std::nan(""));
    }
    checkParts();
  }

  /// The marks of the file. `triangles` has the kind of each triangle.
  ObjMarks marksOf(const Array<int>& triangles) {
    ObjMarks marks;
    const auto of = [&](auto member) {
      Array<int> result;
      result.reserve(triangles.size());
      for (const int mark : triangles) result.push_back(kinds_[mark].*member);
      return result;
    };
    if (parts_.count() > 1) marks.part = of(&Kind::part);
    if (!materials_.empty()) marks.material = of(&Kind::material);
    marks.parts = std::move(parts_);
    marks.materials = std::move(materials_);
    marks.colors = colorBytes();
    marks.otherElements = lines_.otherElements;
    return marks;
  }

  PolygonSoup faces;
  /// The lines of faces with more than three corners, and the lines of faces with fewer.
  Array<int> polygonLines;
  Array<int> shortLines;

 private:
  /// The part and material that faces have in common.
  struct Kind {
    int part = -1;
    int material = -1;
  };
  using Numbers = std::unordered_map<std::string, int>;

  static Reading& of(void* self) { return *static_cast<Reading*>(self); }

  void addColor(const Vec3& color) {
    colors_.resize(faces.positions.size(), Vec3::Constant(-1));
    colors_.back() = color;
  }

  void addFace(const tinyobj::index_t* corners, int count) {
    if (kind_ < 0) beginKind();
    ObjPart& part = parts_[kinds_[kind_].part];
    part.triangles += std::max(0, count - 2);
    if (count < 3) ++shortFaces_;
    if (count > 3) ++polygons_;
    if (!isWanted(kinds_[kind_].part)) return;
    if (count < 3) {
      shortLines.push_back(lines_.shortLines[shortFaces_ - 1]);
      return;
    }
    if (count > 3) polygonLines.push_back(lines_.polygonLines[polygons_ - 1]);
    for (int k = 0; k < count; ++k) {
      const int v = corners[k].vertex_index;
      faces.corners.push_back(v > 0 ? v - 1 : faces.positions.count() + v);
    }
    faces.cornerCount.push_back(count);
    faces.mark.push_back(kind_);
  }

  void beginObject(const std::string& name) {
    object_ = name;
    group_.clear();
    kind_ = -1;
  }

  void beginGroup(const char** names, int count) {
    group_.clear();
    for (int i = 0; i < count; ++i) {
      if (i > 0) group_ += ' ';
      group_ += names[i];
    }
    kind_ = -1;
  }

  void takeMaterial(const std::string& name) {
    material_ = name;
    kind_ = -1;
  }

  void beginKind() {
    const std::string name = object_ + (object_.empty() || group_.empty() ? "" : ", ") + group_;
    const int part = numberOf(name, partNumbers_);
    if (part == parts_.count()) parts_.push_back({name.empty() ? "mesh" : name, 0});
    int material = -1;
    if (!material_.empty()) {
      material = numberOf(material_, materialNumbers_);
      if (material == materials_.count()) materials_.push_back(material_);
    }
    kind_ = kinds_.count();
    kinds_.push_back({part, material});
  }

  static int numberOf(const std::string& name, Numbers& numbers) {
    return numbers.emplace(name, static_cast<int>(numbers.size())).first->second;
  }

  bool isWanted(int part) const {
    const auto& wanted = options_.parts;
    return !wanted || std::find(wanted->begin(), wanted->end(), part) != wanted->end();
  }

  void checkParts() const {
    if (!options_.parts) return;
    for (const int part : *options_.parts) {
      if (part >= 0 && part < parts_.count()) continue;
      throw Error(ErrorCode::kBadArgument, "there is no part " + std::to_string(part) +
                                               ": the file has " + std::to_string(parts_.count()) +
                                               ", numbered from 0");
    }
  }

  Array<uint8_t> colorBytes() const {
    Array<uint8_t> bytes;
    if (colors_.empty()) return bytes;
    double most = 0;
    for (const Vec3& color : colors_) most = std::max(most, color.maxCoeff());
    const double scale = most > 1 ? 1 : 255;
    bytes.assign(3 * static_cast<size_t>(lines_.vertices), 255);
    for (int v = 0; v < colors_.count(); ++v) {
      if (colors_[v] == Vec3::Constant(-1)) continue;
      for (int k = 0; k < 3; ++k) {
        const double value = std::clamp(std::round(scale * colors_[v][k]), 0.0, 255.0);
        bytes[3 * v + k] = static_cast<uint8_t>(value);
      }
    }
    return bytes;
  }

  const ObjLines& lines_;
  const ObjOptions& options_;
  /// the number of faces with more than three corners, including those of unwanted parts
  int polygons_ = 0;
  int shortFaces_ = 0;
  /// the color of each vertex up to the last one with a color; -1 for vertices without a color
  Array<Vec3> colors_;
  Array<ObjPart> parts_;
  Array<std::string> materials_;
  Numbers partNumbers_;
  Numbers materialNumbers_;
  Array<Kind> kinds_;
  int kind_ = -1;  ///< the kind of the next face; -1 until it is known
  std::string object_;
  std::string group_;
  std::string material_;
};

/// Checks the positions of the vertices that faces use.
void checkUses(const PolygonSoup& faces, const ObjLines& lines) {
  Array<uint8_t> isUsed(faces.positions.size(), 0);
  for (const int v : faces.corners) isUsed[v] = 1;
  for (const NotFinite& bad : lines.notFinite) {
    if (isUsed[bad.vertex]) throw Error(ErrorCode::kNotFinite, bad.sentence);
  }
  Array<int> used;
  for (int v = 0; v < isUsed.count(); ++v) {
    if (isUsed[v]) used.push_back(v);
  }
  checkPositions(faces.positions, &used);
}

}  // namespace

ObjContents readObj(std::string_view bytes, const ObjOptions& options) {
  if (bytes.find('\0') != std::string_view::npos) {
    throw Error(ErrorCode::kBadFile, "the file is not text: an OBJ file has no zero bytes");
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  const ObjLines lines = checkObjLines(bytes);
  if (!options.mend && !lines.notFinite.empty()) {
    throw Error(ErrorCode::kNotFinite, lines.notFinite[0].sentence);
  }
  if (!options.mend && !lines.shortLines.empty()) {
    throw Error(ErrorCode::kBadFile, shortFace(lines.shortLines[0]));
  }
  Reading reading(lines, options);
  reading.read(bytes);
  if (options.mend) {
    checkUses(reading.faces, lines);
  } else {
    checkPositions(reading.faces.positions);
  }
  const auto lineOf = [&](PolygonNumber number) { return reading.polygonLines[number.polygon]; };
  ObjContents contents;
  CutPolygons cut = cutPolygons(std::move(reading.faces), options.mend, [&](PolygonNumber number) {
    return "line " + std::to_string(lineOf(number));
  });
  contents.marks = reading.marksOf(cut.mark);
  contents.soup = std::move(cut.soup);
  contents.polygonsCut = cut.polygonsCut;
  contents.repeatedCorners = cut.repeatedCorners;
  const Array<int>& shortLines = reading.shortLines;
  contents.leftOut = cut.leftOut + shortLines.count();
  if (cut.leftOut > 0) contents.firstLineLeftOut = lineOf(cut.firstLeftOut);
  if (!shortLines.empty() && (cut.leftOut == 0 || shortLines[0] < contents.firstLineLeftOut)) {
    contents.firstLineLeftOut = shortLines[0];
  }
  return contents;
}

}  // namespace karcher
