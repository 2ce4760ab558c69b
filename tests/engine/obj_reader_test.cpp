#include "mesh/obj_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "generators/random.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "mesh/polygon.h"
#include "support.h"

namespace karcher {
namespace {

/// The error of a read, as "code: sentence"; empty without an error.
std::string errorOf(const std::string& text, bool mend = true) {
  try {
    readObj(text, {mend, {}});
  } catch (const Error& error) {
    return std::string(errorCodeName(error.code())) + ": " + error.what();
  }
  return "";
}

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ReadObj, ReadsPositionsAndTrianglesInTheFilesOrder) {
  const ObjContents obj = readObj(kThree + "v 1 1 0.5\nf 3 1 2\nf 3 2 4\n");
  const Array<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
  const Array<Triangle> triangles = {{2, 0, 1}, {2, 1, 3}};
  EXPECT_TRUE(obj.soup.positions == positions);
  EXPECT_TRUE(obj.soup.triangles == triangles);
  EXPECT_EQ(obj.polygonsCut, 0);
}

TEST(ReadObj, SkipsUnusedLines) {
  const ObjContents obj = readObj(
      "\xEF\xBB\xBF# comment\r\nmtllib scene.mtl\r\no thing\r\ng a b\r\n\r\n"
      "v 0 0 0 1 0 0\r\n  v\t1 0 0\r\nv 0 1 0 # a corner\r\nvt 0 0\r\nvn 0 0 1\r\n"
      "usemtl red\r\ns off\r\nf 1/1/1 2/1 3//1 \r\nl 1 2\r\np 3\r\ng c\r\nf 1 2 3");
  ASSERT_EQ(obj.soup.positions.count(), 3);
  EXPECT_EQ(obj.soup.positions[1], Vec3(1, 0, 0));
  const Array<Triangle> triangles = {{0, 1, 2}, {0, 1, 2}};
  EXPECT_TRUE(obj.soup.triangles == triangles);
}

/// A number as printed by C's printf.
std::string printed(const char* format, double value) {
  char text[400];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

TEST(ReadObj, ReadsFacesOfMoreCornersThanAByteCounts) {
  // Tinyobjloader's reader of whole files counts corners in a byte in some versions.
  for (const int corners : {255, 256, 600}) {
    std::string text;
    std::string face = "f";
    for (int i = 0; i < corners; ++i) {
      const Vec2 p = unitVector(2 * kPi * i / corners);
      text += printed("v %.17g ", p.x()) + printed("%.17g 0\n", p.y());
      face += printed(" %.0f/1/1", i + 1);
    }
    EXPECT_EQ(readObj(text + face + "\n").soup.triangles.count(), corners - 2);
  }
}

/// Two triangles of a quad, and one more, in two groups of two materials.
const std::string kMarked =
    "o  box\ng left  side\nv 0 0 0 1 0 0.5\nv 1 0 0\nv 1 1 0 0 1 0 # green\nv 0 1 0 x 0 0\n"
    "v 2 0 0\nf 2 5 3\nusemtl dark wood\nf 1 2 3 4\ng right\nf 1 2 \\\n3\nf 1 2\no box\n"
    "g left side\nf 1 3 4\n";

TEST(ReadObj, ReportsPartsAndMaterials) {
  const ObjMarks marks = readObj(kMarked).marks;
  ASSERT_EQ(marks.parts.count(), 2);
  EXPECT_EQ(marks.parts[0].name, "box, left side");
  EXPECT_EQ(marks.parts[0].triangles, 4);
  EXPECT_EQ(marks.parts[1].name, "box, right");
  EXPECT_EQ(marks.parts[1].triangles, 1);
  EXPECT_EQ(marks.part, (Array<int>{0, 0, 0, 1, 0}));
  EXPECT_EQ(marks.materials, (Array<std::string>{"dark wood"}));
  EXPECT_EQ(marks.material, (Array<int>{-1, 0, 0, 0, 0}));
  const ObjMarks plain = readObj(kThree + "f 1 2 3\n").marks;
  ASSERT_EQ(plain.parts.count(), 1);
  EXPECT_EQ(plain.parts[0].name, "mesh");
  EXPECT_TRUE(plain.part.empty() && plain.material.empty() && plain.materials.empty());
}

TEST(ReadObj, ReportsColorsOfVertices) {
  EXPECT_EQ(readObj(kMarked).marks.colors,
            (Array<uint8_t>{255, 0, 128, 255, 255, 255, 0, 255, 0,  //
                            255, 255, 255, 255, 255, 255}));
  EXPECT_EQ(readObj("v 0 0 0 255 1 -3\nv 1 0 0 0 0 300\nv 0 1 0 1 2\nf 1 2 3\n").marks.colors,
            (Array<uint8_t>{255, 1, 0, 0, 0, 255, 255, 255, 255}));
  EXPECT_TRUE(readObj(kThree + "f 1 2 3\n").marks.colors.empty());
}

TEST(ReadObj, ReadsTheChosenParts) {
  const ObjContents right = readObj(kMarked, {true, Array<int>{1}});
  EXPECT_TRUE(right.soup.triangles == (Array<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(right.marks.parts.count(), 2);
  EXPECT_EQ(right.marks.parts[0].triangles, 4);
  EXPECT_EQ(right.marks.part, (Array<int>{1}));
  EXPECT_EQ(right.leftOut, 1);
  EXPECT_EQ(right.firstLineLeftOut, 14);
  EXPECT_EQ(readObj(kMarked, {true, Array<int>{0}}).leftOut, 0);
  for (const int part : {-1, 2}) {
    try {
      readObj(kMarked, {true, Array<int>{part}});
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).ends_with("the file has 2, numbered from 0"));
    }
  }
  // The error names the line of a polygon that cannot be cut, whatever precedes it.
  try {
    readObj(kThree + "v 1 1 0\nf 1 2 4 3\ng b\nf 1 2 2 3\n", {false, Array<int>{1}});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("line 7:")) << error.what();
  }
}

TEST(ReadObj, ReadsEveryLineEnd) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const ObjContents obj =
        readObj("v 0 0 0" + end + "v 1 0 0" + end + "v 0 1 0" + end + "f 1 2 3" + end);
    EXPECT_EQ(obj.soup.triangles.count(), 1);
  }
}

