#pragma once

#include <string>
#include <string_view>

#include "mesh/types.h"

namespace karcher {

/// Cuts the next line off the front of `text`, without its end (\n, \r or both) and without a
/// comment, from a # that starts a word on. A backslash at the end of a line, unless it is in a
/// comment, continues it on the next: line ends are then inside it.
std::string_view takeObjLine(std::string_view& text);

/// Cuts the next word off the front of `line`, which may be continued; empty at its end.
std::string_view takeObjWord(std::string_view& line);

/// Whether it is a decimal number, as 1, -.5 or 2.e-3.
bool isDecimalNumber(std::string_view word);

/// A vertex with a coordinate that is no number, as nan or inf.
struct NotFinite {
  int vertex;
  int line;  ///< from 1
  std::string sentence;
};

/// What a check of an OBJ file's lines learns about it.
struct ObjLines {
  int vertices = 0;
  int faces = 0;
  Array<int> polygonLines;     ///< for each face with more than three corners, its line from 1
  Array<int> shortLines;       ///< those of faces with fewer than three corners, which are no faces
  Array<NotFinite> notFinite;  ///< in the file's order
};

/// Checks that every vertex line has three decimal numbers, or some that are not finite, and that
/// every face line names vertices of the file. Throws Error as `readObj` does.
ObjLines checkObjLines(std::string_view text);

/// That the face in that line has too few corners, as a sentence.
std::string shortFace(int line);

}  // namespace karcher
