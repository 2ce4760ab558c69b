#include "mesh/obj_lines.h"

#include <algorithm>
#include <string>

#include "mesh/error.h"

namespace karcher {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\t'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLineEnd(char c) { return c == '\n' || c == '\r'; }

/// The largest number of digits of an exponent, which then fits an integer. No sensible number has
/// a longer exponent.
constexpr size_t kMostExponentDigits = 9;

size_t countDigits(std::string_view word, size_t from) {
  size_t end = from;
  while (end < word.size() && isDigit(word[end])) ++end;
  return end - from;
}

/// The length of the line end at `from`: 1 or 2, or 0 without a line end.
size_t lineEnd(std::string_view text, size_t from) {
  if (from == text.size() || !isLineEnd(text[from])) return 0;
  return text[from] == '\r' && from + 1 < text.size() && text[from + 1] == '\n' ? 2 : 1;
}

/// Whether a comment starts here. A # inside a word is a part of the word.
bool startsComment(std::string_view text, size_t at) {
  return text[at] == '#' && (at == 0 || isSpace(text[at - 1]) || isLineEnd(text[at - 1]));
}

/// The number of line ends inside a continued line.
int countLineEnds(std::string_view line) {
  int count = 0;
  for (size_t i = line.find('\\'); i < line.size(); ++i) {
    const size_t end = lineEnd(line, i);
    if (end == 0) continue;
    ++count;
    i += end - 1;
  }
  return count;
}

/// The length of the separator at `from`: a blank, or a backslash and the end of its line.
size_t gap(std::string_view line, size_t from) {
  if (isSpace(line[from])) return 1;
  const size_t end = line[from] == '\\' ? lineEnd(line, from + 1) : 0;
  return end == 0 ? 0 : 1 + end;
}

/// Whether the word stands for a number that is not finite: nan, inf or infinity, as C and Python
/// print them, or a word that begins with 1.#, such as 1.#INF.
bool isNotFinite(std::string_view word) {
  std::string lower(word.substr(word.find_first_not_of("+-") == 1 ? 1 : 0));
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower.starts_with("nan") || lower.starts_with("-nan") || lower == "inf" ||
         lower == "infinity" || lower.starts_with("1.#");
}

/// A word quoted for an error: at most 20 characters, each of them printable.
std::string quoted(std::string_view word) {
  std::string result = "'";
  for (const char c : word.substr(0, 20)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (word.size() > 20 ? "...'" : "'");
}

class LineCheck {
 public:
  ObjLines check(std::string_view text) {
    while (!text.empty()) {
      ++line_;
      const std::string_view line = takeObjLine(text);
      checkLine(line);
      line_ += countLineEnds(line);
    }
    if (found_.faces == 0) {
      if (!found_.notFinite.empty()) fail(ErrorCode::kNotFinite, found_.notFinite[0].sentence);
      if (!found_.shortLines.empty()) fail(ErrorCode::kBadFile, shortFace(found_.shortLines[0]));
      fail(ErrorCode::kBadFile, "the file has no faces");
    }
    if (greatest_ > found_.vertices) {
      line_ = greatestLine_;
      failIndex(std::to_string(greatest_));
    }
    return std::move(found_);
  }

 private:
  void checkLine(std::string_view line) {
    const std::string_view keyword = takeObjWord(line);
    if (keyword == "v") {
      checkVertex(line);
    } else if (keyword == "f") {
      checkFace(line);
    } else if (keyword == "p" || keyword == "l" || keyword == "curv" || keyword == "curv2" ||
               keyword == "surf") {
      ++found_.otherElements;
    }
  }

  void checkVertex(std::string_view line) {
    bool finite = true;
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = takeObjWord(line);
      if (isDecimalNumber(word)) continue;
      if (word.empty()) fail(ErrorCode::kBadFile, place() + "a vertex needs three coordinates");
      if (isNotFinite(word)) {
        if (finite) {
          found_.notFinite.push_back({found_.vertices, line_,
                                      place() + "the coordinate " + quoted(word) + " of vertex " +
                                          std::to_string(found_.vertices) + " is not finite"});
        }
        finite = false;
        continue;
      }
      fail(ErrorCode::kBadFile, place() + "the coordinate " + quoted(word) + " is not a number");
    }
    ++found_.vertices;
  }

  void checkFace(std::string_view line) {
    int corners = 0;
    for (std::string_view word = takeObjWord(line); !word.empty(); word = takeObjWord(line)) {
      checkCorner(word);
      ++corners;
    }
    if (corners < 3) {
      found_.shortLines.push_back(line_);
      return;
    }
    if (corners > 3) found_.polygonLines.push_back(line_);
    ++found_.faces;
  }

  /// Checks a corner such as 7, 7/1 or 7//2. Only the first number matters, the number of a vertex.
  /// A negative number counts back from the latest vertex.
  void checkCorner(std::string_view word) {
    const size_t sign = word[0] == '-' || word[0] == '+' ? 1 : 0;
    const size_t digits = countDigits(word, sign);
    const size_t end = sign + digits;
    const auto slashes = std::count(word.begin(), word.end(), '/');
    if (digits == 0 || (end < word.size() && word[end] != '/') || slashes > 2) {
      fail(ErrorCode::kBadFile, place() + quoted(word) + " is not the number of a vertex");
    }
    constexpr size_t kMostDigits = 10;
    if (digits > kMostDigits) failIndex(std::string(word.substr(0, end)));
    int64_t index = 0;
    for (size_t i = sign; i < end; ++i) index = 10 * index + (word[i] - '0');
    const bool back = word[0] == '-';
    if (index == 0 || (back && index > found_.vertices))
      failIndex(std::string(word.substr(0, end)));
    if (!back && index > greatest_) {
      greatest_ = index;
      greatestLine_ = line_;
    }
  }

  std::string place() const { return "line " + std::to_string(line_) + ": "; }

  [[noreturn]] void failIndex(const std::string& index) const {
    fail(ErrorCode::kBadIndex, place() + "the face uses vertex " + index + ", but " +
                                   (index[0] == '-' ? "so far the file has " : "the file has ") +
                                   std::to_string(found_.vertices) +
                                   (found_.vertices == 1 ? " vertex" : " vertices") +
                                   " (OBJ numbers them from 1)");
  }

  [[noreturn]] static void fail(ErrorCode code, const std::string& sentence) {
    throw Error(code, sentence);
  }

  ObjLines found_;
  int line_ = 0;
  int64_t greatest_ = 0;  ///< the greatest vertex number that a face has used, and its line
  int greatestLine_ = 0;
};

}  // namespace

