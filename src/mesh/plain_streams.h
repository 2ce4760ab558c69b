#pragma once

#include <cassert>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <istream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <streambuf>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// The streams that tinyobjloader uses. If KARCHER_PLAIN_STREAMS is defined, they are classes with
/// only the interface that tinyobjloader needs; else they are the standard streams. The standard
/// streams link all locales with their formats of dates and money: 34 KB of the compressed
/// WebAssembly module.
namespace karcher::plain {

using namespace std;  // NOLINT(google-build-using-namespace): all but the streams is standard

#ifdef KARCHER_PLAIN_STREAMS

struct ios {
  enum State { eofbit };
};

class streambuf {
 public:
  using int_type = int;
  using traits_type = char_traits<char>;

  streambuf() = default;
  streambuf(const streambuf&) = delete;
  streambuf& operator=(const streambuf&) = delete;
  virtual ~streambuf() = default;

  int sgetc() { return next_ < end_ ? traits_type::to_int_type(*next_) : underflow(); }
  int sbumpc() {
    const int character = sgetc();
    if (character != traits_type::eof()) ++next_;
    return character;
  }

 protected:
  virtual int underflow() { return traits_type::eof(); }
  void setg(char* /*begin*/, char* next, char* end) {
    next_ = next;
    end_ = end;
  }

 private:
  char* next_ = nullptr;
  char* end_ = nullptr;
};

class stringbuf : public streambuf {
 public:
  explicit stringbuf(string text) : text_(std::move(text)) {
    setg(text_.data(), text_.data(), text_.data() + text_.size());
  }

 private:
  string text_;
};

class istream {
 public:
  struct sentry {
    sentry(istream& /*stream*/, bool /*noSkip*/) {}
    explicit operator bool() const { return true; }
  };

  explicit istream(streambuf* buffer) : buffer_(buffer) {}
  streambuf* rdbuf() const { return buffer_; }
  int peek() { return buffer_->sgetc(); }
  void setstate(ios::State /*state*/) {}
  explicit operator bool() const { return buffer_ != nullptr; }
  bool operator!() const { return buffer_ == nullptr; }

 private:
  streambuf* buffer_;
};

/// A file that never opens, since the engine reads no files.
struct ifstream : istream {
  explicit ifstream(const char* /*name*/) : istream(nullptr) {}
};

/// A stream without text. Tinyobjloader would read a list of folders from it.
struct istringstream {
  explicit istringstream(const string& /*text*/) {}
};
inline bool getline(istringstream& /*stream*/, string& /*text*/, char /*separator*/) {
  return false;
}

class stringstream {
 public:
  template <class Value>
  stringstream& operator<<(const Value& value) {
    if constexpr (is_arithmetic_v<Value>) {
      text_ += to_string(value);
    } else {
      text_ += value;
    }
    return *this;
  }
  const string& str() const { return text_; }

 private:
  string text_;
};

#endif

}  // namespace karcher::plain
