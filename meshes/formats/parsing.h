// The parsers of mesh_file.h, one source file per format, and their common parts: words and numbers
// of text files, with their positions for messages, and numbers of binary files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "meshes/formats/bytes.h"
#include "meshes/mesh_file.h"

namespace geodesic {

// Each parser takes the contents of a whole file and throws MeshError.
MeshFile parse_obj(std::string_view text, const std::string& name);
MeshFile parse_off(std::string_view text, const std::string& name);
MeshFile parse_ply(std::string_view bytes, const std::string& name);
MeshFile parse_stl_ascii(std::string_view text, const std::string& name);
MeshFile parse_stl_binary(std::string_view bytes, const std::string& name);

/// Returns whether the size of the file is that of a binary STL file with the triangle count in it.
bool has_size_of_binary_stl(std::string_view bytes);

/// The text of a file that a user wrote: its bytes without the byte order mark of UTF-8 that some
/// editors put first.
/// @param name the file's name, for the message
/// @throws MeshError for the byte order marks of UTF-16
std::string_view text_of(std::string_view bytes, const std::string& name);

struct TextRules {
  char comment = '\0';         ///< starts a comment up to the end of the line; '\0': none
  bool continuations = false;  ///< a backslash at the end of a line joins the next one to it
};

/// Reads a text line by line and word by word. Lines end with LF, CR LF or CR.
class TextReader {
 public:
  /// @param name the file's name, for messages
  TextReader(std::string_view text, std::string name, TextRules rules = {});

  /// Moves to the next line that is not blank. @return false at the end of the text
  bool next_line();
  /// The next word of the line; empty when there is none left.
  std::string_view word();
  /// The next word of the text, moving on to later lines; empty at the end of the text.
  std::string_view word_across_lines();
  /// Whether no word is left on the line.
  bool at_line_end();

  /// The next word of the line as the nearest double ("nan" and "inf" included).
  /// @param what the expected number, for the message: "x coordinate"
  double number(std::string_view what);
  double to_number(std::string_view word, std::string_view what) const;
  std::int64_t integer(std::string_view what);
  std::int64_t to_integer(std::string_view word, std::string_view what) const;

  /// A word as a number of elements. @param what plural: "vertices"
  std::size_t count(std::string_view word, const std::string& what) const;

  /// Line number from 1, of the line that `next_line` moved to.
  std::uint32_t line() const { return line_; }
  /// Number of bytes of the text after the line.
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - next_); }
  /// Whether the last byte of the text ends a line, as in a file that was written completely.
  bool ends_with_line_end() const;

  /// Appends a remark to every later message.
  void add_to_messages(const std::string& remark) { remark_ += remark; }
  /// @throws MeshError "<name>, line <line>: <what>"
  [[noreturn]] void fail(const std::string& what) const;
  /// @throws MeshError with the message that the file ends before `missing`
  [[noreturn]] void fail_truncated(const std::string& missing) const;

 private:
  std::string_view take_physical_line();

  std::string name_;
  std::string remark_;
  TextRules rules_;
  const char* next_;  // first byte after the line
  const char* end_;
  const char* line_feed_;        // next one from next_ on; before next_: not found yet
  const char* carriage_return_;  // likewise
  std::string_view rest_;        // rest of the line
  std::string joined_;           // a line with its continuations
  std::uint32_t line_ = 0;
  std::uint32_t next_line_ = 1;
};

/// Warning for a text that does not end with a line end.
inline constexpr const char* kNoLineEnd =
    "the last line has no line end: if the file was cut off there, its last number may be wrong "
    "and more may be missing";

/// Returns a word of a file between quotes, shortened and without control characters.
std::string in_quotes(std::string_view word);

/// Converts an index of a file to an Index. Negative and huge ones become kNone, which is out of
/// range in every mesh.
inline Index to_index(std::int64_t index) {
  return index < 0 || index >= static_cast<std::int64_t>(kNone) ? kNone : static_cast<Index>(index);
}

}  // namespace geodesic