TEST(ReadObj, ReadsNumbersInEveryNotation) {
  const ObjContents obj = readObj("v +1.5 -.25 2.\nv 1e3 2.5E-2 -1.e+1\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(obj.soup.positions[0], Vec3(1.5, -0.25, 2));
  EXPECT_EQ(obj.soup.positions[1], Vec3(1000, 0.025, -10));
}

double coordinateOf(const std::string& decimal) {
  return readObj("v " + decimal + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").soup.positions[0].x();
}

/// The number of doubles between two of the same sign.
int64_t unitsApart(double a, double b) {
  int64_t i = 0;
  int64_t j = 0;
  std::memcpy(&i, &a, sizeof a);
  std::memcpy(&j, &b, sizeof b);
  return std::abs(i - j);
}

/// Coordinates are right within 10 units in the last place of the printed value; a million draws
/// have shown at most 8.
TEST(ReadObj, ReadsNumbersToTheLastPlaces) {
  const uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  int64_t worst = 0;
  for (int i = 0; i < (longRun() ? 200'000 : 5'000); ++i) {
    const int power = random.index(20) - 10;
    const double value = random.uniform(-1, 1) * std::pow(10.0, power);
    for (const char* format : {"%.17g", "%.16e", "%.20e"}) {
      const std::string text = printed(format, value);
      const int64_t units = unitsApart(coordinateOf(text), value);
      ASSERT_LE(units, 10) << text;
      worst = std::max(worst, units);
    }
    // The shortest notation: the fewest digits that restore the number.
    for (int digits = 1; digits <= 17; ++digits) {
      char text[40];
      std::snprintf(text, sizeof text, "%.*g", digits, value);
      ASSERT_LE(unitsApart(coordinateOf(text), std::strtod(text, nullptr)), 10) << text;
    }
  }
  // Some numbers must be inexact. Otherwise the test would prove nothing.
  EXPECT_GT(worst, 0);
  EXPECT_EQ(coordinateOf("-12.5"), -12.5);
}

TEST(ReadObj, ContinuesALineAfterABackslash) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const ObjContents obj =
        readObj("# not \\" + end + "v 0 0 0" + end + "v 1 \\" + end + "0 0" + end + "v 0 1 0" +
                end + "f 1\\" + end + "\\" + end + " 2 3 \\" + end);
    EXPECT_EQ(obj.soup.positions.count(), 3);
    EXPECT_EQ(obj.soup.positions[1], Vec3(1, 0, 0));
    ASSERT_EQ(obj.soup.triangles.count(), 1);
    EXPECT_EQ(obj.soup.triangles[0], Triangle(0, 1, 2));
    EXPECT_EQ(errorOf("v 0 \\" + end + "0 0" + end + "v 1 x 0"),
              "badFile: line 3: the coordinate 'x' is not a number");
  }
  EXPECT_EQ(errorOf("v 0 0 1\\2\n"), "badFile: line 1: the coordinate '1\\2' is not a number");
}