std::string_view takeObjLine(std::string_view& text) {
  size_t end = 0;
  while (true) {
    while (end < text.size() && !isLineEnd(text[end]) && !startsComment(text, end)) ++end;
    const size_t length = lineEnd(text, end);
    if (length == 0 || end == 0 || text[end - 1] != '\\') break;
    end += length;
  }
  const std::string_view line = text.substr(0, end);
  while (end < text.size() && !isLineEnd(text[end])) ++end;
  text.remove_prefix(end + lineEnd(text, end));
  return line;
}

std::string_view takeObjWord(std::string_view& line) {
  size_t begin = 0;
  while (begin < line.size()) {
    const size_t blank = gap(line, begin);
    if (blank == 0) break;
    begin += blank;
  }
  size_t end = begin;
  // Fast path: most characters obviously belong to a word.
  while (end < line.size() && ((line[end] > ' ' && line[end] != '\\') || gap(line, end) == 0))
    ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

// The grammar is: sign? (digits (. digits?)? | . digits) (e sign? digits)?
bool isDecimalNumber(std::string_view word) {
  const auto isSign = [&](size_t i) {
    return i < word.size() && (word[i] == '+' || word[i] == '-');
  };
  size_t i = isSign(0) ? 1 : 0;
  size_t digits = countDigits(word, i);
  i += digits;
  if (i < word.size() && word[i] == '.') {
    const size_t decimals = countDigits(word, ++i);
    i += decimals;
    digits += decimals;
  }
  if (digits == 0) return false;
  if (i < word.size() && (word[i] == 'e' || word[i] == 'E')) {
    ++i;
    if (isSign(i)) ++i;
    const size_t exponent = countDigits(word, i);
    if (exponent == 0 || exponent > kMostExponentDigits) return false;
    i += exponent;
  }
  return i == word.size();
}

std::string shortFace(int line) {
  return "line " + std::to_string(line) + ": a face needs three corners";
}

ObjLines checkObjLines(std::string_view text) { return LineCheck().check(text); }

}  // namespace karcher
