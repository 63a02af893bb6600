#include "harness/base/schema.h"

#include <regex.h>

#include <algorithm>
#include <map>
#include <set>

#include "harness/base/error.h"

namespace geodesic::harness {
namespace {

// A POSIX extended expression. Compiling it takes longer than matching a text of usual length.
class Pattern {
 public:
  explicit Pattern(const std::string& pattern) {
    regcomp(&compiled_, pattern.c_str(), REG_EXTENDED | REG_NOSUB);
  }
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;
  ~Pattern() { regfree(&compiled_); }

  bool matches(const std::string& text) const {
    return regexec(&compiled_, text.c_str(), 0, nullptr, 0) == 0;
  }

 private:
  regex_t compiled_{};
};

bool is_type(const Json& value, const Json& type) {
  return type == value.type_name() || (type == "integer" && value.is_number_integer());
}

// Null if the schema lacks the keyword.
const Json& keyword(const Json& schema, const char* name) {
  static const Json none;
  return schema.contains(name) ? schema[name] : none;
}

std::string expectation(const Json& schema) {
  if (schema.contains("must_be")) return schema["must_be"];
  if (schema.contains("const")) return schema["const"].dump();
  if (schema.contains("enum")) return "one of " + join(schema["enum"]);
  return std::map<std::string, std::string>{
      {"array", "a list"}, {"number", "a number"}, {"object", "an object"}, {"string", "text"}}
      .at(schema["type"]);
}

[[noreturn]] void must_be(const std::string& what, const Json& value) {
  throw HarnessError("must be " + what + ", not " + shown(value));
}

class Checker {
 public:
  using Names = std::set<std::string>;

  explicit Checker(const Json& root) : root_(root) {}

  /// @return the keys that the schema has properties for
  Names check(const Json& value, const Json& schema) const {
    Names known;
    if (schema == false) throw HarnessError("must be left out");
    if (schema.contains("$ref")) {
      const std::string reference = schema["$ref"];  // "#/$defs/name"
      known = check(value, root_.at(Json::json_pointer(reference.substr(1))));
    }
    if (value.is_string()) check_text(value);
    if (!fits(value, schema)) must_be(expectation(schema), value);
    if (value.is_array()) check_items(value, schema);
    if (value.is_object()) known.merge(check_members(value, schema));
    for (const Json& part : keyword(schema, "allOf")) known.merge(check(value, part));
    if (schema.contains("if")) {
      const char* branch = holds(value, schema["if"]) ? "then" : "else";
      if (schema.contains(branch)) known.merge(check(value, schema[branch]));
    }
    if (schema.contains("unevaluatedProperties")) refuse_others(value, known);
    return known;
  }

 private:
  // Whether the keywords that apply to a value as a whole hold.
  bool fits(const Json& value, const Json& schema) const {
    for (const auto& [keyword, said] : schema.items()) {
      if (!fits(value, keyword, said)) return false;
    }
    return true;
  }

  // @param said the schema's value of the keyword
  bool fits(const Json& value, const std::string& keyword, const Json& said) const {
    if (keyword == "const") return value == said;
    if (keyword == "enum") return std::ranges::find(said, value) != said.end();
    if (keyword == "maximum") return !value.is_number() || value <= said;
    if (keyword == "minimum") return !value.is_number() || value >= said;
    if (keyword == "pattern" && value.is_string()) {
      return patterns_.try_emplace(said, said.get<std::string>()).first->second.matches(value);
    }
    if (keyword != "type") return true;
    if (!said.is_array()) return is_type(value, said);
    return std::ranges::any_of(said, [&](const Json& type) { return is_type(value, type); });
  }

  bool holds(const Json& value, const Json& schema) const {
    try {
      check(value, schema);
    } catch (const HarnessError&) {
      return false;
    }
    return true;
  }

  static void refuse_others(const Json& object, const Names& known) {
    for (const auto& [name, value] : object.items()) {
      if (!known.contains(name)) {
        throw HarnessError(unknown_name("key", name, {known.begin(), known.end()}));
      }
    }
  }

  static void check_text(const std::string& text) {
    if (harmless(text) != text) must_be("text without control characters", text);
  }

  void check_items(const Json& list, const Json& schema) const {
    if (list.empty() && schema.contains("minItems")) throw HarnessError("must not be empty");
    const Json& items = keyword(schema, "items");
    std::set<Json> seen;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Json name = list[i].is_object() ? list[i].value("name", Json()) : Json();
      at_place(name.is_string() ? name.get<std::string>() : std::to_string(i),
               [&] { check(list[i], items); });
      if (schema.contains("uniqueItems") && !seen.insert(list[i]).second) {
        throw HarnessError(shown(list[i]) + " is listed twice");
      }
    }
  }

  static void require(const Json& object, const Json& names) {
    for (const Json& name : names) {
      if (!object.contains(name)) {
        throw HarnessError("key '" + name.get<std::string>() + "' is missing");
      }
    }
  }

  Names check_members(const Json& object, const Json& schema) const {
    if (object.empty() && schema.contains("minProperties")) throw HarnessError("must not be empty");
    Names known;
    for (const auto& [name, of_it] : keyword(schema, "properties").items()) known.insert(name);
    const Json& others = keyword(schema, "additionalProperties");
    if (others == false) refuse_others(object, known);
    require(object, keyword(schema, "required"));
    for (const auto& [name, needed] : keyword(schema, "dependentRequired").items()) {
      if (object.contains(name)) require(object, needed);
    }
    for (const auto& [name, value] : object.items()) {
      at_place(name, [&, &key = name, &each = value] {
        if (schema.contains("propertyNames")) check(key, schema["propertyNames"]);
        if (known.contains(key)) check(each, schema["properties"][key]);
        if (!known.contains(key) && others.is_object()) check(each, others);
      });
    }
    return known;
  }

  const Json& root_;
  mutable std::map<std::string, Pattern> patterns_ = {};
};

}  // namespace

void check_schema(const Json& value, const Json& schema) { Checker(schema).check(value, schema); }

}  // namespace geodesic::harness