TEST(ReadObj, CountsNegativeIndicesFromTheLastVertexSoFar) {
  const ObjContents obj = readObj(kThree + "f -3 -2 -1\nv 1 1 0\nf -2 -3 -1\n");
  const Array<Triangle> triangles = {{0, 1, 2}, {2, 1, 3}};
  EXPECT_TRUE(obj.soup.triangles == triangles);
}

TEST(ReadObj, AllowsFacesBeforeTheirVertices) {
  EXPECT_EQ(readObj("f 1 2 3\nf 1 2 4 3\n" + kThree + "v 1 1 0\n").soup.triangles.count(), 3);
}

TEST(ReadObj, NamesTheLineOfABadVertex) {
  EXPECT_EQ(errorOf("v 0 0 0\nv 1 nan 0\n"),
            "notFinite: line 2: the coordinate 'nan' of vertex 1 is not finite");
  EXPECT_EQ(errorOf("v -inf 0 0\n"),
            "notFinite: line 1: the coordinate '-inf' of vertex 0 is not finite");
  for (const std::string word :
       {"NaN", "+nan", "-nan(ind)", "Infinity", "INF", "1.#QNAN", "-1.#INF"}) {
    EXPECT_EQ(errorOf("v 0 0 " + word + "\n").substr(0, 10), "notFinite:") << word;
  }
  EXPECT_EQ(errorOf("# ok\r\nv 0 1,5 0\r\n"),
            "badFile: line 2: the coordinate '1,5' is not a number");
  for (const std::string word :
       {"x", "1.5x", "0x10", "--1", ".", "1e", "e5", "1e+", "+", "1.2.3", "1e9999999999"}) {
    EXPECT_EQ(errorOf("v 0 0 " + word + "\n"),
              "badFile: line 1: the coordinate '" + word + "' is not a number");
  }
  EXPECT_EQ(errorOf("v 0 0\n"), "badFile: line 1: a vertex needs three coordinates");
  EXPECT_EQ(errorOf("v\n"), "badFile: line 1: a vertex needs three coordinates");
}

TEST(ReadObj, NamesTheLineOfABadFace) {
  EXPECT_EQ(
      errorOf(kThree + "f 1 2 3\nf 1 2 4\n"),
      "badIndex: line 5: the face uses vertex 4, but the file has 3 vertices (OBJ numbers them "
      "from 1)");
  EXPECT_EQ(errorOf(kThree + "f 0 1 2\n").substr(0, 41),
            "badIndex: line 4: the face uses vertex 0,");
  EXPECT_EQ(errorOf("v 0 0 0\nf -1 -2 -3\n"),
            "badIndex: line 2: the face uses vertex -2, but so far the file has 1 vertex (OBJ "
            "numbers them from 1)");
  EXPECT_EQ(errorOf(kThree + "f 1 2 99999999999999999999\n").substr(0, 9), "badIndex:");
  EXPECT_EQ(errorOf(kThree + "f 1 2 2147483649\n").substr(0, 9), "badIndex:");
  EXPECT_EQ(errorOf(kThree + "f 1 2 x\n"), "badFile: line 4: 'x' is not the number of a vertex");
  EXPECT_EQ(errorOf(kThree + "f 1 2 3.5\n"),
            "badFile: line 4: '3.5' is not the number of a vertex");
  EXPECT_EQ(errorOf(kThree + "f 1 2 3/1//1\n"),
            "badFile: line 4: '3/1//1' is not the number of a vertex");
  EXPECT_EQ(errorOf(kThree + "f 1 2\n"), "badFile: line 4: a face needs three corners");
  EXPECT_EQ(errorOf(kThree + "f \n"), "badFile: line 4: a face needs three corners");
}

