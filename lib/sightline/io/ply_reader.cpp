/// The Polygon File Format (Turk 1994): a text header that lists elements and their properties, then all elements as
/// text, one a line, or as binary numbers. Of vertices x, y and z are kept, of faces vertex_indices.
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "sightline/io/file_error.h"
#include "sightline/io/polygons.h"
#include "sightline/io/text_reader.h"

namespace sightline {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count_type;  ///< Set for lists.
};

struct Element {
  std::string name;
  std::int64_t count;
  std::vector<Property> properties;
};

struct Header {
  bool is_text = false;
  std::endian order = std::endian::little;
  std::vector<Element> elements;
};

std::string quoted(std::string_view word) { return "\"" + std::string(word.substr(0, 30)) + "\""; }

Type read_type(TextReader& reader) {
  constexpr std::array<std::array<std::string_view, 2>, 8> names = {{{"char", "int8"},
                                                                     {"uchar", "uint8"},
                                                                     {"short", "int16"},
                                                                     {"ushort", "uint16"},
                                                                     {"int", "int32"},
                                                                     {"uint", "uint32"},
                                                                     {"float", "float32"},
                                                                     {"double", "float64"}}};
  const std::string_view found = reader.word();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (found == names[i][0] || found == names[i][1]) return static_cast<Type>(i);
  }
  reader.fail("a type such as float or int32", quoted(found));
}

Header read_header(TextReader& reader) {
  if (!reader.next_filled_line()) reader.fail_at_end("ply");
  if (const auto word = reader.word(); word != "ply") reader.fail("ply", quoted(word));
  Header header;
  bool has_format = false;
  while (true) {
    if (!reader.next_filled_line()) reader.fail_at_end("end_header");
    const std::string_view statement = reader.word();
    if (statement == "end_header") break;
    if (statement == "comment" || statement == "obj_info") continue;
    if (statement == "format") {
      const std::string_view format = reader.word();
      header.is_text = format == "ascii";
      if (format == "binary_big_endian") header.order = std::endian::big;
      if (!header.is_text && format != "binary_little_endian" && format != "binary_big_endian") {
        reader.fail("ascii, binary_little_endian or binary_big_endian", quoted(format));
      }
      has_format = true;
    } else if (statement == "element") {
      const std::string_view name = reader.word();
      header.elements.push_back({std::string(name), reader.integer("the number of elements"), {}});
      if (header.elements.back().count < 0) reader.fail("a number of elements", "a negative one");
    } else if (statement == "property") {
      if (header.elements.empty()) reader.fail("an element before its properties", "a property");
      TextReader ahead = reader;
      Property property;
      if (ahead.word() == "list") {
        reader.word();
        property.count_type = read_type(reader);
        if (*property.count_type >= Type::float32) reader.fail("lists counted by whole numbers", "a float");
      }
      property.type = read_type(reader);
      property.name = reader.word();
      header.elements.back().properties.push_back(property);
    } else {
      reader.fail("format, element, property, comment or end_header", quoted(statement));
    }
  }
  if (!has_format) reader.fail("a format in the header", "none");
  for (const Element& element : header.elements) {
    // What takes no bytes could be there any number of times.
    if (element.properties.empty()) reader.fail("properties of element " + element.name, "none");
  }
  return header;
}

/// The body as text.
class TextBody {
 public:
  explicit TextBody(TextReader& reader) : reader_(reader) {}

  /// False where the file ends instead.
  bool begin() { return reader_.next_filled_line(); }
  void end() {
    if (reader_.has_word()) reader_.fail("the end of the line", quoted(reader_.word()));
  }
  void finish() {
    while (reader_.next_line()) {
      if (reader_.has_word()) reader_.fail("the end of the file", quoted(reader_.word()));
    }
  }
  float number(Type) { return reader_.number("a number"); }
  std::int64_t integer(Type) { return reader_.integer("a whole number"); }
  void skip(Type) {
    if (reader_.word().empty()) reader_.fail("a number", "the end of the line");
  }
  [[noreturn]] void fail(const std::string&, const std::string& expected, const std::string& found) {
    reader_.fail(expected, found);
  }

 private:
  TextReader& reader_;
};

/// The body as binary numbers.
class BinaryBody {
 public:
  BinaryBody(const std::filesystem::path& path, std::string_view bytes, std::endian order)
      : path_(path), bytes_(bytes), swapped_(order != std::endian::native) {}

  bool begin() { return !bytes_.empty(); }
  void end() {}
  void finish() {
    if (bytes_.find_first_not_of(std::string_view("\0\r\n ", 4)) == std::string_view::npos) return;
    fail("", "the end of the file", std::to_string(bytes_.size()) + " bytes more");
  }

