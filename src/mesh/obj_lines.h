#pragma once

#include <string_view>

#include "mesh/types.h"

namespace karcher {

/// Cuts the next line off the front of `text`, without its end: \n, \r or both. A backslash at the
/// end of a line, unless it is a comment, continues it on the next: line ends are then inside it.
std::string_view takeObjLine(std::string_view& text);

/// Cuts the next word off the front of `line`, which may be continued; empty at its end.
std::string_view takeObjWord(std::string_view& line);

/// What a check of an OBJ file's lines learns about it.
struct ObjLines {
  int vertices = 0;
  int faces = 0;
  Array<int> polygonLines;  ///< for each face with more than three corners, its line from 1
};

/// Checks that every vertex line has three finite decimal numbers and that every face line names
/// three or more of the file's vertices. Throws Error as `readObj` does.
ObjLines checkObjLines(std::string_view text);

}  // namespace karcher