TEST(ReadObj, RefusesFilesThatAreNotObj) {
  EXPECT_EQ(errorOf(""), "badFile: the file has no faces");
  EXPECT_EQ(errorOf(kThree), "badFile: the file has no faces");
  EXPECT_EQ(errorOf("<!doctype html><html></html>"), "badFile: the file has no faces");
  EXPECT_EQ(errorOf(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)),
            "badFile: the file is not text: an OBJ file has no zero bytes");
  EXPECT_EQ(errorOf("\xff\xfe\x80\x81\xffv\xff\n\xff"), "badFile: the file has no faces");
}

TEST(ReadObj, QuotesJunkWithPrintableCharactersOnly) {
  EXPECT_EQ(errorOf("v 0 0 \x01g\xff\n"), "badFile: line 1: the coordinate '?g?' is not a number");
}

/// Every file leads to an error, or to a soup whose triangles have vertices.
TEST(ReadObj, SurvivesDamagedFiles) {
  const std::string sound =
      "# a cube's corner\nmtllib a.mtl\no x\ng y z\nv 0 0 0\nv 1.5e0 0 -0\nv 0 1 0 1\nvn 0 0 1\n"
      "vt 0 1\nv 1 1 .5\nusemtl m\ns 1\nf 1/1/1 2//1 3/1\nf -1 3 1 2\nl 1 2\nt a 1/1/1 2 3 b\n";
  const std::string alphabet = "vfgot#-+./e019 \t\r\n\\x\xff";
  Random random(20);
  int read = 0;
  for (int i = 0; i < 10'000; ++i) {
    std::string text = sound;
    const auto place = [&] {
      return static_cast<size_t>(random.index(static_cast<int>(text.size())));
    };
    for (int edits = 1 + random.index(2); edits > 0; --edits) {
      const char c = alphabet[static_cast<size_t>(random.index(static_cast<int>(alphabet.size())))];
      switch (random.index(3)) {
        case 0:
          text[place()] = c;
          break;
        case 1:
          text.insert(place(), 1, c);
          break;
        default:
          text.erase(place(), 1);
      }
    }
    try {
      const ObjContents obj = readObj(text);
      ++read;
      for (const Triangle& t : obj.soup.triangles) {
        ASSERT_GE(t.minCoeff(), 0) << text;
        ASSERT_LT(t.maxCoeff(), obj.soup.positions.count()) << text;
      }
    } catch (const Error& error) {
      ASSERT_NE(error.what(), std::string());
    }
  }
  EXPECT_GT(read, 1000);
}

/*  3---2
    |   |    with 3 pulled in to (0.4, 0.4): the diagonal 0-2 would leave the square,
    0---1    1-3 stays inside                                                            */
TEST(ReadObj, CutsQuadsAlongTheDiagonalInside) {
  const ObjContents square = readObj(kThree + "v 1 1 0\nf 1 2 4 3\n");
  EXPECT_EQ(square.polygonsCut, 1);
  EXPECT_EQ(square.soup.triangles.count(), 2);

  const ObjContents dart = readObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.6 0.4 0\nf 1 2 3 4\n");
  for (const Triangle& t : dart.soup.triangles) {
    const Vec3& a = dart.soup.positions[t[0]];
    EXPECT_GT((dart.soup.positions[t[1]] - a).cross(dart.soup.positions[t[2]] - a).z(), 0);
  }
}

TEST(ReadObj, NamesThePolygonThatCannotBeCut) {
  EXPECT_EQ(errorOf(kThree + "v 1 1 0\nf 1 2 4 3\nf 1 2 2 3\n", false),
            "degenerateFace: line 6: the face with 4 corners cannot be cut into triangles: it "
            "crosses itself or has no area");
  std::string same = "f";
  std::string large = "f";
  for (int i = 0; i <= kMostPolygonCorners; ++i) {
    same += " 1";
    large += i % 2 == 0 ? " 1" : " 2";
  }
  const std::string error = " corners is too large: at most 10000 are cut";
  const std::string start = "degenerateFace: line 4: the face with ";
  EXPECT_EQ(errorOf(kThree + large + " 3"), start + "10002" + error);
  EXPECT_EQ(errorOf(kThree + same, false), start + "10001" + error);
}