  float number(Type type) {
    if (type == Type::float32) return take<float>();
    if (type == Type::float64) return static_cast<float>(take<double>());
    return static_cast<float>(integer(type));
  }
  std::int64_t integer(Type type) {
    switch (type) {
      case Type::int8:
        return take<std::int8_t>();
      case Type::uint8:
        return take<std::uint8_t>();
      case Type::int16:
        return take<std::int16_t>();
      case Type::uint16:
        return take<std::uint16_t>();
      case Type::int32:
        return take<std::int32_t>();
      case Type::uint32:
        return take<std::uint32_t>();
      default:
        fail("", "whole numbers in the list of corners", "floats");
    }
  }
  void skip(Type type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    advance(sizes[static_cast<std::size_t>(type)]);
  }
  [[noreturn]] void fail(const std::string& element, const std::string& expected, const std::string& found) {
    throw FileError(path_, 0, expected, element.empty() ? found : found + " in " + element);
  }

 private:
  std::string_view advance(std::size_t count) {
    if (bytes_.size() < count) fail("", "a number of " + std::to_string(count) + " bytes", "the end of the file");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  template <class T>
  T take() {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), advance(sizeof(T)).data(), sizeof(T));
    if (swapped_) {
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
    }
    return std::bit_cast<T>(raw);
  }

  const std::filesystem::path& path_;
  std::string_view bytes_;
  bool swapped_;
};

std::int64_t vertex_count(const Header& header) {
  for (const Element& element : header.elements) {
    if (element.name == "vertex") return element.count;
  }
  return 0;
}

template <class Body>
void read_element(Body& body, const Element& element, std::int64_t number, std::int64_t vertices, Polygons& polygons) {
  const auto name = [&] {
    return element.name + " " + std::to_string(number) + " of " + std::to_string(element.count);
  };
  const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
  Vec3f position(0);
  if (!body.begin()) body.fail("", name(), "the end of the file");
  for (const Property& property : element.properties) {
    if (!property.count_type) {
      const std::size_t axis = property.name.size() == 1 ? std::string_view("xyz").find(property.name) : 3;
      if (is_vertex && axis < 3) {
        position[static_cast<int>(axis)] = body.number(property.type);
      } else {
        body.skip(property.type);
      }
      continue;
    }
    const std::int64_t count = body.integer(*property.count_type);
    if (is_face && (property.name == "vertex_indices" || property.name == "vertex_index")) {
      if (count < 3 || count > most_corners) {
        body.fail(name(), "3 to " + std::to_string(most_corners) + " corners", std::to_string(count));
      }
      for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t index = body.integer(property.type);
        if (index < 0 || index >= vertices) {
          body.fail(name(), "a vertex number below " + std::to_string(vertices), std::to_string(index));
        }
        polygons.corners.push_back(static_cast<std::uint32_t>(index));
      }
      polygons.sizes.push_back(static_cast<std::uint32_t>(count));
    } else {
      for (std::int64_t i = 0; i < count; ++i) body.skip(property.type);
    }
  }
  body.end();
  if (!is_vertex) return;
  if (!is_finite(position)) body.fail(name(), "coordinates finite as floats", "NaN or infinity");
  polygons.positions.push_back(position);
}

template <class Body>
Polygons read_body(Body body, const Header& header) {
  Polygons polygons;
  const std::int64_t vertices = vertex_count(header);
  for (const Element& element : header.elements) {
    for (std::int64_t i = 0; i < element.count; ++i) read_element(body, element, i, vertices, polygons);
  }
  body.finish();
  return polygons;
}

/// Each of these once: a second list of corners or vertices would leave P1 to chance.
void check_elements(const std::filesystem::path& path, const Header& header) {
  const auto check_count = [&](std::int64_t count, const std::string& expected) {
    if (count != 1) throw FileError(path, 0, expected + " in the header", count == 0 ? "none" : std::to_string(count));
  };
  std::int64_t vertex_elements = 0, face_elements = 0, lists = 0, coordinates[3] = {};
  for (const Element& element : header.elements) {
    vertex_elements += element.name == "vertex";
    face_elements += element.name == "face";
    for (const Property& property : element.properties) {
      const bool is_list = property.count_type.has_value();
      lists +=
          element.name == "face" && is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
      for (std::size_t axis = 0; axis < 3; ++axis) {
        coordinates[axis] += element.name == "vertex" && !is_list && property.name == "xyz"[axis] + std::string();
      }
    }
  }
  check_count(vertex_elements, "one element vertex");
  for (std::size_t axis = 0; axis < 3; ++axis)
    check_count(coordinates[axis], std::string("one property ") + "xyz"[axis]);
  check_count(face_elements, "one element face");
  check_count(lists, "one property list vertex_indices");
  if (vertex_count(header) > std::numeric_limits<std::uint32_t>::max()) {
    throw FileError(path, 0, "at most 2^32 - 1 vertices", std::to_string(vertex_count(header)));
  }
}

}  // namespace

Polygons read_ply(const std::filesystem::path& path, std::string_view bytes) {
  TextReader reader(path, bytes);
  const Header header = read_header(reader);
  check_elements(path, header);
  if (header.is_text) return read_body(TextBody(reader), header);
  return read_body(BinaryBody(path, bytes.substr(reader.offset()), header.order), header);
}

}  // namespace sightline
