#include "meshes/formats/parsing.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <utility>

#include "meshes/messages.h"

namespace geodesic {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

// Returns the next occurrence of a character, or the end.
const char* find(const char* begin, const char* end, char c) {
  if (begin == end) return end;
  const void* const found = std::memchr(begin, c, static_cast<std::size_t>(end - begin));
  return found == nullptr ? end : static_cast<const char*>(found);
}

// std::from_chars does not take a plus sign.
std::string_view without_plus(std::string_view word) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
  return plus ? word.substr(1) : word;
}

template <class Number>
std::errc parse(std::string_view word, Number& value) {
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc() && rest != word.data() + word.size()) return std::errc::invalid_argument;
  return error;
}

}  // namespace

std::string_view text_of(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) {
    throw MeshError(name + ": the text is UTF-16; save it as UTF-8");
  }
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return bytes.starts_with(kMark) ? bytes.substr(kMark.size()) : bytes;
}

TextReader::TextReader(std::string_view text, std::string name, TextRules rules)
    : name_(std::move(name)),
      rules_(rules),
      next_(text.data()),
      end_(text.data() + text.size()),
      line_feed_(find(next_, end_, '\n')),
      carriage_return_(find(next_, end_, '\r')),
      rest_(text.substr(0, 0)) {}

std::string_view TextReader::take_physical_line() {
  const char* const begin = next_;
  if (line_feed_ < begin) line_feed_ = find(begin, end_, '\n');
  if (carriage_return_ < begin) carriage_return_ = find(begin, end_, '\r');
  const char* const stop = std::min(line_feed_, carriage_return_);
  next_ = stop;
  if (next_ != end_ && *next_++ == '\r' && next_ != end_ && *next_ == '\n') ++next_;
  ++next_line_;
  return {begin, static_cast<std::size_t>(stop - begin)};
}

bool TextReader::next_line() {
  while (next_ != end_) {
    line_ = next_line_;
    std::string_view line = take_physical_line();
    if (rules_.continuations && line.ends_with('\\')) {
      joined_.clear();
      while (line.ends_with('\\')) {
        joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
        if (next_ == end_) fail_truncated("the line that a backslash continues");
        line = take_physical_line();
      }
      line = joined_.append(line);
    }
    if (rules_.comment != '\0') line = line.substr(0, line.find(rules_.comment));
    rest_ = line;
    if (!at_line_end()) return true;
  }
  rest_ = {};
  return false;
}

bool TextReader::at_line_end() {
  std::size_t blanks = 0;
  while (blanks < rest_.size() && is_blank(rest_[blanks])) ++blanks;
  rest_.remove_prefix(blanks);
  return rest_.empty();
}

std::string_view TextReader::word() {
  if (at_line_end()) return {};
  std::size_t size = 1;
  while (size < rest_.size() && !is_blank(rest_[size])) ++size;
  const std::string_view found = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return found;
}

std::string_view TextReader::word_across_lines() {
  if (at_line_end() && !next_line()) return {};
  return word();
}

double TextReader::number(std::string_view what) {
  const std::string_view found = word();
  if (found.empty()) fail("the " + std::string(what) + " is missing");
  return to_number(found, what);
}

double TextReader::to_number(std::string_view word, std::string_view what) const {
  const std::string_view digits = without_plus(word);
  double value = 0;
  std::errc error = parse(digits, value);
  if (error == std::errc::result_out_of_range) {
    // Too small or too large for a double; the wider type tells which.
    long double wide = 0;
    error = parse(digits, wide);
    value = static_cast<double>(wide);
    if (error == std::errc::result_out_of_range) {
      fail("the " + std::string(what) + " " + in_quotes(word) + " is beyond the range of numbers");
    }
  }
  if (error != std::errc()) {
    fail("the " + std::string(what) + " " + in_quotes(word) + " is not a number, such as 0.5");
  }
  return value;
}

std::int64_t TextReader::integer(std::string_view what) {
  const std::string_view found = word();
  if (found.empty()) fail("the " + std::string(what) + " is missing");
  return to_integer(found, what);
}

std::int64_t TextReader::to_integer(std::string_view word, std::string_view what) const {
  std::int64_t value = 0;
  if (parse(without_plus(word), value) != std::errc()) {
    fail("the " + std::string(what) + " " + in_quotes(word) + " is not an integer, such as 12");
  }
  return value;
}

std::size_t TextReader::count(std::string_view word, const std::string& what) const {
  const std::int64_t number = to_integer(word, "number of " + what);
  if (number < 0) fail("the number of " + what + " is negative");
  if (to_index(number) == kNone) {
    fail(std::to_string(number) + " " + what + " are more than can be numbered");
  }
  return static_cast<std::size_t>(number);
}

bool TextReader::ends_with_line_end() const {
  // A text without a single line end never moved next_line_ past 2 and cannot be looked back into.
  return next_line_ > 1 && end_ != nullptr && is_line_end(end_[-1]);
}

void TextReader::fail(const std::string& what) const {
  throw MeshError(name_ + ", line " + std::to_string(std::max(line_, 1u)) + ": " + what + remark_);
}

void TextReader::fail_truncated(const std::string& missing) const {
  throw MeshError(name_ + ", line " + std::to_string(next_line_) + ": the file ends before " +
                  missing + ": it is truncated; get a whole copy" + remark_);
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  return "'" + excerpt(word, kLongest) + "'";
}

}  // namespace geodesic