TEST(ReadObj, MergesARepeatedVertexOfAPolygon) {
  const ObjContents quad = readObj(kThree + "f 1 2 2 3\n");
  EXPECT_EQ(quad.repeatedCorners, 1);
  EXPECT_EQ(quad.polygonsCut, 0);
  EXPECT_TRUE(quad.soup.triangles == (Array<Triangle>{{0, 1, 2}}));
  // The repeated vertex is at the end of the list, and the polygon is still valid.
  const ObjContents more = readObj(kThree + "v 1 1 0\nf 1 1 2 4 3 1\nf 2 2 2 2\n");
  EXPECT_EQ(more.repeatedCorners, 1);
  EXPECT_EQ(more.polygonsCut, 1);
  EXPECT_EQ(more.soup.triangles.count(), 3);
  EXPECT_EQ(more.soup.triangles[2], Triangle(1, 1, 1));
}

TEST(ReadObj, CutsAPolygonOnALineIntoTrianglesWithoutArea) {
  const std::string line = kThree + "v 2 0 0\nv 3 0 0\nf 1 2 3\nf 1 2 4 5\n";
  EXPECT_EQ(readObj(line).soup.triangles.count(), 3);
  EXPECT_EQ(errorOf(line, false).substr(0, 15), "degenerateFace:");
}

/// A five-pointed star with crossing sides, which cannot be cut into triangles.
const std::string kCrossing = "v 0 3 0\nv 2 -3 0\nv -3 1 0\nv 3 1 0\nv -2 -3 0\nf 1 2 3 4 5\n";

