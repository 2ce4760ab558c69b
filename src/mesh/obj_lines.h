#pragma once

#include <string>
#include <string_view>

#include "mesh/types.h"

namespace karcher {

/// Cuts the next line off the front of `text`. Returns it without its line end (\n, \r or both) and
/// without its comment. A comment begins at a # that starts a word. A backslash at the end of a
/// line continues the line on the next line, unless the backslash is in a comment. A continued line
/// is returned with its inner line ends.
std::string_view takeObjLine(std::string_view& text);

/// Cuts the next word off the front of `line`, which may continue on other lines. Returns an empty
/// word at the end.
std::string_view takeObjWord(std::string_view& line);

/// Whether the word is a decimal number such as 1, -.5 or 2.e-3.
bool isDecimalNumber(std::string_view word);

/// A vertex with a coordinate that is not finite, such as nan or inf.
struct NotFinite {
  int vertex;
  int line;  ///< the number of the line, from 1
  std::string sentence;
};

/// The result of a check of an OBJ file's lines.
struct ObjLines {
  int vertices = 0;
  int faces = 0;
  Array<int> polygonLines;     ///< the lines of faces with more than three corners, from 1
  Array<int> shortLines;       ///< the lines of faces with fewer than three corners
  Array<NotFinite> notFinite;  ///< the vertices in the file's order
  int otherElements = 0;       ///< the number of points, lines, curves and surfaces
};

/// Checks that every vertex line has three numbers (decimal or not finite) and that every face line
/// names vertices of the file. Throws what `readObj` throws.
ObjLines checkObjLines(std::string_view text);

/// An error message: the face in this line has too few corners.
std::string shortFace(int line);

}  // namespace karcher