TEST(ReadObj, CutsAQuadThatCrossesItselfAlongItsShorterDiagonal) {
  // The diagonal from 0 to 2 has length 1, that from 1 to 3 length 2.
  const std::string quad = "v 0 0 0\nv 2 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n";
  const ObjContents obj = readObj(quad);
  EXPECT_TRUE(obj.soup.triangles == (Array<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(obj.polygonsCut, 1);
  EXPECT_EQ(obj.leftOut, 0);
  EXPECT_EQ(errorOf(quad, false).substr(0, 15), "degenerateFace:");
}

TEST(ReadObj, LeavesOutPolygonsThatCannotBeCut) {
  const ObjContents obj = readObj(kCrossing + "f 1 2 3\nf 5 4 3 2 1\nf 1 5\n");
  EXPECT_TRUE(obj.soup.triangles == (Array<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(obj.leftOut, 3);
  EXPECT_EQ(obj.firstLineLeftOut, 6);
  EXPECT_EQ(errorOf(kCrossing).substr(0, 23), "degenerateFace: line 6:");
  EXPECT_EQ(errorOf(kCrossing + "f 1 2 3\n", false).substr(0, 23), "degenerateFace: line 6:");
  const ImportedMesh mesh = importObj(kCrossing + "f 1 2 3\n");
  ASSERT_FALSE(mesh.repairs.empty());
  EXPECT_EQ(mesh.repairs[0].kind, Repair::Kind::kLeftOut);
  EXPECT_EQ(mesh.repairs[0].sentence,
            "1 face was left out: it has fewer than three corners, crosses itself or has no area "
            "(the first: line 6)");
}

TEST(ReadObj, LeavesOutFacesOfOneOrTwoCorners) {
  const ObjContents obj = readObj("v 9 9 9\nf 1\n" + kThree + "f 2 3\nf -3 -2 -1\nf\n");
  EXPECT_TRUE(obj.soup.triangles == (Array<Triangle>{{1, 2, 3}}));
  EXPECT_EQ(obj.leftOut, 3);
  EXPECT_EQ(obj.firstLineLeftOut, 2);
  EXPECT_EQ(errorOf(kThree + "f 1 2 3\nf 1 2\n", false),
            "badFile: line 5: a face needs three corners");
  EXPECT_EQ(errorOf(kThree + "f 1 2 3\nf 1 9\n").substr(0, 9), "badIndex:");
}

TEST(ImportPolygons, GivesTheMeshOfTheSameObjFile) {
  PolygonSoup soup;
  for (const auto& [x, y] : {std::pair{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}) {
    soup.positions.emplace_back(x, y, 0);
  }
  soup.corners = {0, 2, 4, 1, 3, 0, 1, 2, 3, 4};
  soup.cornerCount = {5, 5};
  const ImportedMesh mesh = importPolygons(soup);
  const ImportedMesh wanted = importObj(kCrossing + "f 1 3 5 2 4\n");
  EXPECT_EQ(mesh.mesh.faceCount(), 3);
  EXPECT_EQ(mesh.mesh.faceCount(), wanted.mesh.faceCount());
  ASSERT_EQ(mesh.repairs.count(), 2);
  EXPECT_EQ(mesh.repairs[1].kind, Repair::Kind::kLeftOut);
  EXPECT_TRUE(mesh.repairs[1].sentence.ends_with("(the first: face 1)"));
  const auto error = [&](const PolygonSoup& bad) -> std::string {
    try {
      importPolygons(bad);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  PolygonSoup bad = soup;
  bad.corners[7] = 5;
  EXPECT_EQ(error(bad), "face 1 uses vertex 5, but the mesh has 5");
  bad = soup;
  bad.cornerCount[0] = 2;
  EXPECT_EQ(error(bad), "face 0 must have at least 3 corners, not 2");
  bad = soup;
  bad.cornerCount[0] = 6;
  EXPECT_EQ(error(bad), "the faces have 11 corners, but 10 are given");
  bad = soup;
  bad.positions[2].x() = std::nan("");
  EXPECT_TRUE(error(bad).starts_with("vertex 2 has a coordinate"));
}

TEST(ReadObj, LeavesAVertexThatIsNoNumberWhereNoFaceUsesIt) {
  const std::string text = "v 0 0 0\nv nan 0 -inf\nv 1 0 0\nv 0 1 0\n";
  const ObjContents obj = readObj(text + "f 1 3 4\n");
  EXPECT_EQ(obj.soup.positions.count(), 4);
  EXPECT_TRUE(std::isnan(obj.soup.positions[1].x()));
  const std::string error = "notFinite: line 2: the coordinate 'nan' of vertex 1 is not finite";
  EXPECT_EQ(errorOf(text + "f 1 3 4\n", false), error);
  EXPECT_EQ(errorOf(text + "f 1 3 4\nf 1 2 3\n"), error);
}

TEST(ReadObj, ChecksTheCoordinatesOfUsedVerticesOnly) {
  for (const std::string far : {"1e31", "1e999"}) {
    for (const std::string unused : {"", "v nan 0 0\n"}) {
      const std::string text = kThree + "v " + far + " 0 0\n" + unused;
      const ImportedMesh mesh = importObj(text + "f 1 2 3\n");
      ASSERT_EQ(mesh.repairs.count(), 1);
      EXPECT_EQ(mesh.repairs[0].kind, Repair::Kind::kDropped);
      const std::string code = far == "1e31" ? "badArgument: " : "notFinite: ";
      EXPECT_TRUE(errorOf(text + "f 1 2 3\nf 1 2 4 3\n").starts_with(code + "vertex 3 "));
      EXPECT_NE(errorOf(text + "f 1 2 3\n", false), "") << "not mended";
    }
  }
}

TEST(ReadObj, LeavesOutComments) {
  const ObjContents obj = readObj(
      "v 0 0 0 # a\nv 1 0 0 # b \\\nv 0 1 0 #\n#f 1 2 9\nf 1 2 3 # comment 4\nf 1 \\\n2 3 # x\n");
  EXPECT_EQ(obj.soup.positions.count(), 3);
  EXPECT_TRUE(obj.soup.triangles == (Array<Triangle>{{0, 1, 2}, {0, 1, 2}}));
  EXPECT_EQ(errorOf("v 0 0 # 1\n"), "badFile: line 1: a vertex needs three coordinates");
}

double doubleArea(const Array<Vec3>& corners, const Triangle& t) {
  return (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]).z();
}

double areaOf(const Array<Vec3>& corners, const Array<Triangle>& triangles) {
  double area = 0;
  for (const Triangle& t : triangles) {
    EXPECT_GT(doubleArea(corners, t), 0);
    area += doubleArea(corners, t) / 2;
  }
  return area;
}

/// A square of side 4 with a square hole of side 2, joined by a bridge at any of its corners, in
/// every orientation.
TEST(CutPolygon, CutsAFaceWhoseHoleABridgeJoins) {
  const Array<Vec2> outer = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const Array<Vec2> hole = {{1, 1}, {1, 3}, {3, 3}, {3, 1}};
  const int opposite[4] = {0, 3, 2, 1};
  for (int start = 0; start < 4; ++start) {
    for (int turn = 0; turn < 7; ++turn) {
      Array<Vec3> ring;
      const double angle = 0.3 * turn;
      const auto add = [&](const Vec2& p) {
        ring.emplace_back(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                          std::sin(angle) * p.x() + std::cos(angle) * p.y(), 0);
      };
      for (int i = 0; i <= 4; ++i) add(outer[(start + i) % 4]);
      for (int i = 0; i <= 4; ++i) add(hole[(opposite[start] + i) % 4]);
      const Array<Triangle> triangles = cutPolygon(ring);
      ASSERT_EQ(triangles.count(), 8) << start << ' ' << turn;
      EXPECT_NEAR(areaOf(ring, triangles), 12, 1e-12);
    }
  }
}

/// A wheel of 24 teeth with a hole of 24 corners.
TEST(CutPolygon, CutsACoggedRing) {
  Array<Vec3> ring;
  double area = 0;
  const int n = 48;
  const auto at = [](double radius, int i) {
    // The ends of the bridge are identical to the last bit, as if they were one vertex.
    const Vec2 p = radius * unitVector(2 * kPi * (i % n) / n);
    return Vec3(p.x(), p.y(), 1);
  };
  const auto radius = [](int i) { return i % n / 2 % 2 == 0 ? 2.0 : 1.7; };
  for (int i = 0; i <= n; ++i) ring.push_back(at(radius(i), i));
  for (int i = n; i >= 0; i -= 2) ring.push_back(at(1, i));
  for (int i = 0; i < n; ++i) {
    area += radius(i) * radius(i + 1) * std::sin(2 * kPi / n) / 2;
    if (i % 2 == 0) area -= std::sin(4 * kPi / n) / 2;
  }
  const Array<Triangle> triangles = cutPolygon(ring);
  ASSERT_EQ(triangles.count(), ring.count() - 2);
  EXPECT_NEAR(areaOf(ring, triangles), area, 1e-12);
}

/// A star with 9 points, far from the origin; every second corner lies inwards.
TEST(CutPolygon, KeepsTheAreaOfPolygonsThatAreNotConvex) {
  Array<Vec3> star;
  for (int i = 0; i < 18; ++i) {
    const Vec2 p = (i % 2 == 0 ? 1 : 0.3) * unitVector(kPi * i / 9);
    star.emplace_back(p.x() - 5, p.y() + 3, 2);
  }
  const Array<Triangle> triangles = cutPolygon(star);
  ASSERT_EQ(triangles.count(), 16);
  double area = 0;
  for (const Triangle& t : triangles) {
    EXPECT_GT(doubleArea(star, t), 0);
    area += doubleArea(star, t) / 2;
  }
  // 18 triangles from the center with sides 1 and 0.3 at an angle of pi / 9.
  EXPECT_NEAR(area, 9 * 0.3 * std::sin(kPi / 9), 1e-12);
}

TEST(CutPolygon, KeepsTheAreaOfThePolygonWithMostCorners) {
  Array<Vec3> star;
  for (int i = 0; i < kMostPolygonCorners; ++i) {
    const Vec2 p = (i % 2 == 0 ? 1 : 0.9) * unitVector(2 * kPi * i / kMostPolygonCorners);
    star.emplace_back(p.x(), p.y(), 0);
  }
  const Array<Triangle> triangles = cutPolygon(star);
  ASSERT_EQ(triangles.count(), kMostPolygonCorners - 2);
  double area = 0;
  for (const Triangle& t : triangles) area += doubleArea(star, t) / 2;
  EXPECT_NEAR(area, kMostPolygonCorners * 0.45 * std::sin(2 * kPi / kMostPolygonCorners), 1e-10);
}

TEST(CutPolygon, CopesWithCornersOnALine) {
  // A square with a corner in the middle of each side.
  const Array<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                              {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  const Array<Triangle> triangles = cutPolygon(square);
  ASSERT_EQ(triangles.count(), 6);
  for (const Triangle& t : triangles) EXPECT_GT(doubleArea(square, t), 0.1);
}

TEST(CutPolygon, RefusesPolygonsThatCrossThemselvesOrHaveNoArea) {
  EXPECT_TRUE(cutPolygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1.5, 0}}).empty());
  EXPECT_TRUE(cutPolygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).empty());
}

}  // namespace
}  // namespace karcher
